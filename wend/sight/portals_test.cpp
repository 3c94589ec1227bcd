// Portals, and what is seen through them, against cells looked at one by one: conformance/visibility.hpp.

#include "wend/sight/portals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "conformance/visibility.hpp"
#include "tests/testing/random_cells.hpp"
#include "tests/testing/share.hpp"
#include "wend/sight/cell_trail.hpp"
#include "wend/sight/corner_sweep.hpp"

namespace wend {
namespace {

using test::Visibility;

constexpr std::int64_t kHalf = Visibility::kCell / 2;  // of a cell

/// A random map, with gaps open or closed, and the reference on it.
struct SightTrial {
  explicit SightTrial(std::uint64_t seed, int longest = 12)
      : random(seed),
        free(test::random_cells(random, longest, 0.4)),
        gaps(random.chance(0.5)),
        portals(free,
                gaps ? Portals::OpenGap([](Cell, Cell) { return true; }) : Portals::OpenGap()),
        reference(free.width(), free.height(), [&](Cell cell) { return free[cell]; }, gaps) {
    for (const Cell cell : every_cell(free)) {
      if (free[cell]) cells.push_back(cell);
    }
  }

  bool is_free(int x, int y) const {
    return x >= 0 && y >= 0 && x < free.width() && y < free.height() && free[{x, y}];
  }

  Visibility::At at(std::uint32_t corner) const {
    const TautCorner& its = portals.corners()[corner];
    return {Visibility::kCell * its.x, Visibility::kCell * its.y};
  }

