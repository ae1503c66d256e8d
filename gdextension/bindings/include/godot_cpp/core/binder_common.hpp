// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/type_info.hpp"

// Makes an enumeration usable in bound methods, under its name in the engine; at global scope.
#define VARIANT_ENUM_CAST(m_enum)                                                                            \
	template <>                                                                                              \
	struct godot::internal::EnumName<m_enum> {                                                               \
		static constexpr const char *kText = #m_enum;                                                        \
	};
#define VARIANT_BITFIELD_CAST(m_enum) VARIANT_ENUM_CAST(m_enum)
