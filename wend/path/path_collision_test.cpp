#include "wend/path/path_collision.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/polygon_overlap.hpp"
#include "tests/testing/random_path.hpp"
#include "tests/testing/random_polygon.hpp"
#include "tests/testing/sampled_robot.hpp"
#include "tests/testing/share.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_fault.hpp"

namespace wend {
namespace {

/// Where the first of many points of a path collides.
double first_sample(const Path& path, const test::SampledRobot& robot) {
  constexpr double kStep = 0.02;
  if (robot.collides_at(path.points().front())) return 0;
  double along = 0;
  for (const Arc& arc : path.arcs()) {
    const double length = std::abs(arc.length);
    const int steps = 1 + static_cast<int>(length / kStep);
    for (int i = 1; i <= steps; ++i) {
      if (robot.collides_at(point_on(arc, arc.length * i / steps)))
        return along + length * i / steps;
    }
    along += length;
  }
  return test::kInfinite;
}

/// The point that a collision says it is at, by its piece and how far along it lies.
Point contact(const Path& path, const PathCollision& collision) {
  const auto arcs = path.arcs();
  if (arcs.empty()) return path.points().front();
  double along = collision.along;
  for (std::size_t i = 0; i < collision.piece; ++i) along -= std::abs(arcs[i].length);
  const Arc& arc = arcs[collision.piece];
  EXPECT_GE(along, -1e-9);
  EXPECT_LE(along, std::abs(arc.length) + 1e-9);
  return point_on(arc, arc.length < 0 ? -along : along);
}

/// `margin` is how far from the border the centre has to stay.
void expect_contact(const PathCollision& collision, const test::SampledRobot& robot, double radius,
                    double margin) {
  constexpr double kNear = 2e-6;
  const Point at = collision.point;
  if (collision.kind == CollisionKind::outside) {
    EXPECT_LT(robot.inside_border(at), margin + kNear);
    EXPECT_TRUE(collision.along == 0 || robot.inside_border(at) > margin - kNear);
    EXPECT_FALSE(collision.obstacle);
    return;
  }
  ASSERT_TRUE(collision.obstacle);
  EXPECT_TRUE(robot.is_obstacle(collision.obstacle->x, collision.obstacle->y));
  const double gap = test::distance_to_square(at.x, at.y, *collision.obstacle);
  EXPECT_NEAR(gap, robot.nearest_obstacle(at), kNear) << "it is the nearest one";
  switch (collision.kind) {
    case CollisionKind::obstacle:
      EXPECT_LT(gap, kNear);
      break;
    case CollisionKind::squeezed: {
      const Point corner{std::round(at.x), std::round(at.y)};
      EXPECT_LT(distance(at, corner), kNear);
      EXPECT_TRUE(robot.is_gap(static_cast<int>(corner.x), static_cast<int>(corner.y)));
      break;
    }
    default:
      EXPECT_LT(gap, radius + kNear);
      EXPECT_TRUE(collision.along == 0 || gap > radius - kNear) << gap;
  }
}

TEST(PathCollision, IsWhereTheFirstSampleCollides) {
  int free = 0;
  std::array<int, 4> kinds{};
  for (std::uint64_t seed = 1; seed <= 20000 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 12), random.between(1, 12));
    const double radius = test::one_of<double>(random, std::array{0.0, 0.0, 0.3, 1.0, 2.7});
    const FreeSpace space =
        *make_free_space(map, {.footprint = Footprint::disc(radius * map.frame().resolution),
                               .outside = test::random_outside(random)});
    const bool stays_on_map = space.outside() == OutsidePolicy::blocked;
    const Path path = test::random_path(random, map.width(), map.height());
    SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " + std::to_string(radius) + "\n" +
                 test::drawing_of(map) + test::text_of(path));
    const test::SampledRobot robot(map, radius, stays_on_map);
    const double first = first_sample(path, robot);
    const auto collision = first_collision(path, space);
    if (!collision) {
      ++free;
      ASSERT_EQ(first, test::kInfinite);
      continue;
    }
    ++kinds.at(static_cast<std::size_t>(collision->kind));
    ASSERT_LE(collision->along, first);
    ASSERT_LT(distance(contact(path, *collision), collision->point), 1e-9);
    expect_contact(*collision, robot, radius, stays_on_map ? radius : 0);
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(kinds[0], 300) << "outside";
  EXPECT_GT(kinds[1], 300) << "obstacle";
  EXPECT_GT(kinds[2], 300) << "too close";
  EXPECT_GT(kinds[3], 10) << "squeezed";
}

