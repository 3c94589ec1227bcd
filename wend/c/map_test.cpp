#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "conformance/random_map.hpp"
#include "tests/testing/build_paths.hpp"
#include "tests/testing/c_objects.hpp"
#include "wend/c/objects.hpp"

namespace wend::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::uint8_t, 6> kSixCells{0, 1, 2, 0, 0, 0};

/// Why a map of kSixCells, 3 x 2, is refused with these options.
Refusal refused_map(const wend_map_options& options) {
  return refusal_of<wend_map>([&](wend_map** map, wend_error* error) {
    return wend_map_create(kSixCells.data(), kSixCells.size(), 3, 2, &options, map, error);
  });
}

/// Why a map of this size from so many bytes is refused.
Refusal refused_size(std::size_t size, std::int32_t width, std::int32_t height) {
  return refusal_of<wend_map>([&](wend_map** map, wend_error* error) {
    return wend_map_create(kSixCells.data(), size, width, height, nullptr, map, error);
  });
}

TEST(CMap, HasTheCellsTheTerrainAndTheFrameOfItsBytes) {
  for (int seed = 0; seed < 200; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = random_map(random);
    const auto made = c_map(map);
    ASSERT_NE(made, nullptr);
    EXPECT_EQ(made->map.occupied(), map.occupied());
    EXPECT_EQ(made->map.unknown(), map.unknown());
    EXPECT_EQ(made->map.terrain(), map.terrain());
    EXPECT_EQ(wend_map_width(made.get()), map.width());
    EXPECT_EQ(wend_map_height(made.get()), map.height());
    EXPECT_EQ(wend_map_resolution(made.get()), map.frame().resolution);
    wend_pose origin;
    EXPECT_EQ(wend_map_origin(made.get(), &origin, nullptr), WEND_OK);
    EXPECT_EQ((MapPose{origin.x, origin.y, origin.heading}), map.frame().origin);
  }
}

TEST(CMap, ReadsMasks) {
  wend_map_options options = map_options();
  options.cells = WEND_CELLS_MASK;
  const auto map = made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_create(kSixCells.data(), kSixCells.size(), 3, 2, &options, out, error);
  });
  EXPECT_EQ(map->map.state({0, 0}), CellState::free);
  EXPECT_EQ(map->map.state({1, 0}), CellState::occupied);
  EXPECT_EQ(map->map.state({2, 0}), CellState::occupied);
}

TEST(CMap, ReadsOccupancyGridsOfRos) {
  wend_map_options options = map_options();
  options.cells = WEND_CELLS_ROS;
  const std::array<std::int8_t, 6> cells{0, 64, 65, 100, 101, -1};
  const auto states = [&] {
    const auto map = made_object<wend_map>([&](wend_map** out, wend_error* error) {
      return wend_map_create(reinterpret_cast<const std::uint8_t*>(cells.data()), cells.size(), 6,
                             1, &options, out, error);
    });
    return drawing_of(map->map);
  };
  EXPECT_EQ(states(), "..##??\n");
  options.occupied_from = 100;
  EXPECT_EQ(states(), "...#??\n");
}

TEST(CMap, RefusesSizesThatDoNotFit) {
  EXPECT_EQ(refused_size(6, 3, 3).message, "there are 6 bytes for a map of 3 x 3 cells");
  EXPECT_EQ(refused_size(6, 2, 2).status, WEND_INVALID_ARGUMENT);
  EXPECT_EQ(refused_size(0, 0, 2).message, "the map has 0 x 2 cells: at least 1 x 1 expected");
  EXPECT_EQ(refused_size(6, -3, -2).status, WEND_INVALID_ARGUMENT);
  // Its size is 0 in 32 bits, and too large in 64.
  constexpr std::int32_t kHalf = 1 << 16;
  EXPECT_EQ(refused_size(0, kHalf, kHalf).message,
            "the map has 65536 x 65536 cells, more than 1073741824");
  constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(refused_size(std::numeric_limits<std::size_t>::max(), kLargest, kLargest).status,
            WEND_INVALID_ARGUMENT);
}

TEST(CMap, RefusesOtherCells) {
  const std::array<std::uint8_t, 4> cells{0, 0, 0, 3};
  const auto refusal = refusal_of<wend_map>([&](wend_map** map, wend_error* error) {
    return wend_map_create(cells.data(), cells.size(), 2, 2, nullptr, map, error);
  });
  EXPECT_EQ(refusal.message, "cell (1,1) is 3: 0 (free), 1 (occupied) or 2 (unknown) expected");
}

