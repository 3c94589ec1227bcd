#include "wend/robot/sweep/point_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_arc.hpp"
#include "tests/testing/share.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

// Exact arithmetic on points whose coordinates are whole numbers of quarters of a cell.

constexpr int kPerCell = 4;

struct Whole {
  std::int64_t x;
  std::int64_t y;
};

Point point_of(Whole point) {
  return {static_cast<double>(point.x) / kPerCell, static_cast<double>(point.y) / kPerCell};
}

std::int64_t side_of(Whole from, Whole to, Whole point) {
  return (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x);
}

bool spans(std::int64_t a, std::int64_t b, std::int64_t low, std::int64_t high) {
  return std::max(a, b) > low && std::min(a, b) < high;
}

/// Does the closed line meet this open rectangle (a point, or a line without its ends, if it has no
/// width or height)? By separating axes.
bool meets(Whole from, Whole to, Whole low, Whole high) {
  const auto overlaps = [](std::int64_t a, std::int64_t b, std::int64_t l, std::int64_t h) {
    return l < h ? spans(a, b, l, h) : std::min(a, b) <= l && l <= std::max(a, b);
  };
  if (!overlaps(from.x, to.x, low.x, high.x) || !overlaps(from.y, to.y, low.y, high.y)) {
    return false;
  }
  if (from.x == to.x && from.y == to.y) return true;
  const std::int64_t sides[] = {side_of(from, to, low), side_of(from, to, {low.x, high.y}),
                                side_of(from, to, {high.x, low.y}), side_of(from, to, high)};
  const auto [least, greatest] = std::minmax_element(std::begin(sides), std::end(sides));
  return (*least < 0 && *greatest > 0) || (*least == 0 && *greatest == 0);
}

/// Checks all obstacles, edges between two of them, and corners, one after the other.
class BruteForce {
 public:
  explicit BruteForce(const GridMap& map, bool unknown_blocked)
      : map_(map), unknown_(unknown_blocked) {}

  bool blocked(int x, int y) const {
    if (!map_.contains({x, y})) return false;
    const CellState state = map_.state({x, y});
    return state == CellState::occupied || (state == CellState::unknown && unknown_);
  }

  bool enters(Whole from, Whole to) const {
    return any_corner([&](int x, int y) {
      const Whole corner{x * kPerCell, y * kPerCell};
      const Whole right{corner.x + kPerCell, corner.y};
      const Whole above{corner.x, corner.y + kPerCell};
      if (blocked(x, y) && meets(from, to, corner, {right.x, above.y})) return true;
      if (blocked(x, y) && blocked(x - 1, y) && meets(from, to, corner, above)) return true;
      if (blocked(x, y) && blocked(x, y - 1) && meets(from, to, corner, right)) return true;
      return blocked(x, y) && blocked(x, y - 1) && blocked(x - 1, y) && blocked(x - 1, y - 1) &&
             meets(from, to, corner, corner);
    });
  }

  bool is_gap(int x, int y) const {
    const bool rising = blocked(x, y) && blocked(x - 1, y - 1);
    const bool falling = blocked(x - 1, y) && blocked(x, y - 1);
    return rising != falling &&
           (blocked(x, y) + blocked(x - 1, y - 1) + blocked(x - 1, y) + blocked(x, y - 1)) == 2;
  }

  /// Does a line that enters nothing reach both sides of a gap?
  bool squeezes(Whole from, Whole to) const {
    return any_corner([&](int x, int y) {
      const Whole corner{x * kPerCell, y * kPerCell};
      return is_gap(x, y) && side_of(from, to, corner) == 0 &&
             (from.x - corner.x) * (to.x - corner.x) + (from.y - corner.y) * (to.y - corner.y) < 0;
    });
  }

