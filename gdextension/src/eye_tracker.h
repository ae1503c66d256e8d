// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>

/// How finely, and whether at all, a picture shows what is at an angle [rad] from a direction.
class PixelGain {
public:
	/// Largest Omega_ref/Omega_px of what is within `reach` of the direction.
	double operator()(double reach) const;
	/// Whether something between these two angles from it can be in the picture.
	bool shows(double from, double to) const;

private:
	friend struct WatchingEye;
	double axis_gain = 1.0;
	double corner_cosine = 1.0;
	double angle = -1.0; ///< of the direction from the axis; negative where that is not known
	bool everywhere = false;
};

/// From where, and how finely, a viewport looks at its world.
struct WatchingEye {
	glm::dvec3 place{0.0};      ///< world
	glm::dvec3 axis{0.0};       ///< unit viewing direction, world; 0 when it is not known
	double axis_gain = 1.0;     ///< Omega_ref/Omega_px on the axis: luminance of a star over reference
	double corner_cosine = 1.0; ///< of the angle between the axis and the picture's corners
	double wobble = 0.0;        ///< how far from `place` the true eyes may be, world units
	bool everywhere = false;    ///< what is outside of its picture is seen as well, mirrored in something
	uint64_t viewport = 0;      ///< instance that the picture is for
	uint64_t camera = 0;        ///< instance through which it looks

	bool operator==(const WatchingEye &) const = default;

	/// How finely it looks round a direction (world).
	PixelGain pixel_gain(const glm::dvec3 &towards) const;
	/// Largest angle that a pixel spans, radians.
	double pixel_angle() const;
};

/// Knows every viewport of the scene tree, and so from where a world is being looked at in this frame.
class EyeTracker {
public:
	/// Collects the viewports and reflection probes below a node, itself included.
	void scan(godot::Node *root);
	void add(godot::Node *node);
	void remove(godot::Node *node);
	void clear();

	/// The current cameras of `world` that see any of the render layers. The vector is reused: no allocation
	/// once it has its size.
	const std::vector<WatchingEye> &eyes_in(const godot::Ref<godot::World3D> &world, uint32_t layers);

private:
	bool is_mirrored(const godot::Ref<godot::World3D> &world, uint32_t layers) const;

	std::vector<uint64_t> viewports;
	std::vector<uint64_t> probes;
	std::vector<WatchingEye> eyes;
};
