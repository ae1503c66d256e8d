// SPDX-License-Identifier: MIT
#include "src/star_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/photometry/radiometry.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Reserves beyond these would have too many stars drawn: eyes that fast are chosen for in each frame.
constexpr double kLargestReserve = 0.2; // rad
/// Part of its distance from the hole, or from the horizon, by which an eye may come nearer or go away. The
/// brightness of images goes with the square of the distance or, where they crowd, with a lower power.
constexpr double kRadialReserve = 0.003;
constexpr double kRadialGain = 0.02;  // magnitudes, for that
constexpr double kRadialShift = 0.01; // rad, by which it moves images at most

/// The observer in the axes of the star groups.
blackhole::ObserverField sky_axes(const SkySettings &settings) {
	const Basis to_sky = settings.sky_to_world.transposed();
	blackhole::ObserverField observer = settings.observer;
	observer.axis = to_glm(to_sky.xform(to_godot(observer.axis)));
	observer.celerity = to_glm(to_sky.xform(to_godot(observer.celerity)));
	return observer;
}

bool is_bounded(const SkySettings &settings) {
	// The bounds are for perspective pictures with every effect.
	return settings.projection == 0 && settings.effects == lensing_shader::kAllEffects;
}

/// From the hole, world units.
glm::dvec3 offset_of(const WatchingEye &eye, const SkySettings &settings) {
	return eye.place - to_glm(settings.hole_position);
}

bool has_equal_lens(const WatchingEye &a, const WatchingEye &b) {
	return a.axis_gain == b.axis_gain && a.corner_cosine == b.corner_cosine && a.wobble == b.wobble &&
			a.everywhere == b.everywhere;
}

/// How an eye has moved between two frames.
struct Movement {
	double turn;        ///< round the hole, radians
	double aim;         ///< change of the angle between viewing axis and hole, radians
	double radial_part; ///< change of the distance as a part of that from hole or horizon
};

Movement movement(const WatchingEye &from, const WatchingEye &to, const SkySettings &settings) {
	const glm::dvec3 a = offset_of(from, settings);
	const glm::dvec3 b = offset_of(to, settings);
	const double r_a = glm::length(a);
	const double r_b = glm::length(b);
	const double horizon = 1.0 / settings.inverse_radius;
	const double room = std::min({r_a, r_b, std::abs(r_a - horizon), std::abs(r_b - horizon)});
	if (!(room > kNearestPlace * horizon)) {
		return {kTwoPi, kTwoPi, kInfinity};
	}
	const glm::dvec3 out_a = a / r_a;
	const glm::dvec3 out_b = b / r_b;
	const double turn = 2.0 * std::asin(std::min(1.0, 0.5 * glm::length(out_a - out_b)));
	const double aim = std::abs(std::acos(std::clamp(glm::dot(from.axis, out_a), -1.0, 1.0)) -
			std::acos(std::clamp(glm::dot(to.axis, out_b), -1.0, 1.0)));
	return {turn, aim, std::abs(r_a - r_b) / room};
}

} // namespace

StarChoice::View StarChoice::view_of(const WatchingEye &eye, int order, const SkySettings &settings,
		const blackhole::LensingTables &tables, const Reserve &reserve) {
	const glm::dvec3 place = place_in_radii(settings, eye.place);
	const double distance = glm::length(place);
	const glm::dvec3 inward = distance > kNearestPlace ? -place / distance : eye.axis;
	const glm::dvec3 position = to_glm(settings.sky_to_world.transposed().xform(to_godot(place)));
	const blackhole::LocalObserver observer = blackhole::drawn_observer(position, sky_axes(settings));
	const bool boosted = observer.celerity != glm::dvec3(0.0);
	// A boost carries images elsewhere in the picture: then every place in it counts.
	const PixelGain gain = eye.pixel_gain(inward);
	const double farther = boosted ? kTwoPi : reserve.aim;
	const double edge = farther + kRadialShift + StarLayer::largest_reach(settings) * eye.pixel_angle();
	View view{blackhole::ImageBound(observer, order, tables, [&gain, farther, edge](double from, double to) {
		return gain.shows(from - edge, to + edge) ? gain(to + farther) : 0.0;
	})};
	const double peak_gain = blackhole::kStarGain * settings.exposure /
			(kTwoPi * settings.psf_sigma * settings.psf_sigma * StarLayer::faint_limit(settings, order));
	view.limit = 2.5 * std::log10(peak_gain) + (reserve == Reserve() ? 0.0 : kRadialGain);
	view.slack = reserve.turn;
	if (eye.wobble > 0.0) {
		view.slack += std::asin(std::min(1.0, eye.wobble * settings.inverse_radius / distance));
	}
	return view;
}

void StarChoice::reset() {
	for (Part &part : parts) {
		part.chosen = false;
	}
}

