#include "wend/map/cost_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "wend/base/random.hpp"

namespace wend {
namespace {

template <class StepsOf>
CostMap costs_of(int width, int height, StepsOf&& steps_of) {
  return CostMap(width, height, [&](int y, std::span<std::uint32_t> steps) {
    for (int x = 0; x < width; ++x) steps[static_cast<std::size_t>(x)] = steps_of(Cell{x, y});
  });
}

TEST(CostMap, RoundsToTheNearestStepAndAHalfUp) {
  EXPECT_EQ(CostMap::rounded(1), 256U);
  EXPECT_EQ(CostMap::rounded(0.5), 256U) << "the least";
  EXPECT_EQ(CostMap::rounded(1.5), 384U);
  EXPECT_EQ(CostMap::rounded(1 + 0.5 / 256), 257U);
  EXPECT_EQ(CostMap::rounded(1 + 0.499 / 256), 256U);
  EXPECT_EQ(CostMap::rounded(CostMap::kLargest), CostMap::kMost);
  EXPECT_FALSE(CostMap::rounded(CostMap::kLargest + 1));
  EXPECT_FALSE(CostMap::rounded(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(CostMap::rounded(std::nan("")));
}

TEST(CostMap, IsOffByAtMostHalfAStep) {
  Random random(7);
  for (int i = 0; i < 10'000; ++i) {
    const double multiplier = std::exp(random.uniform() * 16);
    const auto steps = CostMap::rounded(multiplier);
    ASSERT_TRUE(steps);
    ASSERT_NEAR(*steps / 256.0, multiplier, 0.5 / 256) << multiplier;
  }
}

TEST(CostMap, TakesNoMemoryWhereEveryCellCostsOne) {
  const CostMap costs = costs_of(3, 2, [](Cell) { return 256U; });
  EXPECT_TRUE(costs.uniform());
  EXPECT_EQ(costs.bytes_per_cell(), 0U);
  EXPECT_EQ(costs.steps({2, 1}), 256U);
  EXPECT_EQ(costs, CostMap());
}

TEST(CostMap, TakesTwoBytesUnlessACostNeedsMore) {
  const auto with = [](std::uint32_t most) {
    return costs_of(3, 2, [most](Cell cell) { return cell == Cell{1, 1} ? most : 300U; });
  };
  EXPECT_EQ(with(65535).bytes_per_cell(), 2U);
  EXPECT_EQ(with(65536).bytes_per_cell(), 4U);
  EXPECT_EQ(with(65535).steps({1, 1}), 65535U);
  EXPECT_EQ(with(CostMap::kMost).steps({1, 1}), CostMap::kMost);
  EXPECT_EQ(with(CostMap::kMost).multiplier({1, 1}), CostMap::kLargest);
  EXPECT_EQ(with(65536).multiplier({0, 0}), 300.0 / 256);
}

/// After any changes it equals one that is made at once.
TEST(CostMap, EqualsOneMadeAtOnceAfterAnyChanges) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int width = random.between(1, 6);
    const int height = random.between(1, 6);
    Grid<std::uint32_t> expected(width, height, 256);
    CostMap costs = costs_of(width, height, [&](Cell cell) { return expected[cell]; });
    for (int change = 0; change < 40; ++change) {
      const int x = random.between(0, width - 1);
      const int y = random.between(0, height - 1);
      const bool far = random.chance(0.1);
      const auto steps = static_cast<std::uint32_t>(random.between(256, far ? 100'000 : 259));
      costs.set({x, y}, steps);
      expected[{x, y}] = steps;
      const CostMap made = costs_of(width, height, [&](Cell cell) { return expected[cell]; });
      ASSERT_EQ(costs, made);
      ASSERT_EQ(costs.uniform(), made.uniform());
      costs.set({x, y}, steps + 1);
      ASSERT_NE(costs, made);
      costs.set({x, y}, steps);
    }
  }
}

}  // namespace
}  // namespace wend
