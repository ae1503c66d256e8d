// SPDX-License-Identifier: MIT
#include "core/catalogue/csv_records.h"

#include <algorithm>

namespace blackhole {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view p_text) {
	const std::size_t first = p_text.find_first_not_of(" \t");
	if (first == std::string_view::npos) {
		return {};
	}
	return p_text.substr(first, p_text.find_last_not_of(" \t") - first + 1);
}

} // namespace

CsvRecords::CsvRecords(std::string_view p_text) : m_text(p_text) {
	if (m_text.starts_with(kByteOrderMark)) {
		m_text.remove_prefix(kByteOrderMark.size());
	}
}

std::size_t CsvRecords::limit() const {
	return m_start + std::min(kLongestRecord + 1, m_text.size() - m_start);
}

bool CsvRecords::is_too_long() const {
	return m_at - m_start > kLongestRecord;
}

bool CsvRecords::at_line_end() const {
	return m_at >= limit() || m_text[m_at] == '\n' || m_text[m_at] == '\r';
}

void CsvRecords::skip_line_end() {
	if (m_at < m_text.size() && m_text[m_at] == '\r') {
		++m_at;
		if (m_at < m_text.size() && m_text[m_at] == '\n') {
			++m_at;
		}
	} else if (m_at < m_text.size()) {
		++m_at;
	}
	++m_line;
}

void CsvRecords::skip_idle_lines() {
	while (m_at < m_text.size()) {
		m_start = m_at;
		const std::string_view longest = m_text.substr(m_at, kLongestRecord + 1);
		const std::size_t size = std::min(longest.find_first_of("\r\n"), longest.size());
		const std::string_view line = trimmed(longest.substr(0, size));
		if (!line.empty() && line.front() != '#') {
			return;
		}
		m_at += size;
		if (is_too_long()) {
			return;
		}
		skip_line_end();
	}
}

bool CsvRecords::read_quoted(std::string &r_field) {
	for (++m_at; m_at < limit(); ++m_at) {
		const char c = m_text[m_at];
		const bool next_is_quote = m_at + 1 < m_text.size() && m_text[m_at + 1] == '"';
		if (c == '"' && !next_is_quote) {
			++m_at;
			return true;
		}
		if (c == '"') {
			++m_at;
		}
		m_line += c == '\n' ? 1 : 0;
		r_field.push_back(c);
	}
	m_fault = "a quoted field is never closed: add the missing \"";
	return false;
}

bool CsvRecords::read_field() {
	if (m_count == m_fields.size()) {
		m_fields.emplace_back();
	}
	std::string &field = m_fields[m_count++];
	field.clear();
	const std::string_view text = m_text.substr(0, limit());
	const std::size_t first = std::min(text.find_first_not_of(" \t", m_at), text.size());
	if (first < text.size() && text[first] == '"') {
		m_at = first;
		if (!read_quoted(field)) {
			return false;
		}
		m_at = std::min(text.find_first_not_of(" \t", m_at), text.size());
		if (!at_line_end() && m_text[m_at] != ',') {
			m_fault = "text follows a closing quote: put a comma after it, or double the quotes inside the "
					  "field";
			return false;
		}
		return true;
	}
	const std::size_t end = std::min(text.find_first_of(",\r\n", m_at), text.size());
	field = trimmed(text.substr(m_at, end - m_at));
	m_at = end;
	return true;
}

bool CsvRecords::next() {
	if (!m_fault.empty()) {
		return false;
	}
	skip_idle_lines();
	if (m_at >= m_text.size()) {
		return false;
	}
	m_record_line = m_line;
	const bool found = read_record();
	if (is_too_long()) {
		m_fault = "the line is longer than " + std::to_string(kLongestRecord) +
				" bytes, so this is no table: give each star a line of its own, and look for a quote that is "
				"not closed";
		return false;
	}
	if (found) {
		skip_line_end();
	}
	return found;
}

bool CsvRecords::read_record() {
	m_count = 0;
	while (!is_too_long() && read_field()) {
		if (at_line_end()) {
			m_fields.resize(m_count);
			return true;
		}
		++m_at; // the comma
	}
	return false;
}

} // namespace blackhole
