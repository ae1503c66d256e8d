// SPDX-License-Identifier: MIT
// blackhole-lut: bakes, inspects and verifies the lensing tables, and evaluates the exact solution.
#include "lut_cli/eval_command.h"
#include "lut_cli/table_commands.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <exception>
#include <iostream>
#include <string>

namespace {

struct Arguments {
	std::string path;
	std::string check;
	std::string name;
	std::string in;
	std::string out;
	std::string table;
	int samples = 200000;
	std::uint64_t seed = 1;
};

void add_commands(CLI::App &app, Arguments &arguments, std::string &error) {
	CLI::App *bake = app.add_subcommand("bake", "Compute the tables and write them to a file");
	bake->add_option("OUT", arguments.path, "The file to write (may be left out with --check)");
	bake->add_option("--check", arguments.check, "Compare with this file; exit 1 where it differs");
	bake->callback([&] { error = blackhole::run_bake(arguments.path, arguments.check); });

	CLI::App *inspect = app.add_subcommand("inspect", "Print what a table file holds");
	inspect->add_option("FILE", arguments.path, "The table file")->required();
	inspect->callback([&] { error = blackhole::run_inspect(arguments.path); });

	CLI::App *verify = app.add_subcommand("verify", "Measure a table file against the exact solution");
	verify->add_option("FILE", arguments.path, "The table file; left out: a fresh bake");
	verify->add_option("--samples", arguments.samples, "How many random rays")
			->check(CLI::Range(1, 100000000))
			->capture_default_str();
	verify->add_option("--seed", arguments.seed, "Seed of the random rays")->capture_default_str();
	verify->callback(
			[&] { error = blackhole::run_verify(arguments.path, arguments.samples, arguments.seed); });

	CLI::App *eval = app.add_subcommand("eval", "Evaluate a reference table's columns from its inputs");
	eval->add_option("NAME", arguments.name,
				"inverse_static, inverse_rain, forward_static, forward_rain, images, rings, shadow, "
				"deflection, gshift, disk_static, disk_rain, page_thorne or plunging_gas")
			->required();
	eval->add_option("IN.csv", arguments.in, "Inputs, found by their column headers")->required();
	eval->add_option("OUT.csv", arguments.out, "Where all columns go, with 17 digits")->required();
	eval->add_option("--table", arguments.table,
			"Take the rays from this table file as the shaders do, instead of the exact solution");
	eval->callback([&] {
		error = blackhole::run_eval(arguments.name, arguments.in, arguments.out, arguments.table);
	});
}

int run(int argc, char **argv) {
	CLI::App app("Lensing tables of a Schwarzschild black hole", "blackhole-lut");
	app.set_version_flag("--version", "blackhole-lut " BLACKHOLE_VERSION);
	app.require_subcommand(1);
	Arguments arguments;
	std::string error;
	add_commands(app, arguments, error);
	CLI11_PARSE(app, argc, argv);
	if (error.empty()) {
		return 0;
	}
	std::cerr << "blackhole-lut: " << error << '\n';
	return 1;
}

} // namespace

int main(int argc, char **argv) {
	try {
		return run(argc, argv);
	} catch (const std::exception &exception) { // out of memory and the like
		std::cerr << "blackhole-lut: " << exception.what() << '\n';
		return 1;
	}
}
