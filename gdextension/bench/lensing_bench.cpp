// SPDX-License-Identifier: MIT
// How fast the exact solution and the tables are, on one core. items_per_second of exact_phi is the number of
// exact orbital angles a second; cpu_time of bake_tables is the time of both tables.
#include "core/relativity/baseline.h"
#include "core/relativity/image_direction.h"
#include "core/relativity/orbital_angle.h"
#include "core/relativity/star_image.h"
#include "core/tables/lensing_tables.h"
#include "core/tables/shader_lensing.h"
#include "core/tables/table_file.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace blackhole;

struct Ray {
	double u;
	double phi;
	double y;
};

/// Rays over the tables' whole range, in an order that does not favour the branch predictor.
const std::vector<Ray> &rays() {
	static const std::vector<Ray> all = [] {
		std::vector<Ray> list;
		constexpr int kCount = 4096;
		for (int i = 0; i < kCount; ++i) {
			const double part = std::fmod(i * 0.6180339887498949, 1.0);
			const double u = std::exp(std::log(1e-8) + part * std::log(25.0 / 1e-8));
			const double phi = 25.0 * (i + 0.5) / kCount;
			list.push_back({u, phi, image_direction(u, phi).y});
		}
		return list;
	}();
	return all;
}

/// Runs `function` on one ray after the other.
template <class Function>
void over_rays(benchmark::State &state, Function function) {
	const std::vector<Ray> &list = rays();
	std::size_t i = 0;
	for (auto _ : state) {
		benchmark::DoNotOptimize(function(list[i]));
		i = i + 1 == list.size() ? 0 : i + 1;
	}
	state.SetItemsProcessed(state.iterations());
}

const LensingTables &tables() {
	static const LensingTables baked = bake_lensing_tables();
	return baked;
}

void exact_phi(benchmark::State &state) {
	over_rays(state, [](const Ray &ray) { return orbital_angle(ray.u, ray.y); });
}
BENCHMARK(exact_phi);

void exact_phi_with_slopes(benchmark::State &state) {
	over_rays(state, [](const Ray &ray) { return orbital_angle_slopes(ray.u, ray.y).slope_u; });
}
BENCHMARK(exact_phi_with_slopes);

void exact_inverse(benchmark::State &state) {
	over_rays(state, [](const Ray &ray) { return image_direction(ray.u, ray.phi).y; });
}
BENCHMARK(exact_inverse);

void exact_star_image(benchmark::State &state) {
	over_rays(state, [](const Ray &ray) {
		const auto image = star_image(glm::dvec3(0.0, 0.0, 1.0 / ray.u),
				glm::dvec3(std::sin(ray.phi), 0.0, std::cos(ray.phi)), 1, ObserverMotion::kRain);
		return image.value->magnification;
	});
}
BENCHMARK(exact_star_image);

void table_inverse(benchmark::State &state) {
	const ShaderLensing shader(tables());
	over_rays(state, [&shader](const Ray &ray) { return shader.ray_of_angle(ray.u, ray.phi).sigma; });
}
BENCHMARK(table_inverse);

void table_forward(benchmark::State &state) {
	const ShaderLensing shader(tables());
	over_rays(state, [&shader](const Ray &ray) { return shader.angle_of_ray(ray.u, ray.y).phi; });
}
BENCHMARK(table_forward);

void bake_tables(benchmark::State &state) {
	for (auto _ : state) {
		benchmark::DoNotOptimize(bake_lensing_tables().inverse.data());
	}
}
BENCHMARK(bake_tables)->Unit(benchmark::kMillisecond);

void read_table_file(benchmark::State &state) {
	const std::vector<std::uint8_t> bytes = write_lensing_tables(tables());
	for (auto _ : state) {
		benchmark::DoNotOptimize(read_lensing_tables(bytes, "bench").value->columns);
	}
}
BENCHMARK(read_table_file)->Unit(benchmark::kMillisecond);

} // namespace
