#include "wend/path/refinement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/testing/drawn_map.hpp"
#include "wend/path/gradient_smoother.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/simplification.hpp"

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
  const Path simple = without_collinear(kBend);
  const auto smooth = smooth_by_gradient(simple, space, {.beta = 0.4});
  ASSERT_TRUE(all->smoothing);
  EXPECT_EQ(all->smoothing->path, smooth->path);
  EXPECT_EQ(all->path, resampled(smooth->path, 0.25, space));
}

TEST(Refinement, DividesLongLinesBetweenCellsBeforeItSmooths) {
  const FreeSpace space = room();
  const Path lines({{0, 4}, {0, 0}, {4, 0}});
  const auto smooth = refined(lines, space, {.smoother = SmootherChoice{"gradient", {}}});
  ASSERT_TRUE(smooth);
  const auto divided = smooth_by_gradient(resampled(lines, 1, space), space, {});
  EXPECT_EQ(smooth->path, divided->path);
  EXPECT_GT(smooth->path.size(), 6U);
}

TEST(Refinement, SimplifiesByWhatIsAsked) {
  const FreeSpace space = room();
  EXPECT_EQ(refined(kBend, space, {.simplify = Simplification{SimplifyBy::tolerance, 0.8}})->path,
            simplified(kBend, 0.8, space));
  EXPECT_EQ(refined(kBend, space, {.simplify = Simplification{SimplifyBy::sight}})->path,
            string_pulled(kBend, space));
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

TEST(Refinement, TellsWhatItCannotDo) {
  const FreeSpace space = room();
  const auto unknown = refined(kBend, space, {.smoother = SmootherChoice{"gradien"}});
  EXPECT_EQ(unknown.error().status, Status::invalid_option);
  EXPECT_THAT(unknown.error().message, ::testing::HasSubstr("did you mean 'gradient'?"));
  const Path drive = Path::through({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(refined(drive, space, {.simplify = Simplification{}}).error().status,
            Status::unsupported_query);
  EXPECT_EQ(refined(drive, space, {.smoother = SmootherChoice{}}).error().status,
            Status::unsupported_query);
  EXPECT_EQ(refined(drive, space, {.spacing = 0.5})->path.size(), 3U);
}

}  // namespace
}  // namespace wend
