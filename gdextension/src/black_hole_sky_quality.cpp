// SPDX-License-Identifier: MIT
// What trades the picture of a BlackHoleSky for time: which stars are drawn, how often and how.
#include "src/black_hole_sky.h"

#include <algorithm>

#include "src/property_limits.h"

using namespace godot;

template <typename Value>
void BlackHoleSky::set_quality(Value &kept, Value value) {
	if (kept == value) {
		return;
	}
	kept = value;
	settings_changed();
	emit_signal("quality_changed");
}

void BlackHoleSky::set_magnitude_limit(double magnitude) {
	set_quality(magnitude_limit, limited(magnitude, -30.0, 99.0, magnitude_limit));
}

void BlackHoleSky::set_faint_limit(double luminance) {
	set_quality(faint_limit, limited(luminance, 1e-9, 1.0, faint_limit));
}

void BlackHoleSky::set_image_orders(int orders) {
	set_quality(image_orders, std::clamp(orders, 1, StarLayer::kMaxOrders));
}

void BlackHoleSky::set_higher_orders(bool shown) {
	set_quality(higher_orders, shown);
}

void BlackHoleSky::set_psf_model(PointSpreadModel model) {
	set_quality(psf_model, std::clamp(model, PSF_GAUSSIAN, PSF_EYE));
}
