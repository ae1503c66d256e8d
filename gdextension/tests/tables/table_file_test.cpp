// SPDX-License-Identifier: MIT
#include "core/tables/table_file.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include <cstring>
#include <limits>

namespace blackhole::test {
namespace {

const std::vector<std::uint8_t> &good_bytes() {
	static const std::vector<std::uint8_t> bytes = write_lensing_tables(bake_lensing_tables());
	return bytes;
}

/// Puts a number at an offset, little-endian as on every machine these tests run on.
template <class Number>
void put(std::vector<std::uint8_t> &bytes, std::size_t at, Number number) {
	std::memcpy(bytes.data() + at, &number, sizeof number);
}

/// Makes both checksums right again, as somebody would who forges a file.
void seal(std::vector<std::uint8_t> &bytes) {
	const std::size_t header = kTableFileHeaderSize;
	put(bytes, 64, static_cast<std::uint32_t>(crc32_z(0, bytes.data() + header, bytes.size() - header)));
	put(bytes, 68, static_cast<std::uint32_t>(crc32_z(0, bytes.data(), 68)));
}

/// The message for these bytes, which must name the file and the remedy.
std::string refusal(const std::vector<std::uint8_t> &bytes) {
	const auto read = read_lensing_tables(bytes, "some.lut");
	EXPECT_FALSE(read);
	EXPECT_NE(read.error.find("some.lut"), std::string::npos) << read.error;
	EXPECT_NE(read.error.find("./run bake"), std::string::npos) << read.error;
	return read.error;
}

void expect_refused(const std::vector<std::uint8_t> &bytes, const std::string &reason) {
	const std::string message = refusal(bytes);
	EXPECT_NE(message.find(reason), std::string::npos) << message;
}

TEST(TableFile, ComesBackUnchanged) {
	const LensingTables tables = bake_lensing_tables();
	const auto read = read_lensing_tables(good_bytes(), "some.lut");
	ASSERT_TRUE(read) << read.error;
	EXPECT_EQ(read.value->columns, tables.columns);
	EXPECT_EQ(read.value->rows, tables.rows);
	EXPECT_EQ(read.value->ln_u_min, tables.ln_u_min);
	EXPECT_EQ(read.value->ln_u_max, tables.ln_u_max);
	EXPECT_EQ(read.value->x_limit, tables.x_limit);
	EXPECT_EQ(read.value->inverse, tables.inverse);
	EXPECT_EQ(read.value->forward, tables.forward);
	EXPECT_EQ(read.value->rays.radius, tables.rays.radius);
	EXPECT_EQ(read.value->rays.delay, tables.rays.delay);
}

TEST(TableFile, HasTheDocumentedLayout) {
	const std::vector<std::uint8_t> &bytes = good_bytes();
	ASSERT_EQ(bytes.size(), 786504U);
	EXPECT_EQ(std::memcmp(bytes.data(), "BHLENS\r\n", 8), 0);
	const std::uint8_t expected[] = {
			2, 0, 0, 0, 72, 0, 0, 0, 128, 0, 0, 0, 96, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0};
	EXPECT_EQ(std::memcmp(bytes.data() + 8, expected, sizeof expected), 0);
	float first = 0.0F;
	const std::uint8_t ray_grid[] = {96, 0, 0, 0, 128, 0, 0, 0};
	EXPECT_EQ(std::memcmp(bytes.data() + 56, ray_grid, sizeof ray_grid), 0);
	std::memcpy(&first, bytes.data() + 72, sizeof first);
	EXPECT_NEAR(first, 0.4353F, 1e-4F);
	std::memcpy(&first, bytes.data() + 196680, sizeof first);
	EXPECT_NEAR(first, 2.2973F, 1e-3F);
	for (const std::size_t start : {393288U, 589896U}) { // of a ray nothing has bent yet
		std::memcpy(&first, bytes.data() + start, sizeof first);
		EXPECT_EQ(first, 1.0F);
	}
}

TEST(TableFile, RefusesEveryTruncation) {
	for (const std::size_t size : {0U, 1U, 7U, 8U, 11U, 71U, 72U, 73U, 196680U, 786503U}) {
		auto bytes = good_bytes();
		bytes.resize(size);
		EXPECT_FALSE(refusal(bytes).empty()) << size;
	}
	auto longer = good_bytes();
	longer.push_back(0);
	expect_refused(longer, "786505 bytes instead of 786504");
}

TEST(TableFile, RefusesEveryFlippedBit) {
	auto bytes = good_bytes();
	for (std::size_t at = 0; at < bytes.size(); at += at < kTableFileHeaderSize ? 1 : 1009) {
		const auto bit = static_cast<std::uint8_t>(1U << (at % 8));
		bytes[at] ^= bit;
		EXPECT_FALSE(read_lensing_tables(bytes, "some.lut")) << at;
		bytes[at] ^= bit;
	}
	EXPECT_TRUE(read_lensing_tables(bytes, "some.lut"));
}

TEST(TableFile, SaysWhatIsWrong) {
	auto bytes = good_bytes();
	bytes[0] = 'X';
	expect_refused(bytes, "no lensing table");
	bytes = good_bytes();
	put(bytes, 8, std::uint32_t{1});
	seal(bytes);
	expect_refused(bytes, "format version 1");
	bytes = good_bytes();
	bytes[40] ^= 1;
	expect_refused(bytes, "header is damaged");
	bytes = good_bytes();
	bytes[5000] ^= 1;
	expect_refused(bytes, "values are damaged");
	bytes = good_bytes();
	put(bytes, 32, -10.0);
	seal(bytes);
	expect_refused(bytes, "grid is not the one");
	bytes = good_bytes();
	put(bytes, 48, std::numeric_limits<double>::quiet_NaN());
	seal(bytes);
	expect_refused(bytes, "grid is not the one");
	bytes = good_bytes();
	put(bytes, 1000, std::numeric_limits<float>::quiet_NaN());
	seal(bytes);
	expect_refused(bytes, "no numbers");
	// A copy that turned line ends.
	bytes = good_bytes();
	bytes.erase(bytes.begin() + 6);
	expect_refused(bytes, "no lensing table");
}

TEST(TableFile, AllocatesNothingForHostileSizes) {
	for (const std::uint32_t side : {0U, 1U, 127U, 4096U, 4097U, 0x10000U, 0x7fffffffU, 0xffffffffU}) {
		for (const std::size_t field : {16U, 20U, 24U, 28U, 12U, 56U, 60U}) {
			auto bytes = good_bytes();
			put(bytes, field, side);
			seal(bytes);
			EXPECT_FALSE(refusal(bytes).empty()) << side << " at " << field;
		}
		auto bytes = good_bytes();
		put(bytes, 16, side);
		put(bytes, 20, side);
		bytes.resize(kTableFileHeaderSize);
		seal(bytes);
		EXPECT_FALSE(refusal(bytes).empty()) << side;
	}
}

} // namespace
} // namespace blackhole::test
