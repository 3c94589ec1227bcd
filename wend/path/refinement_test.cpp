#include "wend/path/refinement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/polygon_overlap.hpp"
#include "tests/testing/random_path.hpp"
#include "tests/testing/random_polygon.hpp"
#include "tests/testing/share.hpp"
#include "wend/path/largest_distance.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

const Path kBend({{0, 4}, {0, 3}, {0, 2}, {0, 1}, {1, 0}, {2, 0}, {3, 0}, {4, 0}});

FreeSpace room() { return test::drawn_space(".....\n.....\n..#..\n.....\n....."); }

TEST(Refinement, DoesNothingUnlessAsked) {
  const auto same = refined(kBend, room(), {});
  ASSERT_TRUE(same);
  EXPECT_EQ(same->path, kBend);
  EXPECT_FALSE(same->smoothing);
}

TEST(Refinement, SimplifiesThenSmoothsThenResamples) {
  const FreeSpace space = room();
  const auto all = refined(kBend, space,
                           {.simplify = Simplification{SimplifyBy::collinear},
                            .smoother = SmootherChoice{"gradient", {{"beta", "0.4"}}},
                            .spacing = 0.25});
  ASSERT_TRUE(all);
  const Path simple = *without_collinear(kBend);
  const auto smooth = smooth_by_gradient(*resampled(simple, 1, space), space, {.beta = 0.4});
  ASSERT_TRUE(all->smoothing);
  EXPECT_EQ(all->smoothing->path, smooth->path);
  EXPECT_EQ(all->path, *resampled(smooth->path, 0.25, space));
}

TEST(Refinement, DividesLongLinesBetweenCellsBeforeItSmooths) {
  const FreeSpace space = room();
  const Path lines({{0, 4}, {0, 0}, {4, 0}});
  const auto smooth = refined(lines, space, {.smoother = SmootherChoice{"gradient", {}}});
  ASSERT_TRUE(smooth);
  const auto divided = smooth_by_gradient(*resampled(lines, 1, space), space, {});
  EXPECT_EQ(smooth->path, divided->path);
  EXPECT_GT(smooth->path.size(), 6U);
}

/// Lanes 80 cells long, 5 cells apart, by their ends.
Path lanes() {
  std::vector<Point> points;
  for (int lane = 0; lane < 9; ++lane) {
    const double y = 10 + 5.0 * lane;
    const bool back = lane % 2 == 1;
    points.push_back({back ? 90.0 : 10.0, y});
    points.push_back({back ? 10.0 : 90.0, y});
  }
  return Path::along(std::move(points));
}

/// The same line with points between some of its points.
Path with_points_between(Random& random, const Path& path) {
  const std::vector<Point> points = path.points();
  std::vector<Point> more{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const int pieces = random.chance(0.3) ? 1 : random.between(1, 200);
    for (int k = 1; k <= pieces; ++k) {
      more.push_back(Line{points[i - 1], points[i]}.at(static_cast<double>(k) / pieces));
    }
  }
  return Path::along(std::move(more));
}

TEST(Refinement, SmoothsALineHoweverDenselyItIsGiven) {
  const FreeSpace space = test::open_space(100, 60);
  const Path out_and_back = Path::along({{10, 10}, {50, 10.5}, {10, 11}});
  const Path hairpin = Path::along({{10, 10}, {80, 10}, {80, 13}, {10, 13}});
  for (const Path& path : {lanes(), out_and_back, hairpin}) {
    for (const char* smoother : {"gradient", "curvature"}) {
      SCOPED_TRACE(smoother);
      const auto smooth = refined(path, space, {.smoother = SmootherChoice{smoother}});
      ASSERT_TRUE(smooth);
      EXPECT_GT(smooth->path.length(), 0.7 * path.length());
      for (std::uint64_t seed = 1; seed <= test::share_of(5U); ++seed) {
        Random random(seed);
        const auto again = refined(with_points_between(random, path), space,
                                   {.smoother = SmootherChoice{smoother}});
        ASSERT_TRUE(again);
        EXPECT_LT(largest_distance(smooth->path, again->path), 0.1) << "seed " << seed;
      }
    }
  }
  const auto by_gradient = refined(lanes(), space, {.smoother = SmootherChoice{}});
  EXPECT_GT(by_gradient->path.length(), 0.92 * lanes().length());
}

