#include "wend/index/corner_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "wend/index/brute_distances_test.hpp"
#include "wend/index/first_corners.hpp"

namespace wend {
namespace {

using test::brute_distances;
using test::brute_sees;
using test::for_small_boards;
using test::kUnreached;
using test::passable_cells;
using test::text_of;

/// Distances in the graph from one corner, by relaxing every edge until nothing changes.
std::vector<std::uint64_t> graph_distances(const CornerGraph& graph, std::uint32_t from) {
  std::vector<std::uint64_t> distances(graph.size(), kUnreached);
  distances[from] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t corner = 0; corner < graph.size(); ++corner) {
      if (distances[corner] == kUnreached) continue;
      for (const CornerEdge edge : graph.edges(corner)) {
        const std::uint64_t longer = distances[corner] + edge.cost;
        if (longer < distances[edge.to]) {
          distances[edge.to] = longer;
          changed = true;
        }
      }
    }
  }
  return distances;
}

TEST(Corners, AreCellsBesideABlockedDiagonalWithFreeSides) {
  for_small_boards(300, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Corners corners(bits);
    std::uint32_t count = 0;
    for (const Cell cell : passable_cells(bits)) {
      bool expected = false;
      for (const int dx : {-1, 1}) {
        for (const int dy : {-1, 1}) {
          expected |= bits[{cell.x + dx, cell.y}] && bits[{cell.x, cell.y + dy}] &&
                      !bits[{cell.x + dx, cell.y + dy}];
        }
      }
      ASSERT_EQ(corners.number(cell), expected ? count : Corners::kNone);
      ASSERT_EQ(corners.contains(cell), expected);
      if (!expected) continue;
      ASSERT_EQ(corners.cell(count), cell);
      ++count;
    }
    ASSERT_EQ(corners.size(), count);
  });
}

TEST(CornerGraph, HasTheDistancesOfTheGrid) {
  for_small_boards(300, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const CornerGraph graph{Corners(bits)};
    for (std::uint32_t from = 0; from < graph.size(); ++from) {
      const auto distances = graph_distances(graph, from);
      const auto expected = brute_distances(bits, graph.corners().cell(from));
      for (std::uint32_t to = 0; to < graph.size(); ++to) {
        ASSERT_EQ(distances[to], expected[graph.corners().cell(to)]) << from << " to " << to;
      }
    }
  });
}

TEST(CornerGraph, HasTheOppositeOfEveryEdge) {
  for_small_boards(300, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const CornerGraph graph{Corners(bits)};
    std::size_t edges = 0;
    for (std::uint32_t corner = 0; corner < graph.size(); ++corner) {
      for (const CornerEdge edge : graph.edges(corner)) {
        const auto back = graph.edges(edge.to);
        ASSERT_EQ(std::count(back.begin(), back.end(), CornerEdge{corner, edge.cost}), 1);
        ++edges;
      }
    }
    ASSERT_EQ(edges, graph.edge_count());
  });
}

/// The first corners of a passable cell, found by a forward search, in ascending order.
std::vector<std::uint32_t> first_corners_from(const Corners& corners, Cell cell) {
  const BitGrid& passable = corners.passable();
  std::vector<std::uint32_t> found;
  const auto cast = [&](Cell from, Direction straight) {
    const auto stops = [&](Cell at) {
      return (jump_directions(passable.block(at)) & set_of(straight)) != 0;
    };
    Cell at = step(from, straight);
    while (passable[at] && !stops(at)) at = step(at, straight);
    if (passable[at]) found.push_back(corners.number(at));
  };
  for (const Direction straight : kStraightDirections) cast(cell, straight);
  for (const Direction diagonal : kDiagonalDirections) {
    walk_diagonal(passable, cell, diagonal, [&](Cell on_diagonal) {
      for (const Direction straight : beside(diagonal)) cast(on_diagonal, straight);
      return true;
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(FirstCorners, AreTheSameForwardsAndBackwards) {
  for_small_boards(1000, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Corners corners(bits);
    const AllFirstCorners backwards(corners);
    for (int y = 0; y < bits.height(); ++y) {
      for (int x = 0; x < bits.width(); ++x) {
        std::vector<std::uint32_t> found;
        if (bits[{x, y}]) found = first_corners_from(corners, {x, y});
        const auto all = backwards.of({x, y});
        ASSERT_TRUE(std::equal(found.begin(), found.end(), all.begin(), all.end()))
            << x << "," << y;
      }
    }
  });
}

TEST(FirstCorners, AreSeenFromTheirCells) {
  for_small_boards(300, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Corners corners(bits);
    const AllFirstCorners first(corners);
    for (const Cell cell : passable_cells(bits)) {
      for (const std::uint32_t corner : first.of(cell)) {
        ASSERT_TRUE(brute_sees(bits, cell, corners.cell(corner)));
      }
    }
  });
}

/// The least of the terms that first_corners.hpp names.
class ThreeTerms {
 public:
  explicit ThreeTerms(const CornerGraph& graph) : graph_(graph), first_(graph.corners()) {
    for (std::uint32_t corner = 0; corner < graph.size(); ++corner) {
      between_.push_back(graph_distances(graph, corner));
    }
  }

  /// `stand`: do corners stand for themselves?
  std::uint64_t distance(Cell s, Cell t, bool stand) const {
    const Corners& corners = graph_.corners();
    const auto sees = [&](Cell a, Cell b) { return brute_sees(corners.passable(), a, b); };
    std::uint64_t least = sees(s, t) || sees(t, s) ? octile_cost<CornerCost>(s, t) : kUnreached;
    const bool alone = stand && (corners.contains(s) || corners.contains(t));
    const auto first_of_s = first(s, stand);
    for (const std::uint32_t c : first(t, stand)) {
      const std::uint64_t from_c = octile_cost<CornerCost>(corners.cell(c), t);
      if (!alone && sees(s, corners.cell(c))) {
        least = std::min(least, octile_cost<CornerCost>(s, corners.cell(c)) + from_c);
      }
      for (const std::uint32_t a : first_of_s) {
        if (between_[a][c] == kUnreached) continue;
        least =
            std::min(least, octile_cost<CornerCost>(s, corners.cell(a)) + between_[a][c] + from_c);
      }
    }
    return least;
  }

 private:
  std::vector<std::uint32_t> first(Cell cell, bool stand) const {
    const std::uint32_t corner = graph_.corners().number(cell);
    if (stand && corner != Corners::kNone) return {corner};
    const auto list = first_.of(cell);
    return {list.begin(), list.end()};
  }

  const CornerGraph& graph_;
  AllFirstCorners first_;
  std::vector<std::vector<std::uint64_t>> between_;
};

TEST(FirstCorners, GiveTheDistanceOfAnyTwoCellsAsTheLeastOfThreeTerms) {
  for_small_boards(100, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const CornerGraph graph{Corners(bits)};
    const ThreeTerms terms(graph);
    for (const Cell from : passable_cells(bits)) {
      const auto expected = brute_distances(bits, from);
      for (const Cell to : passable_cells(bits)) {
        ASSERT_EQ(terms.distance(from, to, false), expected[to]);
        ASSERT_EQ(terms.distance(from, to, true), expected[to]);
      }
    }
  });
}

}  // namespace
}  // namespace wend
