// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include "core/tables/lensing_tables.h"

/// The small tables from which the shaders bend light (star -> direction, direction -> sky, ray -> radius and
/// delay), read from a .lut file or baked on a worker thread, and the exact solution they approximate.
class LensingTable : public godot::Resource {
	GDCLASS(LensingTable, godot::Resource)

	godot::String source_file;
	godot::String error_message;
	std::shared_ptr<const blackhole::LensingTables> tables;
	godot::Ref<godot::ImageTexture> inverse_texture;
	godot::Ref<godot::ImageTexture> forward_texture;
	godot::Ref<godot::ImageTexture> radius_texture;
	godot::Ref<godot::ImageTexture> delay_texture;

	std::thread worker;
	std::mutex baked_mutex;
	std::optional<blackhole::LensingTables> baked;
	std::atomic<double> bake_progress = 1.0;
	std::atomic<bool> bake_cancelled = false;
	bool baking = false;

	godot::Error refuse(const godot::String &message, godot::Error error);
	void adopt(blackhole::LensingTables &&p_tables);
	void forget();
	void finish_bake();

protected:
	static void _bind_methods();

public:
	/// How observers move. The last three need more to be known: see SkyObserver.
	enum Motion : int {
		MOTION_STATIC = 0,
		MOTION_RAIN = 1,
		MOTION_INFALL = 2,
		MOTION_ORBIT = 3,
		MOTION_VELOCITY = 4,
	};

	~LensingTable() override;

	void set_source_file(const godot::String &path);
	godot::String get_source_file() const { return source_file; }

	godot::Error load_file(const godot::String &path);
	godot::Error save_file(const godot::String &path) const;
	void bake();
	void cancel_bake();
	bool is_baking() const { return baking; }
	double get_bake_progress() const { return bake_progress; }
	bool is_ready() const { return tables != nullptr; }
	godot::String get_error_message() const { return error_message; }

	godot::Ref<godot::ImageTexture> get_inverse_texture() const { return inverse_texture; }
	godot::Ref<godot::ImageTexture> get_forward_texture() const { return forward_texture; }
	godot::Ref<godot::ImageTexture> get_radius_texture() const { return radius_texture; }
	godot::Ref<godot::ImageTexture> get_delay_texture() const { return delay_texture; }

	godot::PackedFloat32Array get_inverse_texels() const;
	godot::PackedFloat32Array get_forward_texels() const;

	static double shadow_angle(double radius, Motion motion);
	static godot::Dictionary star_image(
			const godot::Vector3 &position, const godot::Vector3 &star, int order, Motion motion);
	static godot::Dictionary trace(
			const godot::Vector3 &position, const godot::Vector3 &view_direction, Motion motion);

	/// The table values themselves; null before anything was loaded or baked.
	const std::shared_ptr<const blackhole::LensingTables> &data() const { return tables; }
};

VARIANT_ENUM_CAST(LensingTable::Motion);
