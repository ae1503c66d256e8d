// SPDX-License-Identifier: MIT
#include "src/sky_light.h"

#include <cmath>
#include <vector>

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

using namespace godot;

namespace {

constexpr int kColumns = 256; // of the panorama that is averaged: 4 texels a cell's side
constexpr int kRows = 128;

/// Pictures of 8 bits hold sRGB values, those of floats linear ones: as the shader's sampler takes them.
bool is_linear(const Ref<Image> &image) {
	return image->get_format() >= Image::FORMAT_RF && image->get_format() <= Image::FORMAT_RGBE9995;
}

float linear_from_srgb(float value) {
	return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

blackhole::SkyBrightness light_of(const Ref<Texture2D> &texture) {
	const Ref<Image> stored = texture->get_image();
	if (stored.is_null() || stored->is_empty()) {
		return {};
	}
	// A copy: some textures hand out the picture that they keep.
	const Ref<Image> image = Image::create_from_data(stored->get_width(), stored->get_height(),
			stored->has_mipmaps(), stored->get_format(), stored->get_data());
	if (image->is_compressed() && image->decompress() != OK) {
		return {};
	}
	const bool linear = is_linear(image);
	image->resize(kColumns, kRows, Image::INTERPOLATE_TRILINEAR);
	image->convert(Image::FORMAT_RGBF);
	const PackedFloat32Array values = image->get_data().to_float32_array();
	// A chain of smaller pictures may follow.
	constexpr int64_t kValues = int64_t{3} * kColumns * kRows;
	if (values.size() < kValues) {
		return {};
	}
	std::vector<float> rgb(values.ptr(), values.ptr() + kValues);
	if (!linear) {
		for (float &value : rgb) {
			value = linear_from_srgb(value);
		}
	}
	return blackhole::SkyBrightness::of_panorama(rgb.data(), kColumns, kRows);
}

} // namespace

void SkyLight::use(const Sources &sources) {
	if (planck == nullptr) {
		planck = std::make_unique<blackhole::PlanckTable>();
	}
	stars_shown = sources.stars != nullptr;
	if (stars_shown &&
			(stars == nullptr || stars->table != sources.stars ||
					stars->magnitude_limit != sources.magnitude_limit)) {
		stars = std::make_unique<StarMap>(StarMap{sources.stars, sources.magnitude_limit,
				blackhole::SkyBrightness::of_stars(*sources.stars, sources.magnitude_limit)});
	}
	panorama_shown = sources.panorama.is_valid();
	panorama_luminance = sources.panorama_luminance;
	panorama_is_light = sources.panorama_is_light;
	if (panorama_shown) {
		const uint64_t texture = sources.panorama->get_instance_id();
		if (panorama == nullptr || panorama->texture != texture) {
			panorama = std::make_unique<PanoramaMap>(PanoramaMap{texture, light_of(sources.panorama)});
		}
	}
}

double SkyLight::shifted(const blackhole::SkyBrightness::Light &light, double shift) const {
	if (!(light.luminance > 0.0F)) {
		return 0.0;
	}
	const double before = planck->log2_luminance(light.temperature);
	return light.luminance * std::exp2(planck->log2_luminance(light.temperature * shift) - before);
}

double SkyLight::luminance(const glm::dvec3 &direction, double shift) const {
	double sum = 0.0;
	if (stars_shown) {
		sum += shifted(stars->light.at(direction), shift);
	}
	if (panorama_shown) {
		sum += panorama_luminance * shifted(panorama->light.at(direction), panorama_is_light ? shift : 1.0);
	}
	return sum;
}
