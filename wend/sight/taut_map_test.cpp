// What cells look up in a TautMap against what they see by a sweep.

#include "wend/sight/taut_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "tests/testing/random_cells.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

std::shared_ptr<const Portals> portals_of(const BitGrid& free, bool gaps) {
  const auto any = [](Cell, Cell) { return true; };
  return std::make_shared<const Portals>(free, gaps ? Portals::OpenGap(any) : Portals::OpenGap());
}

TEST(TautMap, TellsTheCornersThatASweepFinds) {
  std::size_t corners = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(200U) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const BitGrid free = test::random_cells(random, 40, 0.5);
    const bool gaps = random.chance(0.5);
    const auto portals = portals_of(free, gaps);
    const auto map = TautMap::make(portals, TautMap::usual_most_bytes(*portals));
    ASSERT_NE(map, nullptr);
    CornerSweep sweep(*portals);
    for (const Cell cell : every_cell(free)) {
      if (!free[cell]) continue;
      std::vector<std::uint32_t> swept;
      sweep.from_point(SightPoint::centre(cell),
                       [&](std::uint32_t corner, Ray) { swept.push_back(corner); });
      std::ranges::sort(swept);
      std::vector<std::uint32_t> looked_up;
      map->for_each_seen(cell, [&](std::uint32_t corner) { looked_up.push_back(corner); });
      EXPECT_EQ(looked_up, swept) << cell.x << ',' << cell.y;
      corners += swept.size();
    }
  }
  EXPECT_GT(corners, test::share_of(10'000U));
}

TEST(TautMap, KnowsTheEdgesThatAGraphLearns) {
  for (std::uint64_t seed = 1; seed <= 100 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto portals = portals_of(test::random_cells(random, 40, 0.5), random.chance(0.5));
    const auto map = TautMap::make(portals, TautMap::usual_most_bytes(*portals));
    ASSERT_NE(map, nullptr);
    TautGraph graph(portals);
    for (std::uint32_t corner = 0; corner < portals->corners().size(); ++corner) {
      for (const Ray ray : {Ray{1, 2}, Ray{-3, 1}, Ray{2, -1}, Ray{-1, -1}}) {
        const auto learned = graph.ahead_of(corner, ray);
        const auto known = map->graph().known_ahead_of(corner, ray);
        ASSERT_EQ(known.end - known.begin, learned.end - learned.begin);
        for (std::uint32_t i = 0; i < known.end - known.begin; ++i) {
          const TautGraph::Edge& edge = map->graph().edge(known.begin + i);
          ASSERT_EQ(edge.to, graph.edge(learned.begin + i).to);
        }
      }
    }
  }
}

TEST(TautMapMaking, StopsWhenToldToAndGoesOnToTheSameMap) {
  Random random(3);
  const auto portals = portals_of(test::random_cells(random, 40, 0.5), false);
  const auto corners = portals->corners().size();
  ASSERT_GT(corners, 20U);
  TautMapMaking making(portals, TautMap::usual_most_bytes(*portals));
  std::size_t parts = 0;
  std::size_t asked = 0;
  double last = 0;
  const auto three_corners = [&, left = 3](double share) mutable {
    EXPECT_GE(share, last);
    EXPECT_LT(share, 1);
    last = share;
    ++asked;
    return left-- > 0;
  };
  auto state = TautMapMaking::State::unfinished;
  while (state == TautMapMaking::State::unfinished) {
    state = making.go_on(three_corners);
    ++parts;
  }
  ASSERT_EQ(state, TautMapMaking::State::finished);
  EXPECT_EQ(parts, corners / 3 + (corners % 3 == 0 ? 0 : 1));
  EXPECT_EQ(asked, corners + parts - 1);
  const auto map = making.take();
  const auto whole = TautMap::make(portals, TautMap::usual_most_bytes(*portals));
  ASSERT_EQ(map->graph().edges(), whole->graph().edges());
  for (std::uint32_t i = 0; i < whole->graph().edges(); ++i) {
    EXPECT_EQ(map->graph().edge(i).to, whole->graph().edge(i).to);
    EXPECT_EQ(map->graph().edge(i).begin, whole->graph().edge(i).begin);
  }
}

TEST(TautMap, IsNotMadeWhereItWouldTakeTooMuchMemory) {
  BitGrid free(9, 9);
  for (const Cell cell : every_cell(free)) free.set(cell, cell != Cell{4, 4});
  const auto portals = portals_of(free, false);
  EXPECT_NE(TautMap::make(portals, 1000), nullptr);
  EXPECT_EQ(TautMap::make(portals, 10), nullptr);
}

}  // namespace
}  // namespace wend