TEST(CMap, RefusesOptionsThatAreOutOfRange) {
  const auto with = [](auto change) {
    wend_map_options options = map_options();
    change(options);
    return refused_map(options);
  };
  const auto kind = with([](auto& options) { options.cells = 3; });
  EXPECT_EQ(kind.message, "wend_map_options.cells is 3, not a value of wend_cells");
  EXPECT_EQ(with([](auto& options) { options.cells = -1; }).status, WEND_INVALID_ARGUMENT);
  for (const std::int32_t least : {0, 101, -1}) {
    const auto from = with([&](auto& options) { options.occupied_from = least; });
    EXPECT_EQ(from.status, WEND_INVALID_ARGUMENT);
  }
  for (const double resolution :
       {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity(), 1e12, 1e307, 1e-300}) {
    const auto size = with([&](auto& options) { options.resolution = resolution; });
    EXPECT_EQ(size.status, WEND_INVALID_MAP);
  }
  EXPECT_EQ(with([](auto& options) { options.origin.heading = kNaN; }).message,
            "the origin contains NaN or infinity");
  const auto older = with([](auto& options) { options.struct_size -= 8; });
  EXPECT_EQ(older.status, WEND_INVALID_ARGUMENT);
  EXPECT_TRUE(std::string_view(older.message).starts_with("wend_map_options.struct_size is "));
}

TEST(CMap, RefusesTerrainThatDoesNotFit) {
  std::array<double, 6> terrain{1, 1, 2, 1, 1, 1};
  wend_map_options options = map_options();
  options.terrain_count = 6;
  EXPECT_EQ(refused_map(options).message,
            "wend_map_options.terrain is null, but terrain_count is not 0");
  options.terrain = terrain.data();
  options.terrain_count = 5;
  EXPECT_EQ(refused_map(options).message, "there are 5 terrain multipliers for 6 cells");
  options.terrain_count = 6;
  for (const double multiplier : {0.5, kNaN, std::numeric_limits<double>::infinity()}) {
    terrain[2] = multiplier;
    EXPECT_EQ(refused_map(options).status, WEND_INVALID_MAP);
  }
}

TEST(CMap, RefusesNullPointers) {
  const auto no_cells = refusal_of<wend_map>([](wend_map** map, wend_error* error) {
    return wend_map_create(nullptr, 6, 3, 2, nullptr, map, error);
  });
  EXPECT_EQ(no_cells.message, "cells is null");
  const auto no_file = refusal_of<wend_map>(
      [](wend_map** map, wend_error* error) { return wend_map_load(nullptr, map, error); });
  EXPECT_EQ(no_file.message, "file is null");
  const auto no_bytes = refusal_of<wend_map>([](wend_map** map, wend_error* error) {
    return wend_map_parse(nullptr, 4, "m.txt", map, error);
  });
  EXPECT_EQ(no_bytes.message, "bytes is null");
  const auto no_name = refusal_of<wend_map>([](wend_map** map, wend_error* error) {
    return wend_map_parse("....", 4, nullptr, map, error);
  });
  EXPECT_EQ(no_name.message, "name is null");
  wend_error error;
  EXPECT_EQ(wend_map_create(kSixCells.data(), 6, 3, 2, nullptr, nullptr, &error),
            WEND_INVALID_ARGUMENT);
  EXPECT_STREQ(error.message, "map is null");
  EXPECT_EQ(wend_map_width(nullptr), 0);
  EXPECT_EQ(wend_map_height(nullptr), 0);
  EXPECT_EQ(wend_map_resolution(nullptr), 0);
  wend_pose origin;
  EXPECT_EQ(wend_map_origin(nullptr, &origin, nullptr), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_map_origin(open_c_map(1, 1).get(), nullptr, nullptr), WEND_INVALID_ARGUMENT);
  wend_map_free(nullptr);
}

TEST(CMap, ReadsFilesAndTheirBytes) {
  constexpr std::string_view kText = "..#\n...\n";
  const auto map = made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_parse(kText.data(), kText.size(), "m.txt", out, error);
  });
  EXPECT_EQ(drawing_of(map->map), kText);
  EXPECT_EQ(wend_map_resolution(map.get()), 1);
  const auto damaged = refusal_of<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_parse(kText.data(), kText.size() - 2, "m.txt", out, error);
  });
  EXPECT_EQ(damaged.status, WEND_INVALID_FILE);
  EXPECT_TRUE(std::string_view(damaged.message).starts_with("m.txt:2: "));
  const auto too_long = refusal_of<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_parse(kText.data(), std::numeric_limits<std::size_t>::max(), "m", out, error);
  });
  EXPECT_EQ(too_long.status, WEND_INVALID_ARGUMENT);
  const std::string folder = source_folder() / "tests/install_consumer/";
  const auto loaded = made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_load((folder + "wall.txt").c_str(), out, error);
  });
  EXPECT_EQ(wend_map_width(loaded.get()), 10);
  const auto missing = refusal_of<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_load((folder + "none.txt").c_str(), out, error);
  });
  EXPECT_EQ(missing.status, WEND_INVALID_FILE);
}

}  // namespace
}  // namespace wend::test