/// Samples of the poses of a polygon on a path, and how far along it they are. Half a turn goes the way on
/// which no pose is `blocked`, if there is one.
class PosesOnPath {
 public:
  PosesOnPath(const Path& path, std::function<bool(const Pose&)> blocked)
      : blocked_(std::move(blocked)) {
    if (path.driven()) {
      poses_.push_back({path.poses().front(), 0});
      for (const Arc& arc : path.arcs()) drive(arc);
      return;
    }
    const auto points = path.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Line line{points[i - 1], points[i]};
      if (line.length() == 0) continue;
      const double heading = std::atan2(line.to.y - line.from.y, line.to.x - line.from.x);
      if (!poses_.empty()) turn(heading);
      drive({{line.from.x, line.from.y, heading}, line.length(), 0});
    }
    if (poses_.empty()) turn_around(points.front());
  }

  static constexpr double kStep = 0.03;  // no point of a polygon of radius 2 moves farther

  struct Sample {
    Pose pose;
    double along;
  };
  const std::vector<Sample>& poses() const { return poses_; }

 private:
  void drive(const Arc& arc) {
    const double length = std::abs(arc.length);
    const int steps = 1 + static_cast<int>((length + 2 * std::abs(arc.turn())) / kStep);
    for (int i = 0; i <= steps; ++i) {
      poses_.push_back({pose_on(arc, arc.length * i / steps), along_ + length * i / steps});
    }
    along_ += length;
  }

  void turn(double heading) {
    const Pose from = poses_.back().pose;
    const double angle = normalized_angle(heading - from.heading);
    constexpr double kRounding = 1e-9;
    const bool is_half = std::abs(angle) > kPi - kRounding;
    const bool other_way = is_half && is_blocked(from, angle) && !is_blocked(from, -angle);
    for (const Pose& pose : turned(from, other_way ? -angle : angle)) {
      poses_.push_back({pose, along_});
    }
  }

  static std::vector<Pose> turned(const Pose& from, double angle) {
    const int steps = 1 + static_cast<int>(2 * std::abs(angle) / kStep);
    std::vector<Pose> poses;
    for (int i = 0; i <= steps; ++i) {
      poses.push_back({from.x, from.y, from.heading + angle * i / steps});
    }
    return poses;
  }

  bool is_blocked(const Pose& from, double angle) const {
    return std::ranges::any_of(turned(from, angle), blocked_);
  }

  void turn_around(Point point) {
    for (int i = 0; i < 420; ++i) poses_.push_back({{point.x, point.y, 2 * kPi * i / 420}, 0});
  }

  std::function<bool(const Pose&)> blocked_;
  std::vector<Sample> poses_;
  double along_ = 0;
};

RC_GTEST_PROP(PathCollision, OfAPolygonIsNotAfterTheFirstSampleThatOverlaps, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const GridMap map = test::random_map(random, random.between(2, 9), random.between(2, 9));
  const Polygon outline = test::random_outline();
  const FreeSpace space = *make_free_space(
      map, {.footprint = *Footprint::polygon(outline.scaled(map.frame().resolution)),
            .outside = test::random_outside(random)});
  const auto blocked = test::blocked_squares(space);
  for (int i = 0; i < test::share_of(5); ++i) {
    const Path path = test::random_path(random, map.width(), map.height());
    const auto collision = first_collision(path, space);
    double first = test::kInfinite;
    bool near = false;
    constexpr double kRounding = 1e-7;
    const auto overlaps = [&](const Pose& pose) {
      return test::worst_overlap(space, blocked, pose) > kRounding;
    };
    const PosesOnPath samples(path, overlaps);
    for (const auto& [pose, along] : samples.poses()) {
      const double inside = std::min({pose.x, pose.y, map.width() - pose.x, map.height() - pose.y});
      if (first == test::kInfinite && (inside < -kRounding || overlaps(pose))) first = along;
      const double margin = PosesOnPath::kStep + 0.03;
      near = near || inside < margin || test::worst_overlap(space, blocked, pose, margin) > 0;
    }
    RC_ASSERT(collision.has_value() || first == test::kInfinite);
    if (collision) {
      RC_ASSERT(collision->along <= first + 1e-5);
      RC_ASSERT(near);
    }
  }
}

