#include "wend/sight/taut_graph.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "conformance/random_map.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

using Way = std::pair<std::uint32_t, double>;  // to a corner, its length

std::vector<Way> glanced(TautGraph& graph, std::uint32_t corner, Ray ray) {
  std::vector<Way> ways;
  graph.glance_ahead(corner, ray,
                     [&](std::uint32_t to, double length) { ways.emplace_back(to, length); });
  std::ranges::sort(ways);
  return ways;
}

std::vector<Way> looked_up(TautGraph& graph, std::uint32_t corner, Ray ray) {
  std::vector<Way> ways;
  const TautGraph::Edges ahead = graph.ahead_of(corner, ray);
  for (std::uint32_t i = ahead.begin; i < ahead.end; ++i) {
    ways.emplace_back(graph.edge(i).to, graph.edge(i).length);
  }
  std::ranges::sort(ways);
  return ways;
}

RC_GTEST_PROP(TautGraph, GlancesSeeWhatLiesAheadOfEveryPathToACorner, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const FreeSpace space = *make_free_space(test::random_map(random));
  const bool gaps = random.chance(0.5);
  const auto open = [gaps](Cell, Cell) { return gaps; };
  const auto portals = std::make_shared<const Portals>(space.passable(), open);
  TautGraph looking(portals);
  TautGraph glancing(portals);
  const auto expect_the_same = [&](std::uint32_t corner, Ray ray) {
    RC_ASSERT(glanced(glancing, corner, ray) == looked_up(looking, corner, ray));
  };
  for (std::uint32_t from = 0; from < portals->corners().size(); ++from) {
    CornerSweep(*portals).from_corner(from, expect_the_same);
  }
  const Cell cell{random.between(0, space.width() - 1), random.between(0, space.height() - 1)};
  if (!space.passable(cell)) return;
  const std::int64_t scale = random.chance(0.5) ? 2 : 1 << 20;
  const Point point{cell.x + random.between(1, 99) / 100.0, cell.y + random.between(1, 99) / 100.0};
  CornerSweep(*portals).from_point(SightPoint::at(point, cell, scale), expect_the_same);
}

}  // namespace
}  // namespace wend
