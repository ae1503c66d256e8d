// SPDX-License-Identifier: MIT
// Messages to the engine's error log, with the place they come from. Conditions that fail leave the function.
#pragma once

#include "godot_cpp/core/defs.hpp"
#include "godot_cpp/variant/string.hpp"

#include <cstdlib>

namespace godot {

enum class ErrorKind { kError, kWarning };

// Where a message comes from.
struct SourcePlace {
	const char *function;
	const char *file;
	int line;
};

// Prints a message; `description` says what failed, `message` (may be empty) what it means for the user.
void _report(const SourcePlace &place, ErrorKind kind, const String &description, const String &message,
		bool editor_notify = false);

// The message of an index out of range.
String _index_description(
		const char *index_text, std::int64_t index, const char *size_text, std::int64_t size);

} // namespace godot

#define GODOT_PROVIDER_PLACE                                                                                 \
	::godot::SourcePlace {                                                                                   \
		__func__, __FILE__, __LINE__                                                                         \
	}
#define GODOT_PROVIDER_ERROR(description, message)                                                           \
	::godot::_report(GODOT_PROVIDER_PLACE, ::godot::ErrorKind::kError, description, message)

// Leaves the enclosing function (or loop) by `action` when the condition holds.
#define GODOT_PROVIDER_GUARD(condition, description, message, action)                                        \
	if (unlikely(condition)) {                                                                               \
		GODOT_PROVIDER_ERROR(description, message);                                                          \
		action;                                                                                              \
	} else                                                                                                   \
		((void)0)

#define GODOT_PROVIDER_INDEX_GUARD(index, size, message, action)                                             \
	GODOT_PROVIDER_GUARD(static_cast<std::int64_t>(index) < 0 ||                                             \
					static_cast<std::int64_t>(index) >= static_cast<std::int64_t>(size),                     \
			::godot::_index_description(                                                                     \
					#index, static_cast<std::int64_t>(index), #size, static_cast<std::int64_t>(size)),       \
			message, action)

#define ERR_FAIL_COND(m_cond) GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", "", return )
#define ERR_FAIL_COND_MSG(m_cond, m_msg)                                                                     \
	GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", m_msg, return )
#define ERR_FAIL_COND_V(m_cond, m_retval)                                                                    \
	GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", "", return m_retval)
#define ERR_FAIL_COND_V_MSG(m_cond, m_retval, m_msg)                                                         \
	GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", m_msg, return m_retval)

#define ERR_FAIL_NULL(m_param)                                                                               \
	GODOT_PROVIDER_GUARD((m_param) == nullptr, "Parameter \"" #m_param "\" is null.", "", return )
#define ERR_FAIL_NULL_MSG(m_param, m_msg)                                                                    \
	GODOT_PROVIDER_GUARD((m_param) == nullptr, "Parameter \"" #m_param "\" is null.", m_msg, return )
#define ERR_FAIL_NULL_V(m_param, m_retval)                                                                   \
	GODOT_PROVIDER_GUARD((m_param) == nullptr, "Parameter \"" #m_param "\" is null.", "", return m_retval)
#define ERR_FAIL_NULL_V_MSG(m_param, m_retval, m_msg)                                                        \
	GODOT_PROVIDER_GUARD((m_param) == nullptr, "Parameter \"" #m_param "\" is null.", m_msg, return m_retval)

#define ERR_FAIL_INDEX(m_index, m_size) GODOT_PROVIDER_INDEX_GUARD(m_index, m_size, "", return )
#define ERR_FAIL_INDEX_MSG(m_index, m_size, m_msg) GODOT_PROVIDER_INDEX_GUARD(m_index, m_size, m_msg, return )
#define ERR_FAIL_INDEX_V(m_index, m_size, m_retval)                                                          \
	GODOT_PROVIDER_INDEX_GUARD(m_index, m_size, "", return m_retval)
#define ERR_FAIL_INDEX_V_MSG(m_index, m_size, m_retval, m_msg)                                               \
	GODOT_PROVIDER_INDEX_GUARD(m_index, m_size, m_msg, return m_retval)

#define ERR_CONTINUE(m_cond) GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", "", continue)
#define ERR_CONTINUE_MSG(m_cond, m_msg)                                                                      \
	GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", m_msg, continue)
#define ERR_BREAK(m_cond) GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", "", break)
#define ERR_BREAK_MSG(m_cond, m_msg)                                                                         \
	GODOT_PROVIDER_GUARD(m_cond, "Condition \"" #m_cond "\" is true.", m_msg, break)

#define ERR_FAIL() GODOT_PROVIDER_GUARD(true, "Method/function failed.", "", return )
#define ERR_FAIL_MSG(m_msg) GODOT_PROVIDER_GUARD(true, "Method/function failed.", m_msg, return )
#define ERR_FAIL_V(m_retval) GODOT_PROVIDER_GUARD(true, "Method/function failed.", "", return m_retval)
#define ERR_FAIL_V_MSG(m_retval, m_msg)                                                                      \
	GODOT_PROVIDER_GUARD(true, "Method/function failed.", m_msg, return m_retval)

#define ERR_PRINT(m_msg) GODOT_PROVIDER_ERROR(m_msg, "")
#define WARN_PRINT(m_msg) ::godot::_report(GODOT_PROVIDER_PLACE, ::godot::ErrorKind::kWarning, m_msg, "")
#define GODOT_PROVIDER_ONCE(action)                                                                          \
	if (static bool printed = false; !std::exchange(printed, true)) {                                        \
		action;                                                                                              \
	} else                                                                                                   \
		((void)0)
#define ERR_PRINT_ONCE(m_msg) GODOT_PROVIDER_ONCE(ERR_PRINT(m_msg))
#define WARN_PRINT_ONCE(m_msg) GODOT_PROVIDER_ONCE(WARN_PRINT(m_msg))

#define CRASH_COND_MSG(m_cond, m_msg)                                                                        \
	GODOT_PROVIDER_GUARD(m_cond, "FATAL: Condition \"" #m_cond "\" is true.", m_msg, std::abort())
#define CRASH_COND(m_cond) CRASH_COND_MSG(m_cond, "")
