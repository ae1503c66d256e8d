// SPDX-License-Identifier: MIT
#include "core/relativity/world_line.h"

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace blackhole {
namespace {

namespace odeint = boost::numeric::odeint;

/// Position, celerity, PG time.
using State = std::array<double, 7>;
using Stepper = odeint::runge_kutta_fehlberg78<State>;
using ControlledStepper = odeint::controlled_runge_kutta<Stepper>;

constexpr double kLocalError = 1e-13;
constexpr double kLargestCelerity = 1e6;
constexpr int kMostSteps = 20000;
/// No step goes farther than this part of the radius, so that none jumps across the centre.
constexpr double kFarthestStep = 0.2;

glm::dvec3 position_of(const State &state) {
	return {state[0], state[1], state[2]};
}

glm::dvec3 celerity_of(const State &state) {
	return {state[3], state[4], state[5]};
}

double gamma_of(const glm::dvec3 &celerity) {
	return std::sqrt(1.0 + glm::dot(celerity, celerity));
}

/// The line element -dT^2 + |dx - v dT|^2 with the rain's velocity v = -r^(-1/2) n gives the covariant
/// momentum w and, from its geodesics, with a = the thrust in rain axes:
///   dT/dtau = gamma,  dx/dtau = gamma v + w,  dw_i/dtau = -gamma (d_i v_j) w_j + a_i,
///   d_i v_j = -r^(-3/2) (delta_ij - 3/2 n_i n_j),  a = alpha + (alpha.w) w/(1 + gamma).
struct Equation {
	glm::dvec3 thrust;

	void operator()(const State &state, State &slope, double /*tau*/) const {
		const glm::dvec3 x = position_of(state);
		const glm::dvec3 w = celerity_of(state);
		const double r = glm::length(x);
		const glm::dvec3 n = x / r;
		const double gamma = gamma_of(w);
		const double flow = 1.0 / std::sqrt(r);
		const glm::dvec3 moved = w - n * (gamma * flow);
		const glm::dvec3 turned = (w - n * (1.5 * glm::dot(n, w))) * (gamma * flow / r) + thrust +
				w * (glm::dot(thrust, w) / (1.0 + gamma));
		slope = {moved.x, moved.y, moved.z, turned.x, turned.y, turned.z, gamma};
	}
};

double radius_of(const State &state) {
	return glm::length(position_of(state));
}

/// dr/dtau.
double radial_speed(const State &state) {
	const glm::dvec3 n = glm::normalize(position_of(state));
	return glm::dot(n, celerity_of(state)) - gamma_of(celerity_of(state)) / std::sqrt(radius_of(state));
}

/// The longest step from here, by the coordinate speed |dx/dtau|.
double longest_step(const State &state) {
	const double r = radius_of(state);
	const glm::dvec3 w = celerity_of(state);
	return kFarthestStep * r / (glm::length(w) + gamma_of(w) / std::sqrt(r));
}

/// The part of `step` after which the radius is the smallest one, by Newton's method; moves `state` there.
double land(const Equation &equation, State &state, double step) {
	const State before = state;
	Stepper stepper;
	for (int i = 0; i < 8; ++i) {
		state = before;
		stepper.do_step(equation, state, 0.0, step);
		const double beyond = radius_of(state) - kWorldLineEnd;
		if (std::abs(beyond) < 1e-15) {
			break;
		}
		step -= beyond / radial_speed(state);
	}
	return step;
}

bool is_finite(const State &state) {
	return std::all_of(state.begin(), state.end(), [](double value) { return std::isfinite(value); });
}

} // namespace

double orbital_energy(const WorldLineState &state) {
	// -p_T = gamma + v.w
	const double r = glm::length(state.position);
	return gamma_of(state.celerity) - glm::dot(state.position, state.celerity) / (r * std::sqrt(r));
}

glm::dvec3 angular_momentum(const WorldLineState &state) {
	return glm::cross(state.position, state.celerity);
}

Outcome<WorldLine> WorldLine::start(glm::dvec3 position_rs, glm::dvec3 celerity) {
	const double r = glm::length(position_rs);
	if (!std::isfinite(r) || r < kWorldLineEnd) {
		return Outcome<WorldLine>::failure(
				"a world line starts at a finite position, 0.01 r_s or more from the centre");
	}
	if (!(glm::length(celerity) <= kLargestCelerity)) {
		return Outcome<WorldLine>::failure("the celerity must be a number, at most 1e6 c");
	}
	return Outcome<WorldLine>::success(WorldLine({position_rs, celerity, 0.0, 0.0}));
}

WorldLineEnd WorldLine::advance(double duration, glm::dvec3 thrust) {
	if (!std::isfinite(duration) || !std::isfinite(glm::length(thrust))) {
		return WorldLineEnd::kRefused;
	}
	const glm::dvec3 &x = state_.position;
	const glm::dvec3 &w = state_.celerity;
	State state = {x.x, x.y, x.z, w.x, w.y, w.z, state_.rain_time};
	const double sign = duration < 0.0 ? -1.0 : 1.0;
	const Equation equation{thrust};
	// The controller copies a stepper with its work space; that of a static one is not uninitialised.
	static const Stepper kBlank;
	ControlledStepper stepper(ControlledStepper::error_checker_type(kLocalError, kLocalError),
			ControlledStepper::step_adjuster_type(), kBlank);
	double passed = 0.0;
	double left = std::abs(duration);
	WorldLineEnd end =
			sign > 0.0 && radius_of(state) <= kWorldLineEnd ? WorldLineEnd::kCentre : WorldLineEnd::kOnTheWay;
	for (int i = 0; left > 0.0 && end == WorldLineEnd::kOnTheWay; ++i) {
		const State before = state;
		const double planned = std::min(step_, longest_step(state));
		const bool last = planned >= left;
		const double tried = last ? left : planned;
		double tau = 0.0;
		double step = sign * tried;
		const auto result = stepper.try_step(equation, state, tau, step);
		// Where the time left cut a step short, the next one need not start from that.
		const bool done = result == odeint::success;
		step_ = done && last ? std::max(step_, std::abs(step)) : std::abs(step);
		if (i >= kMostSteps || !is_finite(state) ||
				!(gamma_of(celerity_of(state)) < 2.0 * kLargestCelerity)) {
			state = before;
			step_ = 0.01;
			end = WorldLineEnd::kTooFast;
		} else if (done && sign > 0.0 && radius_of(state) < kWorldLineEnd) {
			state = before;
			passed += land(equation, state, tried);
			end = WorldLineEnd::kCentre;
		} else if (done) {
			passed += tried;
			left = last ? 0.0 : left - tried;
		}
	}
	state_.position = position_of(state);
	state_.celerity = celerity_of(state);
	state_.rain_time = state[6];
	state_.proper_time += left > 0.0 ? sign * passed : duration;
	return end;
}

} // namespace blackhole