  Random random;
  BitGrid free;
  bool gaps;
  Portals portals;
  Visibility reference;
  std::vector<Cell> cells = {};
};

/// Calls check(trial) for random maps.
template <class Check>
void for_random_maps(int count, Check&& check) {
  for (int seed = 1; seed <= test::share_of(count) && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    SightTrial trial(static_cast<std::uint64_t>(seed));
    check(trial);
  }
}

TEST(Portals, RunsAreTheLongestRowsOfFreeCells) {
  for_random_maps(300, [](SightTrial& trial) {
    for (const Cell cell : trial.cells) {
      const SightRun& run = trial.portals.run(trial.portals.run_of(cell));
      ASSERT_TRUE(run.left <= cell.x && cell.x < run.right);
      for (int x = run.left; x < run.right; ++x) ASSERT_TRUE(trial.is_free(x, cell.y));
      ASSERT_FALSE(trial.is_free(run.left - 1, cell.y));
      ASSERT_FALSE(trial.is_free(run.right, cell.y));
    }
  });
}

TEST(Portals, JoinExactlyTheRunsThatTouch) {
  for_random_maps(300, [](SightTrial& trial) {
    const Portals& portals = trial.portals;
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (const Cell cell : trial.cells) {
      const std::uint32_t run = portals.run_of(cell);
      for (std::uint32_t i = portals.run(run).first_above; i < portals.end_above(run); ++i) {
        const Portal& portal = portals.portal(i);
        ASSERT_EQ(portal.below, run);
        ASSERT_EQ(portal.left, std::max(portals.run(run).left, portals.run(portal.above).left));
        ASSERT_EQ(portal.right, std::min(portals.run(run).right, portals.run(portal.above).right));
        joined.insert({run, portal.above});
      }
      for (const int aside : {-1, 0, 1}) {
        if (!trial.is_free(cell.x + aside, cell.y + 1)) continue;
        const bool gap = aside != 0 && !trial.is_free(cell.x + aside, cell.y) &&
                         !trial.is_free(cell.x, cell.y + 1);
        if (aside != 0 && (!gap || !trial.gaps)) continue;
        expected.insert({run, portals.run_of({cell.x + aside, cell.y + 1})});
      }
    }
    ASSERT_EQ(joined, expected);
  });
}

TEST(Portals, CornersAreTheVerticesWhereAPathCanTurn) {
  for_random_maps(300, [](SightTrial& trial) {
    std::map<std::pair<int, int>, std::pair<BlockedCell, bool>> corners;
    for (const TautCorner& corner : trial.portals.corners()) {
      const auto [place, is_new] =
          corners.insert({{corner.x, corner.y}, {corner.blocked_cell(), corner.rising != 0}});
      ASSERT_TRUE(is_new) << place->first.first << ',' << place->first.second;
      const Portal& portal = trial.portals.portal(corner.portal);
      ASSERT_TRUE(portal.left == corner.x || portal.right == corner.x);
    }
    std::map<std::pair<int, int>, std::pair<BlockedCell, bool>> expected;
    for (int y = 0; y <= trial.free.height(); ++y) {
      for (int x = 0; x <= trial.free.width(); ++x) {
        const bool low_left = trial.is_free(x - 1, y - 1);
        const bool low_right = trial.is_free(x, y - 1);
        const bool high_left = trial.is_free(x - 1, y);
        const bool high_right = trial.is_free(x, y);
        const int free = low_left + low_right + high_left + high_right;
        if (free == 3) {
          const BlockedCell blocked = !low_left    ? BlockedCell::low_left
                                      : !low_right ? BlockedCell::low_right
                                      : !high_left ? BlockedCell::high_left
                                                   : BlockedCell::high_right;
          expected[{x, y}] = {blocked, !low_right || !high_left};
        } else if (trial.gaps && free == 2 && low_left == high_right) {
          expected[{x, y}] = {BlockedCell::gap, low_left};
        }
      }
    }
    ASSERT_EQ(corners, expected);
  });
}

TEST(Portals, SeeWhatNoObstacleHides) {
  int seen = 0;
  int hidden = 0;
  for_random_maps(300, [&](SightTrial& trial) {
    for (int i = 0; i < 200 && !trial.cells.empty(); ++i) {
      const Cell from = trial.cells[trial.random.below(trial.cells.size())];
      const Cell to = trial.cells[trial.random.below(trial.cells.size())];
      const bool sees = trial.reference.sees(Visibility::centre(from), Visibility::centre(to));
      ASSERT_EQ(trial.portals.sees(from, to), sees)
          << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
      (sees ? seen : hidden) += 1;
    }
  });
  EXPECT_GT(seen, 1000);
  EXPECT_GT(hidden, 1000);
}

/// Does a line along this ray touch the corner's obstacle without entering it? `strictly`: not along its edge.
bool is_tangent(const TautCorner& corner, std::int64_t x, std::int64_t y, bool strictly) {
  if (x == 0 || y == 0) return !strictly;
  return (x * y > 0) == (corner.rising != 0);
}

/// Is another corner between the two, on the line?
bool is_behind_another(const SightTrial& trial, Visibility::At from, Visibility::At to) {
  for (std::uint32_t i = 0; i < trial.portals.corners().size(); ++i) {
    const Visibility::At at = trial.at(i);
    if (at == from || at == to) continue;
    const std::int64_t side = (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
    const std::int64_t along =
        (to.x - from.x) * (at.x - from.x) + (to.y - from.y) * (at.y - from.y);
    const std::int64_t whole =
        (to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y);
    if (side == 0 && along > 0 && along < whole) return true;
  }
  return false;
}

TEST(CornerSweep, TellsACellTheFirstTangentCornersThatItSees) {
  for_random_maps(200, [](SightTrial& trial) {
    CornerSweep sweep(trial.portals);
    for (const Cell cell : trial.cells) {
      std::set<std::uint32_t> told;
      const Visibility::At centre = Visibility::centre(cell);
      sweep.from_point(SightPoint::centre(cell), [&](std::uint32_t corner, Ray ray) {
        EXPECT_TRUE(told.insert(corner).second) << "told twice";
        EXPECT_EQ(ray.x * kHalf, trial.at(corner).x - centre.x);
        EXPECT_EQ(ray.y * kHalf, trial.at(corner).y - centre.y);
      });
      std::set<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < trial.portals.corners().size(); ++i) {
        const Visibility::At at = trial.at(i);
        if (is_tangent(trial.portals.corners()[i], at.x - centre.x, at.y - centre.y, true) &&
            trial.reference.sees(centre, at) && !is_behind_another(trial, centre, at)) {
          expected.insert(i);
        }
      }
      ASSERT_EQ(told, expected) << cell.x << ',' << cell.y;
    }
  });
}

TEST(CornerSweep, TellsACornerTheOthersToWhichALineIsTangent) {
  for_random_maps(200, [](SightTrial& trial) {
    CornerSweep sweep(trial.portals);
    const auto corners = trial.portals.corners();
    for (std::uint32_t from = 0; from < corners.size(); ++from) {
      std::set<std::uint32_t> told;
      sweep.from_corner(from, [&](std::uint32_t corner, Ray) { told.insert(corner); });
      for (std::uint32_t to = 0; to < corners.size(); ++to) {
        if (to == from) continue;
        const Visibility::At at = trial.at(to);
        const Visibility::At here = trial.at(from);
        const auto tangent = [&](bool strictly) {
          return is_tangent(corners[from], at.x - here.x, at.y - here.y, strictly) &&
                 is_tangent(corners[to], at.x - here.x, at.y - here.y, strictly) &&
                 trial.reference.sees(here, at);
        };
        if (told.contains(to)) {
          ASSERT_TRUE(tangent(false)) << from << " to " << to;
        } else {
          ASSERT_FALSE(tangent(true) && !is_behind_another(trial, here, at))
              << from << " to " << to;
        }
      }
    }
  });
}

/// What is wrong with the cells of a trail; empty if nothing is.
std::string fault_of(const SightTrial& trial, const std::vector<Cell>& cells, Cell start,
                     Cell goal) {
  if (cells.empty() || cells.front() != start || cells.back() != goal) return "its ends";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!trial.is_free(cells[i].x, cells[i].y)) return "a blocked cell";
    if (i == 0) continue;
    const int dx = cells[i].x - cells[i - 1].x;
    const int dy = cells[i].y - cells[i - 1].y;
    if (std::abs(dx) + std::abs(dy) == 1) continue;
    const bool diagonal = std::abs(dx) == 1 && std::abs(dy) == 1;
    const bool gap = diagonal && !trial.is_free(cells[i].x, cells[i - 1].y) &&
                     !trial.is_free(cells[i - 1].x, cells[i].y);
    if (!gap || !trial.gaps) return "a step that is none";
  }
  return {};
}