TEST(Refinement, KeepsNearThePathAsFarAsAsked) {
  const FreeSpace space = test::open_space(100, 60);
  const Path drive =
      Path::through({{10, 10, 0}, {30, 10, 0}, {40, 20, kPi / 2}, {40, 40, kPi / 2}});
  for (const Path& path : {lanes(), Path::along({{10, 10}, {50, 10.5}, {10, 11}}), drive}) {
    for (const double most : {0.0, 0.5, 1.0, 3.0}) {
      for (const char* smoother : {"gradient", "curvature"}) {
        const auto smooth = refined(
            path, space, {.smoother = smoother_for(path, {smoother}), .max_distance = most});
        if (path.driven() && std::string_view(smoother) == "curvature") {
          EXPECT_FALSE(smooth);
          continue;
        }
        ASSERT_TRUE(smooth) << smooth.error().message;
        EXPECT_LE(largest_distance(path, smooth->path), std::max(most, 0.5) + 1e-6) << smoother;
        EXPECT_EQ(smooth->smoothing->distance, largest_distance(path, smooth->path));
      }
    }
  }
  const auto wrong = refined(lanes(), space, {.smoother = SmootherChoice{}, .max_distance = -1.0});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().status, Status::invalid_option);
}

TEST(Refinement, SimplifiesByWhatIsAsked) {
  const FreeSpace space = room();
  EXPECT_EQ(refined(kBend, space, {.simplify = Simplification{SimplifyBy::tolerance, 0.8}})->path,
            *simplified(kBend, 0.8, space));
  EXPECT_EQ(refined(kBend, space, {.simplify = Simplification{SimplifyBy::sight}})->path,
            *string_pulled(kBend, space));
}

TEST(Refinement, SqueezesWhereThePathMay) {
  const FreeSpace space = test::drawn_space("..#\n.#.\n...");
  const Path through({{0, 0}, {1, 0}, {2, 1}, {2, 2}});
  const Refinement smooth{.smoother = SmootherChoice{}};
  EXPECT_EQ(refined(through, space, smooth).error().status, Status::unsupported_query);
  const auto squeezed = refined(
      through, space,
      {.smoother = SmootherChoice{}, .spacing = 0.5, .adjacency = Adjacency::edges_and_corners});
  ASSERT_TRUE(squeezed);
  EXPECT_FALSE(first_collision(squeezed->path, space, Adjacency::edges_and_corners));
}

Refinement random_refinement(Random& random) {
  Refinement refinement;
  if (random.chance(0.5)) {
    const auto by = test::one_of<SimplifyBy>(
        random, std::array{SimplifyBy::collinear, SimplifyBy::tolerance, SimplifyBy::sight});
    refinement.simplify = Simplification{by, test::number_between(random, 0, 2)};
  }
  if (random.chance(0.7)) {
    refinement.smoother = random.chance(0.7)
                              ? SmootherChoice{"gradient", {{"alpha", "0.02"}, {"beta", "0.4"}}}
                              : SmootherChoice{"curvature", {{"radius", "2"}}};
  }
  if (random.chance(0.3)) refinement.spacing = test::number_between(random, 0.2, 3);
  return refinement;
}

bool is_narrow(const Path& path, const FreeSpace& space) {
  const std::vector<Point> points = path.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!disc_fits_along(space, Line{points[i - 1], points[i]})) return true;
  }
  return false;
}

RC_GTEST_PROP(Refinement, OfAPolygonsPathStaysFree, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const GridMap map = test::random_map(random, random.between(4, 20), random.between(4, 20));
  const Polygon outline = test::random_outline(1.5);
  const FreeSpace space = *make_free_space(
      map, {.footprint = *Footprint::polygon(outline.scaled(map.frame().resolution)),
            .outside = test::random_outside(random)});
  const Path path = test::random_free_path(random, space, Adjacency::edges);
  if (path.empty()) return;
  RC_CLASSIFY(is_narrow(path, space), "where it fits at some headings only");
  const auto result = refined(path, space, random_refinement(random));
  if (!result) RC_FAIL(result.error().message + test::text_of(path));
  RC_ASSERT(!first_collision(result->path, space));
  RC_ASSERT(!first_collision(*rounded_corners(result->path, space, 0.3), space));
  const std::vector<Point> points = result->path.points();
  RC_ASSERT(points.front() == path.points().front());
  RC_ASSERT(points.back() == path.points().back());
  RC_ASSERT(result->path.length() <= path.length() + 1e-9);
  const auto blocked = test::blocked_squares(space);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i - 1] == points[i]) continue;
    const Line line{points[i - 1], points[i]};
    const Point middle = line.middle();
    RC_ASSERT(test::worst_overlap(space, blocked, {middle.x, middle.y, line.heading()}) < 1e-7);
  }
}

