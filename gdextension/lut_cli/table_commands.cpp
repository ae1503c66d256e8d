// SPDX-License-Identifier: MIT
#include "lut_cli/table_commands.h"

#include "core/tables/lensing_tables.h"
#include "core/tables/ray_axis.h"
#include "core/tables/table_file.h"
#include "lut_cli/files.h"
#include "lut_cli/table_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace blackhole {
namespace {

/// A progress bar on the standard error stream: redrawn on a terminal, one line at the end elsewhere.
class ProgressBar {
public:
	bool show(double done) {
		const int filled = static_cast<int>(done * kWidth);
		if (filled == drawn || (!terminal && done < 1.0)) {
			return true;
		}
		drawn = filled;
		const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
		std::fprintf(stderr, "%sbaking [%s] %3.0f %%%s", terminal ? "\r" : "", bar.c_str(), 100.0 * done,
				done >= 1.0 ? "\n" : "");
		std::fflush(stderr);
		return true;
	}

private:
	static constexpr int kWidth = 40;
	bool terminal = isatty(STDERR_FILENO) != 0;
	int drawn = -1;
};

std::string as_text(const LensingTables &tables) {
	const std::vector<std::uint8_t> bytes = write_lensing_tables(tables);
	return {bytes.begin(), bytes.end()};
}

/// The largest difference of two tables, in parts of what rounding allows: 1 = a few units of the last float
/// digit.
double table_difference(const std::vector<float> &a, const std::vector<float> &b) {
	double largest = 0.0;
	for (std::size_t i = 0; i < a.size(); ++i) {
		const double allowed = 2.4e-7 * std::abs(double{b[i]}) + 1e-9;
		largest = std::max(largest, std::abs(double{a[i]} - double{b[i]}) / allowed);
	}
	return largest;
}

std::string compare(const LensingTables &baked, const std::string &path) {
	const Outcome<LensingTables> stored = load_table_file(path);
	if (!stored) {
		return stored.error;
	}
	if (as_text(baked) == as_text(*stored.value)) {
		std::printf("%s: identical to a fresh bake\n", path.c_str());
		return {};
	}
	const double difference = std::max({table_difference(baked.inverse, stored.value->inverse),
			table_difference(baked.forward, stored.value->forward),
			table_difference(baked.rays.radius, stored.value->rays.radius),
			table_difference(baked.rays.delay, stored.value->rays.delay)});
	if (difference <= 1.0) {
		std::printf("%s: equal to a fresh bake within the rounding of floats\n", path.c_str());
		return {};
	}
	return path + ": differs from a fresh bake. Re-make it with ./run bake.";
}

void print_range(const char *name, const std::vector<float> &texels) {
	std::array<float, 2> range = {texels[0], texels[0]};
	for (std::size_t i = 0; i < texels.size(); i += 4) {
		range = {std::min(range[0], texels[i]), std::max(range[1], texels[i])};
	}
	std::printf("%-9s values %.7g to %.7g\n", name, double{range[0]}, double{range[1]});
}

} // namespace

std::string run_bake(const std::string &out_path, const std::string &check_path) {
	if (out_path.empty() && check_path.empty()) {
		return "bake: say where to write the tables (OUT) or what to compare with (--check FILE)";
	}
	ProgressBar bar;
	const LensingTables tables = bake_lensing_tables([&bar](double done) { return bar.show(done); });
	if (!out_path.empty()) {
		std::string error = write_file(out_path, as_text(tables));
		if (!error.empty()) {
			return error;
		}
		std::printf("%s: written\n", out_path.c_str());
	}
	return check_path.empty() ? std::string() : compare(tables, check_path);
}

std::string run_inspect(const std::string &path) {
	const Outcome<LensingTables> read = load_table_file(path);
	if (!read) {
		return read.error;
	}
	const LensingTables &tables = *read.value;
	std::printf("file      %s\nformat    version %u, checksums in order\n", path.c_str(), kTableFileVersion);
	std::printf("bytes     %zu\n", write_lensing_tables(tables).size());
	std::printf("sky grid  %d columns x %d rows, 2 tables, RGBA float32\n", tables.columns, tables.rows);
	std::printf("u         %.9g to %.9g, rows uniform in ln u\n", std::exp(tables.ln_u_min),
			std::exp(tables.ln_u_max));
	std::printf("X         -%g to %g, columns uniform in 1/2 + X/(2 sqrt(X^2 + 25))\n", tables.x_limit,
			tables.x_limit);
	std::printf("ray grid  %d columns x %d rows, 2 tables, RGBA float32\n", kRayColumns, kRayRows);
	std::printf("a/a_c     columns uniform in ln(1 + L/0.03), L = -ln|1 - a/a_c| (turning), -ln|1 - a_c/a| "
				"(plunging), 0 to %g\n",
			kRayNearest);
	print_range("inverse R", tables.inverse);
	print_range("forward Q", tables.forward);
	print_range("radius", tables.rays.radius);
	print_range("delay", tables.rays.delay);
	return {};
}

std::string run_verify(const std::string &path, int samples, std::uint64_t seed) {
	Outcome<LensingTables> tables =
			path.empty() ? Outcome<LensingTables>::success(bake_lensing_tables()) : load_table_file(path);
	if (!tables) {
		return tables.error;
	}
	std::printf("%s, %d random rays, seed %llu\n", path.empty() ? "fresh bake" : path.c_str(), samples,
			static_cast<unsigned long long>(seed));
	std::printf("%-38s %11s %11s %11s   largest at\n", "error", "99.9 %", "largest", "limit");
	bool good = true;
	for (const TableError &error : measure_table_errors(*tables.value, samples, seed)) {
		std::printf("%-38s %11.3g %11.3g %11.3g   u = %.6g, Phi = %.6g\n", error.name.c_str(), error.permille,
				error.largest, error.limit, error.u, error.phi);
		good = good && error.largest <= error.limit;
	}
	return good ? "" : "the tables are over their limits. Re-make them with ./run bake.";
}

} // namespace blackhole
