#include "wend/render/scene.hpp"

#include <gtest/gtest.h>

#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

TEST(Scene, MarksTheEndsOfAPathOfCells) {
  const Scene scene = scene_of(*make_free_space(map_of({"..."})), Path({{0, 0}, {1, 0}}));
  EXPECT_EQ(scene.start, ScenePlace(Point{0.5, 0.5}));
  EXPECT_EQ(scene.goals, (std::vector<ScenePlace>{Point{1.5, 0.5}}));
  EXPECT_EQ(scene.path.size(), 2U);
  EXPECT_FALSE(scene.places.on_corners());
}

TEST(Scene, MarksTheEndsOfACarsPathWithTheirHeadings) {
  const Scene scene =
      scene_of(*make_free_space(map_of({"..."})), Path::through({{0, 0, 0}, {1, 1, kPi / 2}}));
  EXPECT_EQ(scene.start, ScenePlace(Pose{0, 0, 0}));
  EXPECT_EQ(scene.goals, (std::vector<ScenePlace>{Pose{1, 1, kPi / 2}}));
  EXPECT_EQ(scene.places, corners_of(scene.space));
}

TEST(Scene, MarksTheEndsOfItsLastLine) {
  const Scene scene =
      scene_of(*make_free_space(map_of({"..."})), {{LineRole::planned, {{0.5, 0.5}, {2.5, 0.5}}},
                                                   {LineRole::driven, {{0.5, 0.5}, {2.25, 0.25}}}});
  EXPECT_EQ(scene.start, ScenePlace(Point{0.5, 0.5}));
  EXPECT_EQ(scene.goals, (std::vector<ScenePlace>{Point{2.25, 0.25}}));
  EXPECT_EQ(scene.lines.size(), 2U);
  EXPECT_TRUE(scene.path.empty());
}

}  // namespace
}  // namespace wend