/// A robot that is longer than a corridor is wide, and a path that wobbles there.
struct NarrowCorridor {
  FreeSpace space = test::drawn_space("############\n............\n............\n############",
                                      {.footprint = *Footprint::polygon(*Polygon::make(
                                           {{1.5, 0.4}, {-1.5, 0.4}, {-1.5, -0.4}, {1.5, -0.4}})),
                                       .outside = OutsidePolicy::blocked});
  Path path =
      Path::along({{2, 2}, {3, 2.1}, {4, 1.9}, {5, 2.1}, {6, 1.9}, {7, 2.1}, {8, 1.9}, {9, 2}});
};

TEST(Refinement, SmoothsAPolygonsPathWhereItFitsAtSomeHeadingsOnly) {
  const NarrowCorridor corridor;
  ASSERT_FALSE(first_collision(corridor.path, corridor.space));
  for (const std::string smoother : {"gradient", "curvature"}) {
    const auto smooth = refined(corridor.path, corridor.space,
                                {.smoother = SmootherChoice{smoother, {{"alpha", "0.01"}}}});
    ASSERT_TRUE(smooth);
    EXPECT_LT(smooth->path.length(), 0.1 * corridor.path.length() + 0.9 * 7);
    EXPECT_FALSE(first_collision(smooth->path, corridor.space));
  }
}

TEST(Refinement, SimplifiesAPolygonsPathWhereItFitsAtSomeHeadingsOnly) {
  const NarrowCorridor corridor;
  const Path straight = Path::along({{2, 2}, {9, 2}});
  EXPECT_EQ(*string_pulled(corridor.path, corridor.space), straight);
  EXPECT_EQ(*simplified(corridor.path, 0.2, corridor.space), straight);
  EXPECT_EQ(resampled(straight, 1, corridor.space)->size(), 8U);
}

/// The headings of the pieces of a line differ by rounding, which is not a turn.
TEST(Refinement, DividesALineOnWhichAPolygonTouchesWalls) {
  const FreeSpace space = test::drawn_space(
      "##########\n..........\n..........\n##########",
      {.footprint =
           *Footprint::polygon(*Polygon::make({{1.5, 1}, {-1.5, 1}, {-1.5, -1}, {1.5, -1}})),
       .outside = OutsidePolicy::blocked});
  const double little = 1e-12;
  const Path line = Path::along({{1.5, 2}, {3.1, 2 + little}, {8.3, 2}});
  EXPECT_FALSE(first_collision(line, space));
  EXPECT_FALSE(first_collision(*resampled(line, 0.7, space), space));
}

TEST(Refinement, TellsWhatItCannotDo) {
  const FreeSpace space = room();
  const auto unknown = refined(kBend, space, {.smoother = SmootherChoice{"gradien"}});
  EXPECT_EQ(unknown.error().status, Status::invalid_option);
  EXPECT_THAT(unknown.error().message, ::testing::HasSubstr("did you mean 'gradient'?"));
  const Path drive = Path::through({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(refined(drive, space, {.simplify = Simplification{}}).error().status,
            Status::unsupported_query);
  EXPECT_EQ(refined(drive, space, {.smoother = SmootherChoice{"curvature"}}).error().status,
            Status::unsupported_query);
  EXPECT_EQ(refined(drive, space, {.spacing = 0.5})->path.size(), 3U);
}

/// "Now" comes after some questions. What is smoothed by then is free, and lies between the path and the result.
TEST(Smoothers, StopWhenTheyAreToldAndStayFree) {
  const FreeSpace space = test::open_space(60, 60);
  std::vector<Cell> bends;
  for (int i = 0; i < 50; ++i) bends.push_back({5 + i, i % 10 < 5 ? 20 : 30});
  const Path path = *resampled(Path(bends), 1, space);
  for (const char* name : {"gradient", "curvature"}) {
    const auto smoother = make_smoother(name);
    for (const int most : {0, 1, 3}) {
      int asked = 0;
      const auto smoothed = (*smoother)(path, space, [&] { return asked++ >= most; });
      ASSERT_TRUE(smoothed) << name;
      EXPECT_TRUE(smoothed->stopped) << name;
      EXPECT_FALSE(smoothed->converged) << name;
      EXPECT_LE(smoothed->sweeps, static_cast<std::uint64_t>(most)) << name;
      EXPECT_EQ(asked, most + 1) << name << ": it is not asked again";
      EXPECT_FALSE(first_collision(smoothed->path, space)) << name;
    }
    const auto whole = (*smoother)(path, space, [] { return false; });
    ASSERT_TRUE(whole) << name;
    EXPECT_FALSE(whole->stopped) << name;
    EXPECT_EQ(whole->path, (*smoother)(path, space)->path) << name;
  }
}

}  // namespace
}  // namespace wend
