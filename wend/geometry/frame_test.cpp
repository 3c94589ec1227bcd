#include "wend/geometry/frame.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {
namespace {

constexpr double kBorder = 1e-9;  // metres, as the header guarantees
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Metres in place of cells, or the other way round, do not compile.

template <class From, class To>
constexpr bool kConverts = std::is_convertible_v<From, To> || std::is_constructible_v<To, From>;

static_assert(!kConverts<Point, MapPoint> && !kConverts<MapPoint, Point>);
static_assert(!kConverts<Pose, MapPose> && !kConverts<MapPose, Pose>);
static_assert(!kConverts<Point, MapPose> && !kConverts<MapPose, Point>);
static_assert(!kConverts<MapPoint, Pose> && !kConverts<Pose, MapPoint>);
static_assert(!kConverts<Arc, MapArc> && !kConverts<MapArc, Arc>);
static_assert(!kConverts<Segment, MapSegment> && !kConverts<MapSegment, Segment>);

template <class Place>
constexpr bool kLeadsToGrid = requires(Frame frame, Place place) { frame.to_grid(place); };
template <class Place>
constexpr bool kLeadsToMetres = requires(Frame frame, Place place) { frame.to_metres(place); };
template <class Place>
constexpr bool kHasCell = requires(Frame frame, Place place) { frame.cell_at(place); };

static_assert(kLeadsToGrid<MapPoint> && kLeadsToGrid<MapPose>);
static_assert(!kLeadsToGrid<Point> && !kLeadsToGrid<Pose>);
static_assert(kLeadsToMetres<Point> && kLeadsToMetres<Pose>);
static_assert(!kLeadsToMetres<MapPoint> && !kLeadsToMetres<MapPose>);
static_assert(kHasCell<MapPoint> && !kHasCell<Point>);

static_assert(std::is_same_v<decltype(Frame{}.to_metres(Point{})), MapPoint>);
static_assert(std::is_same_v<decltype(Frame{}.to_metres(Pose{})), MapPose>);
static_assert(std::is_same_v<decltype(Frame{}.to_grid(MapPoint{})), Point>);
static_assert(std::is_same_v<decltype(Frame{}.to_grid(MapPose{})), Pose>);
static_assert(std::is_same_v<decltype(Frame::origin), MapPose>);

/// A number in [-limit, limit].
double number_up_to(double limit) {
  return *rc::gen::inRange(-1000000, 1000001) * (limit / 1000000);
}

Frame any_frame() {
  Frame frame;
  frame.resolution = *rc::gen::element(0.01, 0.025, 0.05, 0.1, 1.0, 2.5);
  frame.origin = {number_up_to(100), number_up_to(100), 0};
  if (*rc::gen::arbitrary<bool>()) frame.origin.heading = number_up_to(kPi);
  frame.y_up = *rc::gen::arbitrary<bool>();
  return frame;
}

RC_GTEST_PROP(Frame, LeadsToMetresAndBack, ()) {
  const Frame frame = any_frame();
  const Pose grid{number_up_to(5000), number_up_to(5000), number_up_to(3)};
  const Pose back = frame.to_grid(frame.to_metres(grid));
  RC_ASSERT(distance(back.point(), grid.point()) < 1e-8);
  RC_ASSERT(std::abs(normalized_angle(back.heading - grid.heading)) < 1e-12);
}

RC_GTEST_PROP(Frame, StretchesEveryDistanceByTheResolution, ()) {
  const Frame frame = any_frame();
  const Point a{number_up_to(1000), number_up_to(1000)};
  const Point b{number_up_to(1000), number_up_to(1000)};
  const double metres = distance(frame.to_metres(a), frame.to_metres(b));
  RC_ASSERT(std::abs(metres - frame.resolution * distance(a, b)) < 1e-9);
}

RC_GTEST_PROP(Frame, TurnsByTheYaw, ()) {
  const Frame frame = any_frame();
  const MapPoint origin = frame.to_metres(Point{0, 0});
  RC_ASSERT(distance(origin, frame.origin.point()) == 0);
  const MapPoint along_x = frame.to_metres(Point{1, 0});
  const double direction = std::atan2(along_x.y - origin.y, along_x.x - origin.x);
  RC_ASSERT(std::abs(normalized_angle(direction - frame.origin.heading)) < 1e-9);
  const MapPose pose = frame.to_metres(Pose{0, 0, 0.25});
  RC_ASSERT(std::abs(normalized_angle(pose.heading - frame.origin.heading - 0.25)) < 1e-12);
  // Counter-clockwise: y lies to the left of x, whatever is drawn.
  const MapPoint along_y = frame.to_metres(Point{0, 1});
  const double turn = (along_x.x - origin.x) * (along_y.y - origin.y) -
                      (along_x.y - origin.y) * (along_y.x - origin.x);
  RC_ASSERT(turn > 0);
}

TEST(Frame, OfAPlainGridChangesNothing) {
  const Frame plain;
  EXPECT_EQ(plain.to_metres(Point{3.5, -2}), (MapPoint{3.5, -2}));
  EXPECT_EQ(plain.cell_at({3.5, 2}), (Cell{3, 2}));
  EXPECT_FALSE(plain.y_up);
  EXPECT_FALSE(plain.metric);
}

TEST(Frame, OfAQuarterTurnIsWhatAPersonExpects) {
  const Frame frame{.resolution = 0.5, .origin = {10, 20, kPi / 2}, .y_up = true, .metric = true};
  const MapPoint metres = frame.to_metres(Point{4, 2});  // 2 m along the map's y, 1 m against x
  EXPECT_NEAR(metres.x, 9, 1e-12);
  EXPECT_NEAR(metres.y, 22, 1e-12);
  EXPECT_EQ(frame.cell_at({9.2, 21.7}), (Cell{3, 1}));
}

RC_GTEST_PROP(CellAt, IsTheCellThatAPointInsideLiesIn, ()) {
  const Frame frame = any_frame();
  const Cell cell{*rc::gen::inRange(-5000, 5000), *rc::gen::inRange(-5000, 5000)};
  const Point inside{cell.x + 0.5 + number_up_to(0.499), cell.y + 0.5 + number_up_to(0.499)};
  RC_ASSERT(frame.cell_at(frame.to_metres(inside)) == cell);
}

RC_GTEST_PROP(CellAt, GivesPointsCloseToABorderToTheGreaterSide, ()) {
  const Frame frame = any_frame();
  const Cell cell{*rc::gen::inRange(-2000, 2000), *rc::gen::inRange(-2000, 2000)};
  const double near_metres = 0.9 * kBorder;
  const double far_metres = 1.1 * kBorder;
  const auto at_corner_less = [&](double metres) {
    const double cells = metres / frame.resolution;
    return frame.cell_at(frame.to_metres(Point{cell.x - cells, cell.y - cells}));
  };
  RC_ASSERT(at_corner_less(0) == cell);
  RC_ASSERT(at_corner_less(near_metres) == cell);
  RC_ASSERT(at_corner_less(far_metres) == (Cell{cell.x - 1, cell.y - 1}));
}

TEST(CellAt, ForgivesRoundingInDecimals) {
  const Frame frame{.resolution = 0.1};
  EXPECT_LT(0.3 / 0.1, 3);  // the reason for the tolerance
  EXPECT_EQ(frame.cell_at({0.3, 0.7}), (Cell{3, 7}));
  for (int i = -3000; i < 3000; ++i) {
    ASSERT_EQ(frame.cell_at({i * 0.1, i / 10.0}), (Cell{i, i}));
  }
}

TEST(CellAt, RefusesNumbersThatNoCellHas) {
  for (const double resolution : {0.05, 1.0}) {
    for (const double heading : {0.0, 0.5}) {
      const Frame frame{.resolution = resolution, .origin = {0, 0, heading}};
      for (const double bad : {kNan, kInfinity, -kInfinity, 1e300, -1e300, 2e9}) {
        EXPECT_EQ(frame.cell_at({bad, 0}), std::nullopt) << bad;
        EXPECT_EQ(frame.cell_at({0, bad}), std::nullopt) << bad;
        EXPECT_EQ(frame.cell_at({bad, bad}), std::nullopt) << bad;
      }
    }
  }
}

TEST(CellAt, OfAPointIsTheCellAroundIt) {
  EXPECT_EQ(cell_at({3, 2.999}), (Cell{3, 2}));
  EXPECT_EQ(cell_at({-0.5, -1}), (Cell{-1, -1}));
  EXPECT_EQ(cell_at(pose_at({7, 1 << 20}).point()), (Cell{7, 1 << 20}));
}

TEST(CentreOf, IsHalfACellFromTheCorner) {
  EXPECT_EQ(centre_of({3, -2}), (Point{3.5, -1.5}));
  EXPECT_EQ(pose_at({3, -2}, 1.5), (Pose{3.5, -1.5, 1.5}));
}

}  // namespace
}  // namespace wend
