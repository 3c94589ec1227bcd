#include "wend/index/run_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/index/corner_cost.hpp"

namespace wend {
namespace {

struct Straight {
  Direction direction;
  std::size_t steps;
};

/// Runs from (1000, 1000) with positive coordinates only, and their cells after the start.
struct Runs {
  explicit Runs(std::uint64_t seed) {
    Random random(seed);
    Cell at{1000, 1000};
    for (int i = random.between(0, 9); i > 0; --i) {
      const auto direction = static_cast<Direction>(random.below(kDirections));
      const auto steps = static_cast<std::size_t>(random.between(0, 20));
      runs.push_back({direction, steps});
      for (std::size_t k = 0; k < steps; ++k) cells.push_back(at = step(at, direction));
    }
  }

  std::vector<Straight> runs;
  std::vector<Cell> cells;
};

TEST(RunWriter, WritesUpwardsAndDownwardsAndNowhereElse) {
  const Cell nothing{-1, -1};
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Runs path(seed);
    const std::size_t count = path.cells.size();
    std::vector<Cell> written(count + 2, nothing);
    RunWriter<1> upwards(written.data() + 1, count, {1000, 1000});
    for (const Straight run : path.runs) upwards.run(run.direction, run.steps);
    EXPECT_TRUE(std::equal(path.cells.begin(), path.cells.end(), written.begin() + 1));
    EXPECT_TRUE(written.front() == nothing && written.back() == nothing);

    written.assign(count + 2, nothing);
    RunWriter<-1> downwards(written.data() + count, count, {1000, 1000});
    for (const Straight run : path.runs) downwards.run(run.direction, run.steps);
    EXPECT_TRUE(std::equal(path.cells.begin(), path.cells.end(), written.rbegin() + 1));
    EXPECT_TRUE(written.front() == nothing && written.back() == nothing);
  }
}

TEST(RunWriter, StopsWhereThereIsNoRoom) {
  std::vector<Cell> written(12, {-1, -1});
  RunWriter<1> writer(written.data(), 10, {5, 5});
  writer.run(Direction::plus_x, 1000);
  EXPECT_EQ(writer.room(), 0U);
  EXPECT_EQ(written[9], (Cell{15, 5}));
  EXPECT_EQ(written[10], (Cell{-1, -1}));
}

TEST(RunWriter, GoesDiagonallyFirst) {
  for (int dx = -9; dx <= 9; ++dx) {
    for (int dy = -9; dy <= 9; ++dy) {
      const std::size_t count = static_cast<std::size_t>(std::max(std::abs(dx), std::abs(dy)));
      std::vector<Cell> written(count);
      RunWriter<1> writer(written.data(), count, {20, 20});
      writer.go_to({20 + dx, 20 + dy});
      Cell at{20, 20};
      for (const Cell cell : written) {
        at.x += (20 + dx > at.x) - (20 + dx < at.x);
        at.y += (20 + dy > at.y) - (20 + dy < at.y);
        ASSERT_EQ(cell, at) << dx << "," << dy;
      }
    }
  }
}

TEST(OctileSteps, FollowFromTheCost) {
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const OctileSteps steps{static_cast<std::uint32_t>(random.below(20000)),
                            static_cast<std::uint32_t>(random.below(19000))};
    const std::uint64_t cost =
        std::uint64_t{33461} * steps.straight + std::uint64_t{47321} * steps.diagonal;
    ASSERT_LT(cost, kCostsOfOneKindOfPath);
    ASSERT_EQ(octile_steps_of(static_cast<CornerCost>(cost)), steps);
  }
}

}  // namespace
}  // namespace wend
