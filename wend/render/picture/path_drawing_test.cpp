// A car's path in pixels.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "wend/geometry/compass.hpp"
#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/png_picture_test.hpp"
#include "wend/robot/car_primitives.hpp"

namespace wend {
namespace {

constexpr std::uint32_t kFreeColour = 0xFFFFFF;
constexpr std::uint32_t kPathColour = 0x0072B2;
constexpr std::uint32_t kReverse = 0x1B1E24;
constexpr std::uint32_t kStartColour = 0x009E73;
constexpr std::uint32_t kGoalColour = 0xD55E00;
constexpr int kPixels = 340;  // of a picture, at most

Scene driven_yard(int width, int height, bool y_up = false) {
  Scene scene{.space =
                  *make_free_space(*make_grid_map(Grid<CellState>(width, height), {.y_up = y_up}))};
  scene.places = corners_of(scene.space);
  return scene;
}

/// A scene as pixels, and where its points lie in them.
class Drawn {
 public:
  explicit Drawn(const Scene& scene) : pixels_(draw_pixels(scene, kPixels, kPixels)) {
    const Margins axes = axis_room(scene);
    view_ = fitted_view(scene.space.map(), kPixels - axes.across(), kPixels - axes.down(), 1);
    view_.left = axes.left;
    view_.top = axes.top;
  }

  double scale() const { return view_.scale(); }
  const Grid<std::uint32_t>& pixels() const { return pixels_; }
  const MapView& view() const { return view_; }

  std::uint32_t at(Point grid, double right = 0, double down = 0) const {
    const Point point = view_.to_picture(grid);
    return pixels_[{static_cast<int>(std::floor(point.x + right)),
                    static_cast<int>(std::floor(point.y + down))}];
  }

 private:
  Grid<std::uint32_t> pixels_;
  MapView view_;
};

struct Move {
  CornerPose from;
  CarMove move;
  bool y_up;

