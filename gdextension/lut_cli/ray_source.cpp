// SPDX-License-Identifier: MIT
#include "lut_cli/ray_source.h"

#include "core/disk/disk_crossing.h"
#include "core/relativity/light_ray.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/redshift.h"
#include "core/relativity/view_angle.h"

#include <algorithm>
#include <cmath>

namespace blackhole {
namespace {

/// sigma - sigma_c of its ray.
double clearance(const DiskView &view) {
	const bool rests = view.motion == ObserverMotion::kStatic;
	return rests ? static_sigma_offset(view.u, view.xi) : rain_sigma_offset(view.u, view.xi);
}

} // namespace

DiskMeeting ExactRays::disk(const DiskView &view, int order) const {
	const double y = clearance(view);
	const double r = disk_crossing({view.u, y, view.inclination, view.azimuth}, order).radius;
	const double observed = radial_redshift(view.u, y, radial_kappa(view.u, view.motion));
	const double a = LightRay<double>(view.u, y).a;
	return {r, observed * disk_redshift(r, a, view.inclination, view.azimuth)};
}

DiskMeeting TabulatedRays::disk(const DiskView &view, int order) const {
	// The hole below (-z), N towards +x and up, azimuths against the sense of x to y: right x up = outward.
	const glm::dvec3 azimuth(std::cos(view.azimuth), -std::sin(view.azimuth), 0.0);
	const glm::dvec3 normal(std::sin(view.inclination), 0.0, std::cos(view.inclination));
	ObserverField observer;
	observer.motion = view.motion;
	const ShaderDisk::Crossing found = disk_shader.crossing_of_ray(
			view.u, clearance(view), glm::vec3(azimuth), glm::vec3(normal), order, observer);
	const double u = found.inverse_radius;
	if (!found.reached || !(u > 0.0 && u <= std::max(1.0, view.u))) {
		return {kNaN, kNaN};
	}
	return {1.0 / u, u < 2.0 / 3.0 ? double{found.redshift} : kNaN};
}

ImageDirection TabulatedRays::image(double u, double phi) const {
	const ShaderLensing::Ray ray = shader.ray_of_angle(u, phi);
	return {ray.clearance, ray.slope};
}

OrbitalAngle TabulatedRays::angle(double u, double y) const {
	if (!(y > 0.0)) { // captured
		return {kNaN, kNaN, kNaN};
	}
	const ShaderLensing::Angle result = shader.angle_of_ray(u, y);
	return {result.phi, result.slope, 0.0};
}

} // namespace blackhole
