// SPDX-License-Identifier: MIT
#include "core/overlay/figure_field.h"

#include "core/overlay/cube_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

namespace blackhole {
namespace {

/// Texels along the edge of the squares that share a list of near segments.
constexpr int kTile = 16;
/// How far a unit vector's length may be off, and how close an arc may come to half a turn.
constexpr double kTolerance = 1e-5;

std::string fault_of(const SkySegment &segment) {
	for (const glm::dvec3 &end : {segment.from, segment.to}) {
		// Written so that NaN is refused as well.
		if (!(std::abs(glm::length(end) - 1.0) < kTolerance)) {
			return "an end is no unit vector";
		}
	}
	return glm::dot(segment.from, segment.to) < -1.0 + kTolerance ? "its ends lie opposite each other" : "";
}

std::string fault_of(const std::vector<SkySegment> &segments, int size, double reach) {
	if (size < 8 || size > 4096) {
		return "The figures' field needs 8 to 4096 texels a side, not " + std::to_string(size) + ".";
	}
	if (!(reach > 0.0 && reach <= 0.5)) {
		return "The figures' field needs a reach above 0 and up to 0.5 radians, not " +
				std::to_string(reach) + ".";
	}
	for (std::size_t i = 0; i < segments.size(); ++i) {
		if (const std::string fault = fault_of(segments[i]); !fault.empty()) {
			return "Segment " + std::to_string(i) + " of the figures cannot be drawn: " + fault + ".";
		}
	}
	return {};
}

/// A square part of a face, columns and rows from the first to before the last.
struct Tile {
	int face = 0;
	int columns[2] = {0, 0};
	int rows[2] = {0, 0};
	glm::dvec3 centre{0.0};
	double radius = 0.0; ///< radians; every texel lies within it of the centre

	Tile(int p_face, int column, int row, int size)
			: face(p_face), columns{column, std::min(column + kTile, size)}, rows{row,
																					 std::min(row + kTile,
																							 size)} {
		const auto place = [size](int edge) { return 2.0 * edge / size - 1.0; };
		centre = glm::normalize(cube_point(face, 0.5 * (place(columns[0]) + place(columns[1])),
				0.5 * (place(rows[0]) + place(rows[1]))));
		for (const int column_edge : columns) {
			for (const int row_edge : rows) {
				const glm::dvec3 corner = cube_point(face, place(column_edge), place(row_edge));
				radius = std::max(radius, std::acos(std::min(1.0, glm::dot(centre, glm::normalize(corner)))));
			}
		}
	}
};

class Baker {
public:
	Baker(const std::vector<SkySegment> &segments, int size, double reach)
			: _field{size, reach, 1.5 / size, {}}, _segments(segments.begin(), segments.end()) {
		_field.texels.resize(std::size_t{4} * kCubeFaces * size * size);
	}

	/// Fills a row of tiles.
	void bake_tiles(int face, int row) {
		for (int column = 0; column < _field.size; column += kTile) {
			bake_tile(Tile(face, column, row, _field.size));
		}
	}

	FigureField take() { return std::move(_field); }

private:
	/// Lists the segments that may be the nearest one of any texel of the tile.
	void find_near(const Tile &tile) {
		_near.clear();
		_angles.clear();
		double nearest = std::numbers::pi;
		for (const SegmentDistance &segment : _segments) {
			_angles.push_back(std::acos(std::min(1.0, segment.cosine(tile.centre))));
			nearest = std::min(nearest, _angles.back());
		}
		const double limit = std::min(_field.reach + tile.radius, nearest + 2.0 * tile.radius) + 1e-7;
		for (std::size_t i = 0; i < _segments.size(); ++i) {
			if (_angles[i] <= limit) {
				_near.push_back(&_segments[i]);
			}
		}
	}

	void bake_tile(const Tile &tile) {
		find_near(tile);
		for (int row = tile.rows[0]; row < tile.rows[1]; ++row) {
			for (int column = tile.columns[0]; column < tile.columns[1]; ++column) {
				bake_texel(tile.face, column, row);
			}
		}
	}

	void bake_texel(int face, int column, int row) {
		const std::size_t place = (std::size_t(face) * _field.size + row) * _field.size + column;
		float *texel = _field.texels.data() + 4 * place;
		const glm::dvec3 direction = texel_direction(face, column, row, _field.size);
		const SegmentDistance *nearest = nullptr;
		double cosine = std::cos(_field.reach);
		for (const SegmentDistance *segment : _near) {
			if (const double here = segment->cosine(direction); here > cosine) {
				cosine = here;
				nearest = segment;
			}
		}
		const glm::dvec3 vector =
				nearest ? nearest->nearest_point(direction) - direction : _field.reach * direction;
		for (int axis = 0; axis < 3; ++axis) {
			texel[axis] = static_cast<float>(vector[axis]);
		}
		texel[3] = static_cast<float>(glm::length(vector));
	}

	FigureField _field;
	std::vector<SegmentDistance> _segments;
	std::vector<const SegmentDistance *> _near;
	std::vector<double> _angles;
};

} // namespace

Outcome<FigureField> bake_figure_field(const std::vector<SkySegment> &segments, int size, double reach,
		const std::function<bool(double)> &progress) {
	if (const std::string fault = fault_of(segments, size, reach); !fault.empty()) {
		return Outcome<FigureField>::failure(fault);
	}
	const auto cancelled = [&progress](double part) { return progress && !progress(part); };
	Baker baker(segments, size, reach);
	for (int face = 0; face < kCubeFaces; ++face) {
		for (int row = 0; row < size; row += kTile) {
			if (cancelled((face + double(row) / size) / kCubeFaces)) {
				return Outcome<FigureField>::failure("The figures' field was cancelled.");
			}
			baker.bake_tiles(face, row);
		}
	}
	if (cancelled(1.0)) {
		return Outcome<FigureField>::failure("The figures' field was cancelled.");
	}
	return Outcome<FigureField>::success(baker.take());
}

} // namespace blackhole