TEST(CellTrail, FollowsEveryFreePathOverCornersAndNoOther) {
  int found = 0;
  int refused = 0;
  for_random_maps(300, [&](SightTrial& trial) {
    const std::size_t corners = trial.portals.corners().size();
    for (int i = 0; i < 100 && trial.cells.size() > 1; ++i) {
      const Cell start = trial.cells[trial.random.below(trial.cells.size())];
      const Cell goal = trial.cells[trial.random.below(trial.cells.size())];
      std::vector<std::uint32_t> way;
      std::vector<Visibility::At> points{Visibility::centre(start)};
      for (int k = trial.random.between(0, 2); k > 0 && corners > 0; --k) {
        const auto corner = static_cast<std::uint32_t>(trial.random.below(corners));
        const Visibility::At at = trial.at(corner);
        // Only what a taut path can do: lines that are tangent, never along a wall.
        if (!is_tangent(trial.portals.corners()[corner], at.x - points.back().x,
                        at.y - points.back().y, true)) {
          continue;
        }
        if (!way.empty() && !is_tangent(trial.portals.corners()[way.back()], at.x - points.back().x,
                                        at.y - points.back().y, true)) {
          continue;
        }
        way.push_back(corner);
        points.push_back(at);
      }
      points.push_back(Visibility::centre(goal));
      bool is_path = true;
      for (std::size_t k = 1; k < points.size(); ++k) {
        is_path = is_path && trial.reference.sees(points[k - 1], points[k]);
      }
      std::vector<Cell> cells;
      const bool written = write_trail(trial.portals, start, way, goal, cells);
      if (is_path) {
        ASSERT_TRUE(written);
        ASSERT_EQ(fault_of(trial, cells, start, goal), "");
      }
      (written ? found : refused) += 1;
    }
  });
  EXPECT_GT(found, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace wend
