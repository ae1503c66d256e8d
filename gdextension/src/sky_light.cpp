// SPDX-License-Identifier: MIT
#include "src/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include <glm/common.hpp>

using namespace godot;

namespace {

constexpr int kColumns = 256; // of the panorama that is averaged: 4 texels a cell's side
constexpr int kRows = 128;
constexpr int kFaceTexels = 64; // of a cube map, a side

/// Pictures of 8 bits hold sRGB values, those of floats linear ones: as the shader's sampler takes them.
bool is_linear(const Ref<Image> &image) {
	return image->get_format() >= Image::FORMAT_RF && image->get_format() <= Image::FORMAT_RGBE9995;
}

float linear_from_srgb(float value) {
	return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

/// Linear RGB of a picture, row by row, resized; empty where it cannot be read.
std::vector<float> linear_texels(const Ref<Image> &stored, int columns, int rows) {
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
	image->resize(columns, rows, Image::INTERPOLATE_TRILINEAR);
	image->convert(Image::FORMAT_RGBF);
	const PackedFloat32Array values = image->get_data().to_float32_array();
	// A chain of smaller pictures may follow.
	const int64_t wanted = int64_t{3} * columns * rows;
	if (values.size() < wanted) {
		return {};
	}
	std::vector<float> rgb(values.ptr(), values.ptr() + wanted);
	if (!linear) {
		for (float &value : rgb) {
			value = linear_from_srgb(value);
		}
	}
	return rgb;
}

blackhole::SkyBrightness light_of(const Ref<Texture2D> &texture) {
	const std::vector<float> rgb = linear_texels(texture->get_image(), kColumns, kRows);
	return rgb.empty() ? blackhole::SkyBrightness()
					   : blackhole::SkyBrightness::of_panorama(rgb.data(), kColumns, kRows);
}

/// The direction (sky axes) at the middle of a texel of the panorama that is averaged.
glm::dvec3 panorama_direction(int column, int row) {
	const double right_ascension = 2.0 * std::numbers::pi * (0.25 - (column + 0.5) / kColumns);
	const double declination = std::numbers::pi * (0.5 - (row + 0.5) / kRows);
	return {std::cos(declination) * std::cos(right_ascension), std::sin(declination),
			-std::cos(declination) * std::sin(right_ascension)};
}

/// Which texel of a cube map lies in a direction: face, then row by row (Vulkan 1.3, "Cube Map Face Selection
/// and Transformations").
struct CubeTexel {
	std::size_t face = 0;
	std::size_t index = 0;
};

CubeTexel cube_texel(const glm::dvec3 &d) {
	const glm::dvec3 size = glm::abs(d);
	const auto of_face = [](std::size_t face, double s, double t, double along) {
		const auto whole = [along](double value) {
			const int texel = static_cast<int>(0.5 * (value / along + 1.0) * kFaceTexels);
			return static_cast<std::size_t>(std::clamp(texel, 0, kFaceTexels - 1));
		};
		return CubeTexel{face, whole(t) * kFaceTexels + whole(s)};
	};
	if (size.z >= size.x && size.z >= size.y) {
		return d.z < 0.0 ? of_face(5, -d.x, -d.y, size.z) : of_face(4, d.x, -d.y, size.z);
	}
	if (size.y >= size.x) {
		return d.y < 0.0 ? of_face(3, d.x, -d.z, size.y) : of_face(2, d.x, d.z, size.y);
	}
	return d.x < 0.0 ? of_face(1, d.z, -d.y, size.x) : of_face(0, -d.z, -d.y, size.x);
}

/// As a panorama.
blackhole::SkyBrightness light_of(const Ref<Cubemap> &cubemap) {
	std::array<std::vector<float>, 6> faces;
	for (std::size_t face = 0; face < faces.size(); ++face) {
		faces.at(face) =
				linear_texels(cubemap->get_layer_data(static_cast<int>(face)), kFaceTexels, kFaceTexels);
		if (faces.at(face).empty()) {
			return {};
		}
	}
	std::vector<float> rgb;
	rgb.reserve(std::size_t{3} * kColumns * kRows);
	for (int row = 0; row < kRows; ++row) {
		for (int column = 0; column < kColumns; ++column) {
			const CubeTexel at = cube_texel(panorama_direction(column, row));
			const float *texel = faces.at(at.face).data() + 3 * at.index;
			rgb.insert(rgb.end(), texel, texel + 3);
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
	panorama_shown = sources.panorama.is_valid() || sources.cubemap.is_valid();
	panorama_luminance = sources.panorama_luminance;
	panorama_is_light = sources.panorama_is_light;
	if (panorama_shown) {
		const uint64_t texture = sources.panorama.is_valid() ? sources.panorama->get_instance_id()
															 : sources.cubemap->get_instance_id();
		if (panorama == nullptr || panorama->texture != texture) {
			panorama = std::make_unique<PanoramaMap>(PanoramaMap{texture,
					sources.panorama.is_valid() ? light_of(sources.panorama) : light_of(sources.cubemap)});
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
