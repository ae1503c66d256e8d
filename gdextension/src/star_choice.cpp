// SPDX-License-Identifier: MIT
#include "src/star_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/culling/image_bound.h"
#include "core/photometry/radiometry.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kNearest = 1e-6; // r_s; the shader looks no closer

/// One eye's view of one order of images.
struct View {
	blackhole::ImageBound bound;
	double limit = 0.0; ///< faintest magnitude that this eye sees without lensing
	double slack = 0.0; ///< rad
};

/// The observer in the axes of the star groups.
blackhole::ObserverField sky_axes(const SkySettings &settings) {
	const Basis to_sky = settings.sky_to_world.transposed();
	blackhole::ObserverField observer = settings.observer;
	observer.axis = to_glm(to_sky.xform(to_godot(observer.axis)));
	observer.celerity = to_glm(to_sky.xform(to_godot(observer.celerity)));
	return observer;
}

View view_of(const WatchingEye &eye, int order, const SkySettings &settings,
		const blackhole::LensingTables &tables) {
	const Vector3 offset = to_godot(eye.place) - settings.hole_position;
	glm::dvec3 position = to_glm(settings.sky_to_world.transposed().xform(offset)) * settings.inverse_radius;
	const double distance = glm::length(position);
	if (!(distance > kNearest)) {
		position = glm::dvec3(0.0, 0.0, kNearest);
	}
	const glm::dvec3 inward = distance > kNearest ? -to_glm(offset.normalized()) : eye.axis;
	const blackhole::LocalObserver observer = blackhole::drawn_observer(position, sky_axes(settings));
	const bool boosted = observer.celerity != glm::dvec3(0.0);
	// A boost carries images elsewhere in the picture: then every place in it counts.
	View view{blackhole::ImageBound(observer, order, tables,
			[&eye, &inward, boosted](double xi) { return eye.pixel_gain(inward, boosted ? kTwoPi : xi); })};
	const double peak_gain = blackhole::kStarGain * settings.exposure /
			(kTwoPi * settings.psf_sigma * settings.psf_sigma * StarLayer::faint_limit(settings, order));
	view.limit = 2.5 * std::log10(peak_gain);
	if (eye.wobble > 0.0) {
		view.slack = std::asin(std::min(1.0, eye.wobble * settings.inverse_radius / distance));
	}
	return view;
}

} // namespace

void choose_stars(StarLayer &layer, const SkySettings &settings, const std::vector<WatchingEye> &eyes,
		const blackhole::LensingTables &tables) {
	const std::vector<blackhole::StarGroup> &groups = layer.star_groups();
	std::vector<View> views;
	views.reserve(eyes.size());
	for (int order = 0; order < settings.image_orders; ++order) {
		views.clear();
		for (const WatchingEye &eye : eyes) {
			views.push_back(view_of(eye, order, settings, tables));
		}
		// Most direct images can be seen as a rule: then the groups need not be asked one by one.
		// The bounds are for perspective pictures with every effect.
		const bool unbounded = settings.projection != 0 || settings.effects != lensing_shader::kAllEffects;
		const bool all = unbounded || std::any_of(views.begin(), views.end(), [&layer](const View &view) {
			return view.limit + view.bound.least_brightening() >= layer.faintest();
		});
		for (std::size_t g = 0; g < groups.size(); ++g) {
			if (all) {
				layer.set_faintest(order, g, std::numeric_limits<double>::infinity());
				continue;
			}
			double faintest = -std::numeric_limits<double>::infinity();
			for (const View &view : views) {
				faintest = std::max(faintest, view.limit + view.bound.brightening(groups[g], view.slack));
			}
			layer.set_faintest(order, g, faintest);
		}
	}
}