  Path path() const { return Path::through({pose_of(from), pose_of(moved(from, move))}); }
};

/// Every move with every heading, from the middle of a driven_yard.
std::vector<Move> all_moves() {
  std::vector<Move> moves;
  for (const bool y_up : {false, true}) {
    for (const Heading heading : kAllHeadings) {
      for (int i = 0; i < kCarMoves; ++i) {
        moves.push_back({{{2, 2}, heading}, static_cast<CarMove>(i), y_up});
      }
    }
  }
  return moves;
}

std::ostream& operator<<(std::ostream& out, const Move& move) {
  const Frame frame{.y_up = move.y_up};
  return out << name_of(move.move, frame) << " from " << letter_of(move.from.heading, frame)
             << (move.y_up ? ", y up" : ", y down");
}

TEST(DrivenPath, FollowsEveryArcSolidAheadAndDashedInReverse) {
  for (const Move& move : all_moves()) {
    Scene scene = driven_yard(4, 4, move.y_up);
    scene.path = move.path();
    const Drawn drawn(scene);
    const Arc arc = scene.path.arcs().front();
    std::set<std::uint32_t> colours;
    for (double share = 0.25; share <= 0.75; share += 0.01) {
      colours.insert(drawn.at(pose_on(arc, share * arc.length).point()));
    }
    if (is_reverse(move.move)) {
      EXPECT_TRUE(colours.contains(kReverse) && colours.contains(kFreeColour)) << move;
      EXPECT_FALSE(colours.contains(kPathColour)) << move;
    } else {
      EXPECT_EQ(colours, std::set{kPathColour}) << move;
    }
  }
}

TEST(DrivenPath, CutsNoCorner) {
  for (const Move& move : all_moves()) {
    if (!is_turn(move.move)) continue;
    Scene scene = driven_yard(4, 4, move.y_up);
    scene.path = move.path();
    const Drawn drawn(scene);
    const Pose from = scene.path.poses().front();
    const Pose to = scene.path.poses().back();
    EXPECT_EQ(drawn.at({(from.x + to.x) / 2, (from.y + to.y) / 2}), kFreeColour) << move;
  }
}

TEST(DrivenPath, PointsAnArrowAlongTheHeadingOfEachPose) {
  for (const bool y_up : {false, true}) {
    for (const Heading heading : kAllHeadings) {
      Scene scene = driven_yard(4, 4, y_up);
      scene.path = Path::through({pose_of({{2, 2}, heading})});
      const Drawn drawn(scene);
      const Cell along = ahead(on_page(heading, {.y_up = y_up}));
      constexpr double kTip = 8;   // pixels; an arrow is 20 long
      constexpr double kSide = 5;  // and narrower than that ahead
      EXPECT_EQ(drawn.at({2, 2}), kPathColour);
      EXPECT_EQ(drawn.at({2, 2}, kTip * along.x, kTip * along.y), kPathColour)
          << radians_of(heading);
      EXPECT_NE(drawn.at({2, 2}, -kTip * along.x, -kTip * along.y), kPathColour) << "its notch";
      EXPECT_EQ(drawn.at({2, 2}, -kSide * (along.x + along.y), -kSide * (along.y - along.x)),
                kPathColour)
          << "a barb";
    }
  }
}

TEST(DrivenPath, SharesArrowsAmongPosesThatLieClose) {
  Scene scene = driven_yard(100, 100);
  Path path;
  for (int x = 0; x <= 100; ++x) path.drive_to({static_cast<double>(x), 50, 0});
  scene.path = path;
  const Drawn drawn(scene);
  ASSERT_EQ(drawn.scale(), 2);
  int arrows = 0;
  bool before = false;
  for (double x = 1; x < 99; x += 0.5) {
    const bool barb = drawn.at({x, 50}, 0, 2) == kPathColour;
    arrows += barb && !before;
    before = barb;
  }
  EXPECT_GE(arrows, 8);
  EXPECT_LE(arrows, 12);
}

TEST(DrivenPath, ShowsDashesWhereACarComesBackTheWayItWent) {
  Scene scene = driven_yard(4, 4);
  scene.path = Path::through({{1, 2, 0}, {3, 2, 0}, {1, 2, 0}});
  const Drawn drawn(scene);
  std::set<std::uint32_t> colours;
  for (double x = 1.4; x < 2.6; x += 0.02) colours.insert(drawn.at({x, 2}));
  EXPECT_TRUE(colours.contains(kReverse));
  EXPECT_FALSE(colours.contains(kPathColour));
}

TEST(DrivenPath, EndsAtTheEdgeOfTheMap) {
  Scene scene = driven_yard(4, 4);
  scene.path = Path::through({{2, 2, 0}, {40, 2, 0}, {39, 1, -kPi / 2}, {39, -300, -kPi / 2}});
  const Drawn drawn(scene);
  EXPECT_EQ(drawn.at({3.5, 2}), kPathColour);
  const auto right = static_cast<int>(drawn.view().left) + drawn.view().width + 8;
  for (int y = 0; y < drawn.pixels().height(); ++y) {
    for (int x = right; x < drawn.pixels().width(); ++x) {
      ASSERT_EQ((drawn.pixels()[{x, y}]), rgb_of(Style{}.page)) << x << ", " << y;
    }
  }
}

TEST(DrivenPath, IsWholeAlongTheEdgeOfTheMap) {
  Scene scene = driven_yard(4, 4);
  scene.path = Path::through({{0, 0, 0}, {4, 0, 0}});
  const Drawn drawn(scene);
  EXPECT_EQ(drawn.at({2.5, 0}, 0, 1.5), kPathColour);
  EXPECT_EQ(drawn.at({2.5, 0}, 0, -2), kPathColour) << "outside too";
}

TEST(DrivenPath, MayBeEmpty) { EXPECT_EQ(Drawn(driven_yard(4, 4)).at({2.5, 2.5}), kFreeColour); }

TEST(DrivenPath, ComesAsCurvesInASvg) {
  Scene scene = driven_yard(4, 4);
  scene.path = Path::through({{1, 1, 0}, {2, 2, kPi / 2}});
  const auto svg = draw_svg(scene);
  ASSERT_TRUE(svg);
  EXPECT_TRUE(well_formed(*svg));
  EXPECT_TRUE(contains(*svg, " C "));
}

TEST(Marks, HaveATipThatPointsAlongTheirHeading) {
  for (const bool y_up : {false, true}) {
    for (const Heading heading : kAllHeadings) {
      Scene scene = driven_yard(4, 4, y_up);
      scene.start = pose_of({{1, 1}, heading});
      scene.goals = {pose_of({{3, 3}, opposite(heading)}), Point{1, 3}};
      const Drawn drawn(scene);
      const Cell along = ahead(on_page(heading, {.y_up = y_up}));
      const double tip = 1.3 * 0.75 * 18;  // pixels
      EXPECT_EQ(drawn.at({1, 1}, tip * along.x, tip * along.y), kStartColour)
          << radians_of(heading);
      EXPECT_NE(drawn.at({1, 1}, -tip * along.x, -tip * along.y), kStartColour);
      EXPECT_EQ(drawn.at({3, 3}, -tip * along.x, -tip * along.y), kGoalColour)
          << radians_of(heading);
      EXPECT_NE(drawn.at({3, 3}, tip * along.x, tip * along.y), kGoalColour);
      EXPECT_NE(drawn.at({1, 3}, tip, 0), kGoalColour) << "any heading will do";
      EXPECT_EQ(drawn.at({1, 3}), kGoalColour);
    }
  }
}

}  // namespace
}  // namespace wend
