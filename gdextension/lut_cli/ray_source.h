// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/image_direction.h"
#include "core/relativity/observer.h"
#include "core/relativity/orbital_angle.h"
#include "core/tables/shader_disk.h"
#include "core/tables/shader_lensing.h"

namespace blackhole {

/// A viewing direction of an observer and a disk: inclination and azimuth as in core/disk/disk_crossing.h, xi
/// [rad] from the hole in the observer's own frame.
struct DiskView {
	double u = 0.0;
	double inclination = 0.0;
	double xi = 0.0;
	double azimuth = 0.0;
	ObserverMotion motion = ObserverMotion::kStatic;
};

/// Where it meets the disk: radius [r_s] and nu_observed/nu_emitted of gas on the circular orbit there; nan
/// where it does not, or where there is no such orbit.
struct DiskMeeting {
	double r;
	double redshift;
};

/// Where light rays come from: the exact solution or the tables. Everything else (angles, magnification,
/// redshift) follows from these two functions.
class RaySource {
public:
	RaySource() = default;
	RaySource(const RaySource &) = delete;
	RaySource &operator=(const RaySource &) = delete;
	virtual ~RaySource() = default;

	/// The ray that sweeps phi [rad] from infinity to the observer at u = r_s/r.
	[[nodiscard]] virtual ImageDirection image(double u, double phi) const = 0;
	/// Orbital angle and its slope in y of the ray sigma = sigma_c + y.
	[[nodiscard]] virtual OrbitalAngle angle(double u, double y) const = 0;
	/// The meeting of this order with the disk.
	[[nodiscard]] virtual DiskMeeting disk(const DiskView &view, int order) const = 0;
};

/// The exact solution in double precision.
class ExactRays final : public RaySource {
public:
	[[nodiscard]] ImageDirection image(double u, double phi) const override {
		return image_direction(u, phi);
	}
	[[nodiscard]] OrbitalAngle angle(double u, double y) const override { return orbital_angle_slope(u, y); }
	[[nodiscard]] DiskMeeting disk(const DiskView &view, int order) const override;
};

/// The float32 tables, read by the shader's own code.
class TabulatedRays final : public RaySource {
public:
	/// The tables must outlive this object.
	explicit TabulatedRays(const LensingTables &tables) : shader(tables), disk_shader(tables) {}

	[[nodiscard]] ImageDirection image(double u, double phi) const override;
	[[nodiscard]] OrbitalAngle angle(double u, double y) const override;
	[[nodiscard]] DiskMeeting disk(const DiskView &view, int order) const override;

private:
	ShaderLensing shader;
	ShaderDisk disk_shader;
};

} // namespace blackhole
