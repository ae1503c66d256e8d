// SPDX-License-Identifier: MIT
// blackhole-lut: bakes, inspects and verifies the lensing tables, and evaluates the exact solution.
#include "lut_cli/eval_command.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>

int main(int argc, char **argv) {
	CLI::App app("Lensing tables of a Schwarzschild black hole", "blackhole-lut");
	app.set_version_flag("--version", "blackhole-lut " BLACKHOLE_VERSION);
	app.require_subcommand(1);
	std::string error;

	std::string eval_name;
	std::string eval_in;
	std::string eval_out;
	CLI::App *eval = app.add_subcommand("eval", "Evaluate a reference table's columns from its inputs");
	eval->add_option("NAME", eval_name,
				"inverse_static, inverse_rain, forward_static, forward_rain, images, rings, "
				"shadow or deflection")
			->required();
	eval->add_option("IN.csv", eval_in, "Inputs, found by their column headers")->required();
	eval->add_option("OUT.csv", eval_out, "All columns, 17 digits")->required();
	eval->callback([&] { error = blackhole::run_eval(eval_name, eval_in, eval_out); });

	CLI11_PARSE(app, argc, argv);
	if (!error.empty()) {
		std::cerr << "blackhole-lut: " << error << '\n';
		return 1;
	}
	return 0;
}