bool StarChoice::holds(const Part &part, const std::vector<WatchingEye> &eyes, const SkySettings &settings) {
	if (!part.chosen || part.ground.eyes.size() != eyes.size()) {
		return false;
	}
	for (std::size_t i = 0; i < eyes.size(); ++i) {
		if (eyes[i] == part.ground.eyes[i]) {
			continue;
		}
		const Movement moved = movement(part.ground.eyes[i], eyes[i], settings);
		if (!has_equal_lens(part.ground.eyes[i], eyes[i]) || part.ground.reserve == Reserve() ||
				moved.radial_part > kRadialReserve || moved.turn > part.ground.reserve.turn ||
				moved.aim > part.ground.reserve.aim) {
			return false;
		}
	}
	return true;
}

StarChoice::Reserve StarChoice::reserve_for(
		const std::vector<WatchingEye> &eyes, const SkySettings &settings) const {
	Reserve reserve;
	// Bounds for moving observers know their motion's direction, which a turn changes.
	const blackhole::ObserverMotion motion = settings.observer.motion;
	const bool radial =
			motion != blackhole::ObserverMotion::kOrbit && motion != blackhole::ObserverMotion::kVelocity;
	if (!radial || eyes.size() != last_eyes.size() || eyes == last_eyes) {
		return reserve;
	}
	// A view serves the parts of its order in turn, each until its turn comes again.
	const auto per_order = static_cast<double>(parts_per_order(settings));
	const double frames = per_order * (settings.image_orders + 1) + 0.2;
	for (std::size_t i = 0; i < eyes.size(); ++i) {
		const Movement moved = movement(last_eyes[i], eyes[i], settings);
		reserve.turn = std::max(reserve.turn, frames * moved.turn);
		reserve.aim = std::max(reserve.aim, frames * moved.aim);
	}
	constexpr double kLeast = 1e-3;
	reserve.turn = std::max(reserve.turn, kLeast);
	reserve.aim = std::max(reserve.aim, kLeast);
	return reserve.turn <= kLargestReserve && reserve.aim <= kLargestReserve ? reserve : Reserve();
}

std::size_t StarChoice::parts_per_order(const SkySettings &settings) {
	return kMostParts / std::max<std::size_t>(2, static_cast<std::size_t>(settings.image_orders));
}

void StarChoice::look(int order, const SkySettings &settings, const std::vector<WatchingEye> &eyes,
		const blackhole::LensingTables &tables, const Reserve &reserve) {
	Views &looked = views.at(static_cast<std::size_t>(order));
	looked.of_eyes.clear();
	for (const WatchingEye &eye : eyes) {
		looked.of_eyes.push_back(view_of(eye, order, settings, tables, reserve));
	}
	looked.ground.eyes = eyes;
	looked.ground.reserve = reserve;
}

void StarChoice::choose(std::size_t part, StarLayer &layer, const SkySettings &settings) {
	const std::vector<blackhole::StarGroup> &groups = layer.star_groups();
	const std::size_t per_order = parts_per_order(settings);
	const std::size_t order = part / per_order;
	const Views &looked = views.at(order);
	// Where all directions can be seen, most direct images are as a rule: then the groups need not be asked.
	const bool all = !is_bounded(settings) ||
			std::any_of(looked.of_eyes.begin(), looked.of_eyes.end(), [&layer](const View &view) {
				return view.limit + view.bound.least_brightening() >= layer.faintest();
			});
	const bool moving = looked.ground.reserve != Reserve();
	const std::size_t piece = part % per_order;
	const std::size_t end = groups.size() * (piece + 1) / per_order;
	for (std::size_t g = groups.size() * piece / per_order; g < end; ++g) {
		double faintest = all ? kInfinity : -kInfinity;
		if (!all) {
			for (const View &view : looked.of_eyes) {
				faintest = std::max(faintest, view.limit + view.bound.brightening(groups[g], view.slack));
			}
		}
		layer.set_faintest(static_cast<int>(order), g, faintest, moving);
	}
	parts.at(part).chosen = true;
	parts.at(part).ground = looked.ground;
}

void StarChoice::update(StarLayer &layer, const SkySettings &settings, const std::vector<WatchingEye> &eyes,
		const blackhole::LensingTables &tables) {
	const Reserve reserve = reserve_for(eyes, settings);
	const std::size_t per_order = parts_per_order(settings);
	const std::size_t count = per_order * static_cast<std::size_t>(settings.image_orders);
	const auto is_final = [&eyes](const Part &part) {
		return part.chosen && part.ground.reserve == Reserve() && part.ground.eyes == eyes;
	};
	if (!std::all_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count), is_final)) {
		const bool hold = std::all_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count),
				[&eyes, &settings](const Part &part) { return holds(part, eyes, settings); });
		if (hold) {
			next_part %= count;
			if (next_part % per_order == 0) {
				look(static_cast<int>(next_part / per_order), settings, eyes, tables, reserve);
			}
			choose(next_part, layer, settings);
			++next_part;
		} else {
			for (std::size_t part = 0; part < count; ++part) {
				if (part % per_order == 0) {
					look(static_cast<int>(part / per_order), settings, eyes, tables, reserve);
				}
				choose(part, layer, settings);
			}
			next_part = 0;
		}
	}
	last_eyes = eyes;
}
