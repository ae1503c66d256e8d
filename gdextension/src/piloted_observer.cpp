// SPDX-License-Identifier: MIT
#include "src/piloted_observer.h"

#include <glm/geometric.hpp>

#include <godot_cpp/variant/utility_functions.hpp>

#include "core/relativity/clocks.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/observer.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

PilotedObserver::Progress to_progress(blackhole::WorldLineEnd end) {
	switch (end) {
		case blackhole::WorldLineEnd::kOnTheWay:
			return PilotedObserver::PROGRESS_ON_THE_WAY;
		case blackhole::WorldLineEnd::kCentre:
			return PilotedObserver::PROGRESS_CENTRE;
		case blackhole::WorldLineEnd::kTooFast:
			return PilotedObserver::PROGRESS_TOO_FAST;
		case blackhole::WorldLineEnd::kRefused:
			break;
	}
	return PilotedObserver::PROGRESS_REFUSED;
}

} // namespace

Error PilotedObserver::take(const blackhole::Outcome<blackhole::WorldLine> &made) {
	if (!made) {
		error_message = "PilotedObserver: " + String::utf8(made.error.c_str()) + ".";
		UtilityFunctions::push_error(error_message);
		return ERR_INVALID_PARAMETER;
	}
	line = made.value;
	error_message = String();
	return OK;
}

Error PilotedObserver::start(const Vector3 &position, const Vector3 &celerity) {
	return take(blackhole::WorldLine::start(to_glm(position), to_glm(celerity)));
}

Error PilotedObserver::start_static(const Vector3 &position) {
	const blackhole::Outcome<glm::dvec3> celerity =
			blackhole::observer_celerity(blackhole::ObserverMotion::kStatic, to_glm(position));
	return take(celerity ? blackhole::WorldLine::start(to_glm(position), *celerity.value)
						 : blackhole::Outcome<blackhole::WorldLine>::failure(celerity.error));
}

PilotedObserver::Progress PilotedObserver::advance(double duration, const Vector3 &thrust) {
	return line ? to_progress(line->advance(duration, to_glm(thrust))) : PROGRESS_REFUSED;
}

Vector3 PilotedObserver::get_position() const {
	return line ? to_godot(line->state().position) : Vector3();
}

Vector3 PilotedObserver::get_celerity() const {
	return line ? to_godot(line->state().celerity) : Vector3();
}

double PilotedObserver::get_radius() const {
	return line ? glm::length(line->state().position) : blackhole::kNaN;
}

double PilotedObserver::get_proper_time() const {
	return line ? line->state().proper_time : blackhole::kNaN;
}

double PilotedObserver::get_rain_time() const {
	return line ? line->state().rain_time : blackhole::kNaN;
}

double PilotedObserver::get_energy() const {
	return line ? blackhole::orbital_energy(line->state()) : blackhole::kNaN;
}

Vector3 PilotedObserver::get_angular_momentum() const {
	return line ? to_godot(blackhole::angular_momentum(line->state())) : Vector3();
}

double PilotedObserver::far_clock_rate(const Vector3 &view_direction) const {
	if (!line) {
		return blackhole::kNaN;
	}
	const blackhole::WorldLineState &now = line->state();
	return blackhole::far_clock_rate(now.position, now.celerity, to_glm(view_direction))
			.value.value_or(blackhole::kNaN);
}

void PilotedObserver::_bind_methods() {
	ClassDB::bind_method(
			D_METHOD("start", "position", "celerity"), &PilotedObserver::start, DEFVAL(Vector3()));
	ClassDB::bind_method(D_METHOD("start_static", "position"), &PilotedObserver::start_static);
	ClassDB::bind_method(
			D_METHOD("advance", "duration", "thrust"), &PilotedObserver::advance, DEFVAL(Vector3()));
	ClassDB::bind_method(D_METHOD("is_ready"), &PilotedObserver::is_ready);
	ClassDB::bind_method(D_METHOD("get_error_message"), &PilotedObserver::get_error_message);
	ClassDB::bind_method(D_METHOD("get_position"), &PilotedObserver::get_position);
	ClassDB::bind_method(D_METHOD("get_celerity"), &PilotedObserver::get_celerity);
	ClassDB::bind_method(D_METHOD("get_radius"), &PilotedObserver::get_radius);
	ClassDB::bind_method(D_METHOD("get_proper_time"), &PilotedObserver::get_proper_time);
	ClassDB::bind_method(D_METHOD("get_rain_time"), &PilotedObserver::get_rain_time);
	ClassDB::bind_method(D_METHOD("get_energy"), &PilotedObserver::get_energy);
	ClassDB::bind_method(D_METHOD("get_angular_momentum"), &PilotedObserver::get_angular_momentum);
	ClassDB::bind_method(D_METHOD("far_clock_rate", "view_direction"), &PilotedObserver::far_clock_rate);
	BIND_ENUM_CONSTANT(PROGRESS_ON_THE_WAY);
	BIND_ENUM_CONSTANT(PROGRESS_CENTRE);
	BIND_ENUM_CONSTANT(PROGRESS_TOO_FAST);
	BIND_ENUM_CONSTANT(PROGRESS_REFUSED);
}