TEST(PathCollision, TellsWhatItRunsInto) {
  const FreeSpace point = test::drawn_space("....\n..#.\n.#..");
  const auto through = first_collision(Path({{0, 0}, {1, 1}, {2, 2}, {3, 2}}), point);
  ASSERT_TRUE(through);
  EXPECT_EQ(through->kind, CollisionKind::squeezed);
  EXPECT_EQ(through->piece, 1U);
  EXPECT_NEAR(through->along, 1.5 * std::sqrt(2), 1e-6);
  EXPECT_EQ(describe(through->kind), "passes between two obstacles that touch at a corner");
  EXPECT_FALSE(
      first_collision(Path({{0, 0}, {1, 1}, {2, 2}, {3, 2}}), point, Adjacency::edges_and_corners));

  const auto into = first_collision(Path::along({{0.5, 1.25}, {3.5, 1.25}}), point);
  ASSERT_TRUE(into);
  EXPECT_EQ(into->kind, CollisionKind::obstacle);
  EXPECT_NEAR(into->point.x, 2, 1e-6);
  EXPECT_EQ(into->obstacle, (Cell{2, 1}));

  const auto off = first_collision(Path::along({{0.5, 0.5}, {0.5, -3.5}}), point);
  ASSERT_TRUE(off);
  EXPECT_EQ(off->kind, CollisionKind::outside);
  EXPECT_NEAR(off->along, 0.5, 1e-6);
}

TEST(PathCollision, OfADiscThatHasToStayOnTheMapIsWithItsEdge) {
  FreeSpaceOptions robot{.footprint = Footprint::disc(1), .outside = OutsidePolicy::blocked};
  const Path along = Path::along({{1.5, 1.5}, {6.5, 1.5}});
  const FreeSpace space = test::drawn_space(".......\n.......\n.......", robot);
  const auto off = first_collision(along, space);
  ASSERT_TRUE(off);
  EXPECT_EQ(off->kind, CollisionKind::outside);
  EXPECT_NEAR(off->along, 4.5, 1e-6) << "where the disc touches the edge";
  EXPECT_FALSE(off->obstacle);
  // Along a wall, which it touches all the way and which is not to blame.
  const FreeSpace wall = test::drawn_space(".......\n.......\n.......\n#######", robot);
  const auto past = first_collision(Path::along({{1.5, 2}, {6.5, 2}}), wall);
  ASSERT_TRUE(past);
  EXPECT_EQ(past->kind, CollisionKind::outside);
  EXPECT_NEAR(past->along, 4.5, 1e-6);
  robot.outside = OutsidePolicy::free;
  EXPECT_FALSE(first_collision(along, test::drawn_space(".......\n.......\n.......", robot)));
  robot = {.footprint = Footprint::disc(0), .outside = OutsidePolicy::blocked};
  EXPECT_FALSE(first_collision(Path::along({{0, 0}, {7, 0}, {7, 3}}),
                               test::drawn_space(".......\n.......\n.......", robot)))
      << "a point may go along the edge itself";
}

