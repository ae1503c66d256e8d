// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/image_direction.h"

namespace blackhole {

/// Magnification mu = |sin xi dxi / (sin phi dphi)| of a point star at infinity: solid angle of its image
/// over its solid angle without the hole, in the frame of a radially moving observer with the given kappa.
/// sin_phi = |sin| of the star's angle from the outward radial; infinite on the caustic sin_phi = 0. Under a
/// boost with Doppler factor D, mu becomes mu/D^2; mu g^2 is the same in every frame.
double radial_magnification(double u, ImageDirection image, double kappa, double sin_phi);

} // namespace blackhole
