// SPDX-License-Identifier: MIT
#include "lut_cli/reference_columns.h"

#include "core/disk/page_thorne.h"
#include "core/relativity/star_image.h"
#include "lut_cli/disk_columns.h"
#include "lut_cli/ray_columns.h"

#include <cmath>
#include <numbers>

namespace blackhole {
namespace {

using Inputs = std::span<const double>;

std::string reject_place(Inputs in) {
	return in[0] > 0.0 ? "" : "u_o = r_s/r must be > 0";
}

std::string reject_inverse(Inputs in) {
	return !(in[1] > 0.0 && in[1] <= 300.0) ? "Phi must be > 0 and at most 300 rad" : reject_place(in);
}

std::string reject_forward(Inputs in) {
	return !(in[1] > 0.0 && in[1] < std::numbers::pi) ? "xi must lie between 0 and pi" : reject_place(in);
}

std::string reject_images(Inputs in) {
	if (!(in[1] >= 0.0 && in[1] <= std::numbers::pi)) {
		return "phi must lie between 0 and pi";
	}
	if (!(in[2] >= 0.0 && in[2] <= kMaxImageOrder && in[2] == std::floor(in[2]))) {
		return "order must be a whole number from 0 to " + std::to_string(kMaxImageOrder);
	}
	return reject_place(in);
}

std::string reject_rings(Inputs in) {
	const bool whole = in[1] >= 1.0 && in[1] <= kMaxImageOrder && in[1] == std::floor(in[1]);
	return !whole ? "n must be a whole number from 1 to " + std::to_string(kMaxImageOrder) : reject_place(in);
}

std::string reject_gshift(Inputs in) {
	if (!(in[0] > 0.0 && in[0] < 2.0 / 3.0)) {
		return "u_o must lie between 0 and 2/3, where there is a circular orbit";
	}
	if (!(in[1] > 0.0 && in[1] < std::numbers::pi)) {
		return "xi must lie between 0 and pi";
	}
	return std::isfinite(in[2]) ? "" : "psi must be a number";
}

std::string reject_disk(Inputs in) {
	if (!(in[1] >= 0.0 && in[1] <= std::numbers::pi)) {
		return "inc must lie between 0 and pi";
	}
	if (!(in[2] > 0.0 && in[2] < std::numbers::pi)) {
		return "xi must lie between 0 and pi";
	}
	return std::isfinite(in[3]) ? reject_place(in) : "psi must be a number";
}

std::string reject_radius(Inputs in) {
	return in[0] > 0.0 ? "" : "r must be > 0";
}

std::string reject_plunging(Inputs in) {
	if (!(in[0] > 0.0 && in[0] <= kInnermostStable)) {
		return "r must be > 0 and at most 3, the last stable orbit";
	}
	if (!(in[1] > 0.0)) {
		return "a = r_s/b must be > 0";
	}
	if (!(in[2] >= -1.0 && in[2] <= 1.0)) {
		return "tilt must lie between -1 and 1";
	}
	return in[3] == 0.0 || in[3] == 1.0 ? "" : "outgoing must be 0 or 1";
}

std::string reject_deflection(Inputs in) {
	return in[0] > 0.0 ? "" : "b must be > 0";
}

} // namespace

const std::vector<ReferenceKind> &reference_kinds() {
	static const std::vector<ReferenceKind> kinds = {
			{"inverse_static", 2,
					{"u_o", "Phi", "sigma", "sigma_minus_crit", "a", "xi_rain", "xi_rain_minus_shadow",
							"dxi_rain_dPhi", "mu_rain", "g_rain", "xi_static", "xi_static_minus_shadow",
							"dxi_static_dPhi", "mu_static"},
					reject_inverse, ray_columns::inverse_static},
			{"inverse_rain", 2,
					{"u_o", "Phi", "sigma", "sigma_minus_crit", "a", "xi_rain", "xi_rain_minus_shadow",
							"dxi_rain_dPhi", "mu_rain", "g_rain"},
					reject_inverse, ray_columns::inverse_rain},
			{"forward_static", 2, {"u_o", "xi_static", "xi_minus_shadow", "Phi", "dPhi_dxi", "a", "sigma"},
					reject_forward, ray_columns::forward_static},
			{"forward_rain", 2,
					{"u_o", "xi_rain", "xi_minus_shadow", "Phi", "dPhi_dxi", "a", "sigma", "g_rain"},
					reject_forward, ray_columns::forward_rain},
			{"images", 3,
					{"u_o", "phi", "order", "Phi", "side", "xi_rain", "mu_rain", "g_rain", "xi_static",
							"mu_static", "g_static"},
					reject_images, ray_columns::images},
			{"rings", 2, {"u_o", "n", "xi_rain", "xi_rain_minus_shadow", "xi_static", "a"}, reject_rings,
					ray_columns::rings},
			{"shadow", 1, {"u_o", "xi_shadow_rain", "xi_shadow_static"}, reject_place, ray_columns::shadow},
			{"gshift", 3,
					{"u_o", "xi_static", "psi", "g_static", "xi_rain", "g_rain", "v_circ", "d1", "g_circ"},
					reject_gshift, ray_columns::gshift},
			{"deflection", 1, {"b", "b_over_bc_minus_1", "alpha", "alpha_weak4", "alpha_strong", "r_min"},
					reject_deflection, ray_columns::deflection},
			{"disk_static", 4, {"u_o", "inc", "xi", "psi", "r0", "g0", "r1", "g1", "r2", "g2"}, reject_disk,
					disk_columns::disk_static},
			{"disk_rain", 4, {"u_o", "inc", "xi", "psi", "r0", "g0", "r1", "g1", "r2", "g2"}, reject_disk,
					disk_columns::disk_rain},
			{"page_thorne", 1, {"r", "F_shape", "F_rel", "T_rel"}, reject_radius, disk_columns::page_thorne},
			{"plunging_gas", 4, {"r", "a", "tilt", "outgoing", "redshift"}, reject_plunging,
					disk_columns::plunging_gas},
	};
	return kinds;
}

const ReferenceKind *find_reference_kind(const std::string &name) {
	for (const ReferenceKind &kind : reference_kinds()) {
		if (kind.name == name) {
			return &kind;
		}
	}
	return nullptr;
}

Outcome<std::vector<std::vector<double>>> reference_inputs(const ReferenceKind &kind, const CsvTable &table) {
	using Result = Outcome<std::vector<std::vector<double>>>;
	std::vector<std::vector<double>> rows(table.row_count());
	for (std::size_t input = 0; input < kind.input_count; ++input) {
		const auto column = table.column(kind.columns[input], true);
		if (!column) {
			return Result::failure(column.error);
		}
		for (std::size_t row = 0; row < rows.size(); ++row) {
			rows[row].push_back((*column.value)[row]);
		}
	}
	for (std::size_t row = 0; row < rows.size(); ++row) {
		const std::string complaint = kind.reject(rows[row]);
		if (!complaint.empty()) {
			return Result::failure(
					table.name() + " line " + std::to_string(table.line_of(row)) + ": " + complaint);
		}
	}
	return Result::success(std::move(rows));
}

} // namespace blackhole
