// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace blackhole {

/// Whether p_text is UTF-8 without a zero byte, so that names come through every file and every program.
bool is_plain_text(std::string_view p_text);

/// p_text for a message: at most 40 bytes of it, what is not printable ASCII as a question mark.
std::string shown_in_message(std::string_view p_text);

} // namespace blackhole
