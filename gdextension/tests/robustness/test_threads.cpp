// SPDX-License-Identifier: MIT
// What works on several threads, as the Godot classes use it: for the thread sanitizer above all.
#include <atomic>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "core/culling/star_groups.h"
#include "core/culling/star_rows.h"
#include "core/parallel.h"
#include "core/tables/lensing_tables.h"
#include "core/tables/table_axis.h"

namespace blackhole::test {
namespace {

constexpr double kNever = 2.0;

/// Bakes on a thread of its own, as LensingTable does; from a part done on it waits to be cancelled.
class Baker {
public:
	explicit Baker(double p_waits_at = kNever) : m_thread([this, p_waits_at] { bake(p_waits_at); }) {}
	~Baker() {
		cancelled = true;
		m_thread.join();
	}
	Baker(const Baker &) = delete;
	Baker &operator=(const Baker &) = delete;

	/// The tables once they are there, empty when cancelled.
	std::optional<LensingTables> taken() {
		const std::lock_guard lock(m_guard);
		return std::exchange(m_made, std::nullopt);
	}

	std::atomic<double> progress = 0.0;
	std::atomic<bool> cancelled = false;
	std::atomic<bool> done = false;

private:
	void bake(double p_waits_at) {
		LensingTables made = bake_lensing_tables([this, p_waits_at](double p_done) {
			progress = p_done;
			while (p_done >= p_waits_at && !cancelled) {
				std::this_thread::yield();
			}
			return !cancelled;
		});
		{
			const std::lock_guard lock(m_guard);
			m_made = std::move(made);
		}
		done = true;
	}

	std::mutex m_guard;
	std::optional<LensingTables> m_made;
	std::thread m_thread;
};

TEST(Threads, BakesSideBySideGiveTheSame) {
	Baker first;
	Baker second;
	while (!first.done || !second.done) {
		std::this_thread::yield();
	}
	const auto a = first.taken();
	const auto b = second.taken();
	ASSERT_TRUE(a && b);
	EXPECT_EQ(a->columns, kTableColumns);
	EXPECT_EQ(a->inverse, b->inverse);
	EXPECT_EQ(a->ray_texels.radius, b->ray_texels.radius);
}

TEST(Threads, ABakeIsCancelledAtAnyMoment) {
	for (const double moment : {0.0, 0.01, 0.3, 0.7}) {
		Baker baker(moment);
		while (baker.progress < moment) {
			std::this_thread::yield();
		}
		baker.cancelled = true;
		while (!baker.done) {
			std::this_thread::yield();
		}
		EXPECT_EQ(baker.taken()->columns, 0) << moment;
	}
}

TEST(Threads, ABakerMayGoWhileItBakes) {
	const Baker baker;
	SUCCEED();
}

TEST(Threads, ParallelPiecesAreAllOfIt) {
	std::vector<int> visits(100000, 0);
	parallel_for(visits.size(), 100, [&](std::size_t p_first, std::size_t p_end) {
		for (std::size_t i = p_first; i < p_end; ++i) {
			++visits[i];
		}
	});
	EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), std::ptrdiff_t(visits.size()));
}

TEST(Threads, StarsAreGroupedAndPacked) {
	StarTable table;
	for (int i = 0; i < 60000; ++i) {
		Star star;
		star.right_ascension = 0.0001 * i;
		star.declination = 1.5 * std::sin(0.37 * i);
		star.v_magnitude = static_cast<float>(2.0 + 0.0001 * i);
		table.stars.push_back(star);
	}
	const PlanckTable planck;
	const auto directions = star_directions(table);
	const auto groups = group_stars(table, directions, planck);
	std::vector<std::vector<float>> rows(groups.size());
	parallel_for(groups.size(), 8, [&](std::size_t p_first, std::size_t p_end) {
		for (std::size_t i = p_first; i < p_end; ++i) {
			rows[i].resize(kFloatsPerStar * groups[i].stars.size());
			pack_rows(table, directions, groups[i], planck, rows[i].data());
		}
	});
	std::size_t floats = 0;
	for (const auto &row : rows) {
		floats += row.size();
		EXPECT_TRUE(
				std::all_of(row.begin(), row.end(), [](float p_value) { return std::isfinite(p_value); }));
	}
	EXPECT_EQ(floats, kFloatsPerStar * table.stars.size());
}

} // namespace
} // namespace blackhole::test
