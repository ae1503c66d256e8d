// SPDX-License-Identifier: MIT
// Files that are far too large, or announce that they are: refused at once, and without memory for them.
#include <array>
#include <chrono>
#include <cstring>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/catalogue/star_csv.h"
#include "core/catalogue/star_file.h"
#include "core/tables/table_file.h"
#include "lut_cli/csv_table.h"
#include "lut_cli/files.h"
#include "tests/robustness/allocation_meter.h"
#include "tests/robustness/sparse_file.h"

namespace blackhole::test {
namespace {

constexpr std::size_t kFourGigabytes = std::size_t{4} << 30;
constexpr std::size_t kMostBytes = 1 << 20;
// A sanitizer makes everything slower, not more so where a file is large.
#if defined(ASAN_ENABLED) || defined(TSAN_ENABLED)
constexpr double kMostSeconds = 0.5;
#else
constexpr double kMostSeconds = 0.1;
#endif

/// Asks for the message of a refusal, which must come at once, cost no memory and name all words.
template <class Refusal>
void expect_cheap(const Refusal &p_refusal, const std::vector<std::string> &p_words) {
	const auto begun = std::chrono::steady_clock::now();
	std::string message;
	std::size_t bytes = 0;
	{
		const AllocationMeter meter;
		message = p_refusal();
		bytes = meter.bytes();
	}
	const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
	EXPECT_LT(took.count(), kMostSeconds) << message;
	EXPECT_LT(bytes, kMostBytes) << message;
	for (const std::string &word : p_words) {
		EXPECT_NE(message.find(word), std::string::npos) << message;
	}
}

template <class Number>
void put(std::string &r_bytes, std::size_t p_at, Number p_number) {
	std::memcpy(r_bytes.data() + p_at, &p_number, sizeof p_number);
}

/// The header of a .stars file, little-endian as on every machine these tests run on.
std::string star_header(std::uint32_t p_stars, std::uint32_t p_names, std::uint32_t p_text) {
	std::string header("BHSTARS\0", 8);
	header.resize(kStarFileHeaderSize);
	put(header, 8, std::uint32_t{1});
	put(header, 12, p_stars);
	put(header, 16, p_names);
	put(header, 20, p_text);
	put(header, 24, 2000.0);
	return header;
}

std::string table_header(std::uint32_t p_side) {
	std::string header("BHLENS\r\n", 8);
	header.resize(kTableFileHeaderSize);
	const std::array<std::uint32_t, 6> numbers = {
			kTableFileVersion, kTableFileHeaderSize, p_side, p_side, 4, 4};
	std::memcpy(header.data() + 8, numbers.data(), sizeof numbers);
	put(header, 56, p_side);
	put(header, 60, p_side);
	const auto *bytes = reinterpret_cast<const std::uint8_t *>(header.data());
	put(header, 68, static_cast<std::uint32_t>(crc32_z(0, bytes, 68)));
	return header;
}

TEST(HostileFiles, AMeterCounts) {
	const AllocationMeter meter;
	const std::vector<char> memory(1000);
	EXPECT_GE(meter.bytes(), memory.size());
}

TEST(HostileFiles, FourGigabytesOfNothingAreNoCatalogue) {
	const SparseFile file("", kFourGigabytes);
	expect_cheap([&] { return read_star_file(file.bytes(), "void.stars").error; },
			{"void.stars", "tools/catalogue"});
	expect_cheap(
			[&] { return read_star_csv(file.text(), "void.csv").error; }, {"void.csv", "line 1", "65536"});
	expect_cheap([&] { return star_csv_fault(file.text(), "void.csv"); }, {"void.csv", "65536"});
}

TEST(HostileFiles, AHeaderOfFourThousandMillionStarsIsNotBelieved) {
	const std::string header = star_header(0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF);
	const SparseFile file(header, kFourGigabytes);
	expect_cheap([&] { return read_star_file(file.bytes(), "lie.stars").error; }, {"lie.stars", "truncated"});
	expect_cheap([&] { return star_file_fault(file.bytes(), 100, "lie.stars"); }, {"100 bytes", "truncated"});
}

TEST(HostileFiles, AHeaderThatFitsFourGigabytesHasTooManyStars) {
	const auto stars = static_cast<std::uint32_t>((kFourGigabytes - kStarFileHeaderSize) / 28);
	const auto text = static_cast<std::uint32_t>((kFourGigabytes - kStarFileHeaderSize) % 28);
	const SparseFile file(star_header(stars, 0, text), kFourGigabytes);
	expect_cheap(
			[&] { return read_star_file(file.bytes(), "many.stars").error; }, {"many.stars", "50000000"});
}

TEST(HostileFiles, LinesWithoutEndAreRefused) {
	for (const std::string start : {"ra_deg,dec_deg,vmag\n1,2,3\n", "ra_deg,dec_deg,vmag\n\"", "# a comment",
				 "ra_deg,dec_deg,vmag,name\n1,2,3,\""}) {
		const SparseFile file(start, kFourGigabytes);
		expect_cheap(
				[&] { return read_star_csv(file.text(), "endless.csv").error; }, {"endless.csv", "65536"});
	}
}

TEST(HostileFiles, ALongLineThatEndsIsRead) {
	const std::string name(60000, 'x');
	const auto table = read_star_csv("ra_deg,dec_deg,vmag,name\n1,2,3," + name + "\n", "long.csv");
	ASSERT_TRUE(table) << table.error;
	EXPECT_EQ(table.value->name_of(table.value->stars[0]), name);
	EXPECT_FALSE(read_star_csv("ra_deg,dec_deg,vmag,name\n1,2,3," + name + name + "\n", "long.csv"));
}

TEST(HostileFiles, TheStartOfATableMayEndInAnyPlace) {
	const std::string comments(kStarCsvHead - 10, '\n');
	EXPECT_EQ(star_csv_fault(comments + "ra_deg,dec_deg,vmag\n1,2,3\n", "late.csv"), "");
	EXPECT_EQ(star_csv_fault("ra_deg,dec_deg,vmag\n1,2,3\n", "good.csv"), "");
	EXPECT_NE(star_csv_fault("ra,dec,vmag\n1,2,3\n", "bad.csv").find("ra_deg"), std::string::npos);
}

TEST(HostileFiles, ATableFileOfFourGigabytesIsNone) {
	const SparseFile nothing("", kFourGigabytes);
	const SparseFile huge(table_header(4096), kFourGigabytes);
	for (const SparseFile *file : {&nothing, &huge}) {
		expect_cheap([&] { return read_lensing_tables(file->bytes(), "huge.lut").error; },
				{"huge.lut", "./run bake"});
		expect_cheap([&] { return load_table_file(file->path()).error; }, {file->path(), "./run bake"});
	}
	const std::string header = table_header(4096);
	const auto *bytes = reinterpret_cast<const std::uint8_t *>(header.data());
	expect_cheap(
			[&] {
				return table_file_fault({bytes, header.size()}, header.size(), "lie.lut");
			},
			{"72 bytes"});
}

TEST(HostileFiles, InputsOfFourGigabytesAreNotRead) {
	const SparseFile file("u_o,Phi\n", kFourGigabytes);
	expect_cheap([&] { return CsvTable::load(file.path()).error; }, {file.path(), "larger"});
}

} // namespace
} // namespace blackhole::test