  /// Are two lines that meet and enter nothing on different sides of a gap?
  bool squeezes(Whole from, Whole middle, Whole to) const {
    const auto x = static_cast<int>(middle.x / kPerCell);
    const auto y = static_cast<int>(middle.y / kPerCell);
    if (middle.x % kPerCell != 0 || middle.y % kPerCell != 0 || !is_gap(x, y)) return false;
    const int slope = blocked(x, y) ? 1 : -1;
    const auto side = [&](Whole point) {
      return (point.x - middle.x) * slope - (point.y - middle.y);
    };
    return side(from) * side(to) < 0;
  }

 private:
  template <class Predicate>
  bool any_corner(Predicate&& predicate) const {
    for (int y = 0; y <= map_.height(); ++y) {
      for (int x = 0; x <= map_.width(); ++x) {
        if (predicate(x, y)) return true;
      }
    }
    return false;
  }

  const GridMap& map_;
  bool unknown_;
};

Whole random_whole(Random& random, const GridMap& map) {
  const int step = random.chance(0.3) ? kPerCell : random.chance(0.5) ? kPerCell / 2 : 1;
  return {step * random.between(-kPerCell / step, (map.width() + 1) * kPerCell / step),
          step * random.between(-kPerCell / step, (map.height() + 1) * kPerCell / step)};
}

TEST(PointSweep, DecidesLinesAsExactArithmeticDoes) {
  int free = 0;
  int entering = 0;
  int squeezing = 0;
  for (std::uint64_t seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 7), random.between(1, 7));
    const FreeSpace space = *make_free_space(map);
    const BruteForce brute(map, true);
    for (int i = 0; i < 30; ++i) {
      const Whole from = random_whole(random, map);
      const Whole to = random_whole(random, map);
      const bool enters = brute.enters(from, to);
      const bool squeezes = !enters && brute.squeezes(from, to);
      ++(enters ? entering : squeezes ? squeezing : free);
      const Line line{point_of(from), point_of(to)};
      ASSERT_EQ(fits_along(space, line), !enters && !squeezes)
          << "seed " << seed << ": " << line.from.x << "," << line.from.y << " to " << line.to.x
          << "," << line.to.y << "\n"
          << test::drawing_of(map);
      ASSERT_EQ(fits_along(space, line, {.adjacency = Adjacency::edges_and_corners}), !enters);
    }
  }
  EXPECT_GT(free, 10000);
  EXPECT_GT(entering, 10000);
  EXPECT_GT(squeezing, 100);
}

TEST(PointSweep, DecidesWhereTwoLinesMeetAsExactArithmeticDoes) {
  int squeezing = 0;
  int turning_round = 0;
  for (std::uint64_t seed = 1; seed <= 40000 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(2, 4), random.between(2, 4));
    const FreeSpace space = *make_free_space(map);
    const BruteForce brute(map, true);
    const Whole from = random_whole(random, map);
    const Whole corner{kPerCell * random.between(1, map.width() - 1),
                       kPerCell * random.between(1, map.height() - 1)};
    const Whole to = random_whole(random, map);
    if (brute.enters(from, corner) || brute.enters(corner, to)) continue;
    if (brute.squeezes(from, corner) || brute.squeezes(corner, to)) continue;
    const bool squeezes = brute.squeezes(from, corner, to);
    if (brute.is_gap(static_cast<int>(corner.x) / kPerCell,
                     static_cast<int>(corner.y) / kPerCell)) {
      ++(squeezes ? squeezing : turning_round);
    }
    PointSweep sweep(space, point_of(from));
    ASSERT_TRUE(sweep.go_to(point_of(corner)));
    ASSERT_TRUE(sweep.go_to(point_of(corner))) << "it may wait there";
    ASSERT_EQ(sweep.go_to(point_of(to)), !squeezes)
        << "seed " << seed << ": " << from.x << "," << from.y << " by " << corner.x << ","
        << corner.y << " to " << to.x << "," << to.y << " quarters\n"
        << test::drawing_of(map);
  }
  EXPECT_GT(squeezing, 100);
  EXPECT_GT(turning_round, 100);
}

