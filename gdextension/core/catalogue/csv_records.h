// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace blackhole {

/// Splits comma-separated text (RFC 4180: quoted fields may hold commas, doubled quotes and line ends; lines
/// end in LF, CRLF or CR) into records. Blank lines and lines that start with # are passed over, as is a
/// UTF-8 byte order mark. Blanks round an unquoted field are trimmed. A line or a record longer than
/// kLongestRecord is a fault: nothing that grows with the text is kept.
class CsvRecords {
public:
	static constexpr std::size_t kLongestRecord = 65536;

	explicit CsvRecords(std::string_view p_text);

	/// Reads the next record into fields(); false at the end of the text or on a fault.
	bool next();

	const std::vector<std::string> &fields() const { return m_fields; }
	/// The line the current record starts on, counted from 1.
	std::size_t line() const { return m_record_line; }
	/// Whether all of the text has been read.
	bool is_at_end() const { return m_at >= m_text.size(); }
	/// What is wrong with the text, empty when nothing is.
	const std::string &fault() const { return m_fault; }

private:
	/// The end of the text, or how far the line or record at hand may reach.
	std::size_t limit() const;
	bool is_too_long() const;
	bool at_line_end() const;
	void skip_line_end();
	void skip_idle_lines();
	bool read_record();
	bool read_field();
	bool read_quoted(std::string &r_field);

	std::string_view m_text;
	std::size_t m_at = 0;
	std::size_t m_start = 0; ///< of the line or record at hand
	std::size_t m_line = 1;
	std::size_t m_record_line = 0;
	std::size_t m_count = 0;
	std::vector<std::string> m_fields;
	std::string m_fault;
};

} // namespace blackhole
