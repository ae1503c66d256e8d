// SPDX-License-Identifier: MIT
#include "godot_cpp/core/error_macros.hpp"

#include "godot_cpp/variant/variant.hpp"

namespace godot {

void _report(const SourcePlace &place, ErrorKind kind, const String &description, const String &message,
		bool editor_notify) {
	const auto print = kind == ErrorKind::kError ? internal::api.print_error_with_message
												 : internal::api.print_warning_with_message;
	print(description.utf8().get_data(), message.utf8().get_data(), place.function, place.file, place.line,
			editor_notify ? 1 : 0);
}

String _index_description(
		const char *index_text, std::int64_t index, const char *size_text, std::int64_t size) {
	return vformat("Index %s = %d is out of bounds (%s = %d).", index_text, index, size_text, size);
}

} // namespace godot