bool goes(const FreeSpace& space, Point from, Point to, Adjacency adjacency = Adjacency::edges) {
  return fits_along(space, Line{from, to}, {.adjacency = adjacency});
}

TEST(PointSweep, TouchesButDoesNotEnter) {
  const FreeSpace space = test::drawn_space("....\n.##.\n....");
  EXPECT_TRUE(goes(space, {0, 1}, {4, 1})) << "along an edge";
  EXPECT_TRUE(goes(space, {0, 2}, {2, 0})) << "through a corner";
  EXPECT_FALSE(goes(space, {0, 2.01}, {2.01, 0}));
  EXPECT_FALSE(goes(space, {2, 0}, {2, 3})) << "along the edge between two obstacles";
  EXPECT_TRUE(goes(space, {1, 0}, {1, 3}));
  EXPECT_FALSE(goes(space, {2, 1.5}, {2, 1.5})) << "standing there";
  EXPECT_TRUE(goes(space, {2, 1}, {2, 1}));
}

TEST(PointSweep, TakesWhatIsNearlyAnEdgeForOne) {
  const FreeSpace space = test::drawn_space("....\n.##.\n....");
  EXPECT_TRUE(goes(space, {0, 1 + 1e-12}, {4, 1 + 1e-12}));
  EXPECT_FALSE(goes(space, {0, 1 + 1e-6}, {4, 1 + 1e-6}));
  EXPECT_TRUE(goes(space, {1 + 1e-12, 0}, {1 + 1e-12, 3}));
  EXPECT_FALSE(goes(space, {2 + 1e-12, 0}, {2 - 1e-12, 3}));
  EXPECT_FALSE(goes(space, {2 - 1e-12, 1.5}, {2 + 1e-12, 1.5}));
}

TEST(PointSweep, SqueezesOnlyWhereItMay) {
  const FreeSpace space = test::drawn_space("#.\n.#");
  for (const Line& line : {Line{{0.5, 1.5}, {1.5, 0.5}}, Line{{0, 1}, {2, 1}}, Line{{1, 0}, {1, 2}},
                           Line{{0.5, 1.5 + 1e-12}, {1.5, 0.5}}}) {
    EXPECT_FALSE(goes(space, line.from, line.to)) << line.from.x << "," << line.from.y;
    EXPECT_TRUE(goes(space, line.from, line.to, Adjacency::edges_and_corners));
  }
  EXPECT_TRUE(goes(space, {0.5, 1.5}, {1, 1})) << "it may go in";
  const FreeSpace three = test::drawn_space("#.\n##");
  EXPECT_TRUE(goes(three, {2, 1}, {1, 1})) << "no gap";
  EXPECT_FALSE(goes(three, {2, 1}, {0.99, 1}));
}

TEST(PointSweep, RunsAlongTheSideOfAChequerboard) {
  const FreeSpace space = test::drawn_space("#.#.#.\n.#.#.#");
  EXPECT_TRUE(goes(space, {0.5, 1}, {0.9, 1}));
  EXPECT_FALSE(goes(space, {0.5, 1}, {1.1, 1}));
  EXPECT_FALSE(goes(space, {0, 1}, {6, 1}));
  EXPECT_TRUE(goes(space, {0, 1}, {6, 1}, Adjacency::edges_and_corners));
}

TEST(PointSweep, LeavesTheMapAsItLikes) {
  const FreeSpace space = test::drawn_space("##\n##");
  EXPECT_TRUE(goes(space, {-5, -5}, {3, -5}));
  EXPECT_TRUE(goes(space, {0, -1e9}, {0, 1e9})) << "along the border";
  EXPECT_TRUE(goes(space, {-1, 1}, {1, -1}));
  EXPECT_FALSE(goes(space, {-1, 1.1}, {1, -0.9}));
  EXPECT_FALSE(goes(space, {1, -1e9}, {1, 1e9}));
  EXPECT_TRUE(goes(space, {1e9, 1.5}, {3, 1.5}));
}