TEST(PathCollision, SeesWherePiecesOfAPathMeetInAGap) {
  const FreeSpace space = test::drawn_space("#.\n.#");
  const auto turn = first_collision(Path::along({{0.5, 1}, {1, 1}, {1, 1}, {1, 1.5}}), space);
  EXPECT_FALSE(turn) << "in and out on one side";
  const auto through = first_collision(Path::along({{0.5, 1}, {1, 1}, {1, 1}, {1.5, 1}}), space);
  ASSERT_TRUE(through);
  EXPECT_EQ(through->kind, CollisionKind::squeezed);
  EXPECT_NEAR(through->along, 0.5, 1e-6);
  // A car's arcs around (0,2) and then (2,0), which meet there.
  const Path drive = Path::through({{0, 1, 0}, {1, 1, 0}, {2, 1, 0}});
  EXPECT_EQ(first_collision(drive, space)->kind, CollisionKind::squeezed);
}

TEST(PathCollision, OfAPathThatStandsIsWhereItStands) {
  const FreeSpace space = test::drawn_space("#.\n..", {.footprint = Footprint::disc(0.6)});
  for (const Path& path :
       {Path({{0, 0}}), Path({{0, 0}, {0, 0}}), Path::through({{0.5, 0.5, 1}})}) {
    const auto collision = first_collision(path, space);
    ASSERT_TRUE(collision);
    EXPECT_EQ(collision->kind, CollisionKind::obstacle);
    EXPECT_EQ(collision->along, 0);
    EXPECT_EQ(collision->piece, 0U);
  }
  EXPECT_EQ(first_collision(Path({{1, 0}}), space)->kind, CollisionKind::too_close);
  EXPECT_FALSE(first_collision(Path({{1, 1}}), space));
}

/// A way of 1e9 cells would take minutes to sweep.
TEST(FirstCollision, LeavesTheMapBeforeItSweepsWhatIsFarOffIt) {
  for (const double far : {1e9, -1e9, 1e18, -1e300}) {
    for (const bool disc : {false, true}) {
      const FreeSpace space = test::drawn_space("......\n......\n..#...\n",
                                                {.footprint = Footprint::disc(disc ? 0.5 : 0)});
      const auto along = first_collision(Path::along({{1, 1}, {far, 1}}), space);
      ASSERT_TRUE(along);
      EXPECT_EQ(along->kind, CollisionKind::outside) << far;
      if (std::abs(far) > kFarthestPoint) {
        EXPECT_EQ(along->point, (Point{1, 1})) << "the last point that has no fault";
      } else {
        EXPECT_NEAR(along->point.x, far > 0 ? 6 : 0, disc ? 0.6 : 1e-6) << far;
      }
      const auto drive = first_collision(Path::through({{1, 1, 0}, {far, 1, 0}}), space);
      ASSERT_TRUE(drive);
      EXPECT_EQ(drive->kind, CollisionKind::outside) << far;
    }
  }
}

TEST(FirstCollision, FindsAnObstacleBeforeThePathLeavesTheMap) {
  const FreeSpace space = test::drawn_space("......\n..#...\n......\n");
  const auto collision = first_collision(Path::along({{0.5, 1.5}, {1e9, 1.5}}), space);
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->kind, CollisionKind::obstacle);
  EXPECT_NEAR(collision->point.x, 2, 1e-6);
  const auto exit = first_exit(Path::along({{0.5, 1.5}, {1e9, 1.5}}), space);
  ASSERT_TRUE(exit);
  EXPECT_EQ(exit->kind, CollisionKind::outside);
  EXPECT_NEAR(exit->point.x, 6, 1e-6);
  EXPECT_NEAR(exit->along, 5.5, 1e-6);
  EXPECT_FALSE(first_exit(Path::along({{0.5, 1.5}, {6, 3}}), space));
}

TEST(FirstCollision, OfAPathWithNaNIsAtTheLastPointBeforeIt) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const FreeSpace space = test::open_space(6, 3);
  const auto later = first_collision(Path::along({{1, 1}, {2, 1}, {kNan, 1}}), space);
  ASSERT_TRUE(later);
  EXPECT_EQ(later->kind, CollisionKind::outside);
  EXPECT_EQ(later->point, (Point{2, 1}));
  EXPECT_EQ(later->along, 1);
  const auto first = first_collision(Path::through({{kNan, 9, 0}}), space);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->point, (Point{0, 3})) << "the place of the map that is nearest";
  EXPECT_FALSE(first_collision(Path{}, space));
}

}  // namespace
}  // namespace wend
