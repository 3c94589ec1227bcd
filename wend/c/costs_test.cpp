// Costs and masks of the C interface, beside the functions of the library that they call.

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "tests/testing/c_objects.hpp"
#include "wend/c/objects.hpp"
#include "wend/map/occupancy.hpp"

namespace wend::test {
namespace {

constexpr wend_pose kCorner{1, 2, 0.5};
const std::vector<std::int8_t> kOccupancies{0, 10, 64, 65, 100, -1};
const std::vector<std::uint8_t> kCosts{0, 63, 252, 253, 254, 255};

void expect_same_map(const Owned<wend_map>& made, const Expected<GridMap, Error>& expected) {
  ASSERT_NE(made, nullptr);
  ASSERT_TRUE(expected);
  EXPECT_EQ(made->map.occupied(), expected->occupied());
  EXPECT_EQ(made->map.unknown(), expected->unknown());
  EXPECT_EQ(made->map.terrain(), expected->terrain());
  EXPECT_EQ(made->map.frame(), expected->frame());
}

Owned<wend_map> costmap_map() {
  return made_object<wend_map>([](wend_map** out, wend_error* error) {
    return wend_map_from_costmap(kCosts.data(), kCosts.size(), 3, 2, 0.5, &kCorner, 4, out, error);
  });
}

TEST(CCosts, ReadOccupancyGridsAndCostmapsAsTheLibraryDoes) {
  const Frame frame{.resolution = 0.5, .origin = {1, 2, 0.5}, .y_up = true, .metric = true};
  const auto grid = made_object<wend_map>([](wend_map** out, wend_error* error) {
    return wend_map_from_occupancy(kOccupancies.data(), kOccupancies.size(), 3, 2, 0.5, &kCorner,
                                   65, 2, out, error);
  });
  expect_same_map(grid, map_from_occupancy(kOccupancies, 3, 2, frame, {65, 2}));
  expect_same_map(costmap_map(), map_from_costmap(kCosts, 3, 2, frame, {4}));
}

TEST(CCosts, LayAMaskOverAMap) {
  const auto map = costmap_map();
  const std::vector<std::int8_t> zones{100, 0, 50};
  const auto mask = made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_from_occupancy(zones.data(), zones.size(), 3, 1, 0.5, &kCorner, 65, 4, out,
                                   error);
  });
  const auto under_it = made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_masked(map.get(), mask.get(), out, error);
  });
  EXPECT_EQ(under_it->map.state({0, 0}), CellState::occupied);
  EXPECT_EQ(under_it->map.terrain({1, 0}), 2);
  EXPECT_EQ(under_it->map.terrain({2, 0}), 15) << "5 of the map, 3 of the mask";
  EXPECT_EQ(map->map.state({0, 0}), CellState::free) << "the map itself does not change";
}

TEST(CCosts, LoadMasksOfBothKinds) {
  const std::string file = testing::TempDir() + "wend_c_mask";
  std::ofstream(file + ".pgm") << "P2 3 1 255 0 50 100\n";
  std::ofstream(file + ".yaml") << "image: " << file << ".pgm\nmode: raw\nresolution: 0.5\n"
                                << "origin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                                << "free_thresh: 0.2\n";
  const auto loaded = [&](const std::string& mask) {
    return made_object<wend_map>([&](wend_map** out, wend_error* error) {
      return wend_mask_load(mask.c_str(), out, error);
    });
  };
  EXPECT_EQ(loaded(file + ".yaml")->map.state({2, 0}), CellState::occupied);
  EXPECT_EQ(loaded("keepout:" + file + ".yaml")->map.terrain({1, 0}), 3);
  EXPECT_EQ(loaded("speed:" + file + ".yaml")->map.terrain({1, 0}), 2);
  EXPECT_EQ(loaded("speed:" + file + ".yaml")->map.state({2, 0}), CellState::free);
}

TEST(CCosts, TakeABufferOrAFunctionOfOnesOwn) {
  const auto map = costmap_map();
  const std::vector<double> terrain{1, 2, 3, 4, 5, 6};
  const auto from_buffer = made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_with_terrain(map.get(), terrain.data(), terrain.size(), out, error);
  });
  EXPECT_EQ(from_buffer->map.terrain({1, 1}), 5);
  EXPECT_EQ(from_buffer->map.state({1, 1}), CellState::occupied);
  double factor = 10;
  const auto cost_of = [](std::int32_t x, std::int32_t y, void* context) {
    return 1 + x + *static_cast<double*>(context) * y;
  };
  const auto from_function = made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_with_costs(map.get(), cost_of, &factor, out, error);
  });
  EXPECT_EQ(from_function->map.terrain({2, 1}), 13);
}

TEST(CCosts, RefuseWhatIsNullAndWhatDoesNotFit) {
  const auto map = costmap_map();
  const std::vector<double> terrain{1, 2, 0.5, 4, 5, 6};
  const auto refusal = [](const auto& make) { return refusal_of<wend_map>(make); };
  const auto with_terrain = [&](const double* values, std::size_t count) {
    return refusal([=, &map](wend_map** out, wend_error* error) {
      return wend_map_with_terrain(map.get(), values, count, out, error);
    });
  };
  EXPECT_EQ(with_terrain(nullptr, 6).status, WEND_INVALID_ARGUMENT);
  EXPECT_EQ(with_terrain(terrain.data(), 5).message, "there are 5 terrain multipliers for 6 cells");
  EXPECT_EQ(with_terrain(terrain.data(), 6).status, WEND_INVALID_MAP);
  const auto occupancy = [](std::int32_t from, double factor) {
    return refusal_of<wend_map>([=](wend_map** out, wend_error* error) {
      return wend_map_from_occupancy(kOccupancies.data(), 6, 3, 2, 0.5, nullptr, from, factor, out,
                                     error);
    });
  };
  EXPECT_EQ(occupancy(101, 0).status, WEND_INVALID_OPTION);
  EXPECT_EQ(occupancy(65, -1).status, WEND_INVALID_OPTION);
  const auto null_mask = refusal([&](wend_map** out, wend_error* error) {
    return wend_map_masked(map.get(), nullptr, out, error);
  });
  EXPECT_EQ(null_mask.message, "mask is null");
  const auto null_function = refusal([&](wend_map** out, wend_error* error) {
    return wend_map_with_costs(map.get(), nullptr, nullptr, out, error);
  });
  EXPECT_EQ(null_function.message, "cost_of is null");
  const auto no_file = refusal(
      [](wend_map** out, wend_error* error) { return wend_mask_load("keepout:", out, error); });
  EXPECT_EQ(no_file.status, WEND_INVALID_OPTION);
  EXPECT_EQ(wend_mask_load(nullptr, nullptr, nullptr), WEND_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace wend::test