bool drives(const FreeSpace& space, const Arc& arc, Adjacency adjacency = Adjacency::edges) {
  return fits_along(space, arc, {.adjacency = adjacency});
}

TEST(PointSweep, GoesAlongArcsThatTouch) {
  const FreeSpace space = test::drawn_space("...\n.#.\n...");
  const auto around_the_origin = [&](double radius) {
    return drives(space, {{radius, 0, kPi / 2}, radius * kPi / 2, 1 / radius});
  };
  const double nearest = std::sqrt(2.0);  // corners of the obstacle
  EXPECT_TRUE(around_the_origin(nearest));
  EXPECT_FALSE(around_the_origin(nearest + 1e-6));
  EXPECT_FALSE(around_the_origin(2 * nearest - 1e-6));
  EXPECT_TRUE(around_the_origin(2 * nearest));
  // Tangent to the obstacle's edge.
  EXPECT_TRUE(drives(space, arc_to({1.5, 1, 0}, {2.5, 0})));
  EXPECT_FALSE(drives(space, arc_to({1.5, 1, 0}, {2.5, 1.01})));
  EXPECT_FALSE(drives(space, {{1.5, 1.5, 0}, 0, 0})) << "standing there";
}

TEST(PointSweep, SqueezesAlongArcsOnlyWhereItMay) {
  const FreeSpace space = test::drawn_space("#.\n.#");
  // Through (1,1), from the lower left to the upper right, bending either way or not.
  for (const double bend : {-0.5, -0.01, 0.0, 0.01, 0.5}) {
    const Pose before = pose_on(Arc{{1, 1, -kPi / 4}, -0.4, bend}, -0.4);
    EXPECT_FALSE(drives(space, {before, 0.8, bend})) << bend;
    EXPECT_FALSE(drives(space, {before, 0.7, bend})) << bend;
    EXPECT_TRUE(drives(space, {before, 0.8, bend}, Adjacency::edges_and_corners)) << bend;
    EXPECT_TRUE(drives(space, {before, 0.4, bend})) << "up to the corner";
  }
}

/// Is a point deeper inside the obstacles than this? Then all cells within this distance are obstacles.
bool inside(const FreeSpace& space, Point point, double depth) {
  const auto blocked = [&](double x, double y) {
    const Cell cell = cell_at({x, y});
    return space.contains(cell) && space.obstacles().blocked()[cell];
  };
  return blocked(point.x - depth, point.y - depth) && blocked(point.x - depth, point.y + depth) &&
         blocked(point.x + depth, point.y - depth) && blocked(point.x + depth, point.y + depth);
}

TEST(PointSweep, GoesAlongArcsAsTheirPointsDo) {
  constexpr int kSamples = 500;
  int fitting = 0;
  int entering = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(1500U) && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 9), random.between(1, 9));
    const FreeSpace space = *make_free_space(map);
    const Arc arc = test::random_arc(random, map.width(), map.height());
    bool enters = false;
    double clearance = test::kInfinite;
    for (int i = 0; i <= kSamples; ++i) {
      const Point point = point_on(arc, arc.length * i / kSamples);
      enters = enters || inside(space, point, 1e-7);
      for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
          if (!space.obstacles().blocked()[{x, y}]) continue;
          clearance = std::min(clearance, test::distance_to_square(point.x, point.y, {x, y}));
        }
      }
    }
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + test::text_of(arc) + "\n" +
                 test::drawing_of(map));
    if (enters) {
      ASSERT_FALSE(drives(space, arc));
    }
    if (clearance > std::abs(arc.length) / kSamples / 2) {
      ASSERT_TRUE(drives(space, arc));
    }
    fitting += clearance > std::abs(arc.length) / kSamples / 2 ? 1 : 0;
    entering += enters ? 1 : 0;
  }
  EXPECT_GT(fitting, test::share_of(300));
  EXPECT_GT(entering, test::share_of(300));
}

}  // namespace
}  // namespace wend
