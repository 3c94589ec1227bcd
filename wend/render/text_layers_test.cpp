#include "wend/render/text_layers.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "wend/render/text_map_test.hpp"

namespace wend {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(TextArrows, ShowsAPolicyAsDrawn) {
  Scene scene{.space = FreeSpace(map_of({
                  ".#.",
                  "..?",
                  "...",
              }))};
  scene.goals = {centre_of({2, 2})};
  Grid<std::optional<Direction>> policy(3, 3);
  policy[{0, 0}] = Direction::down;
  policy[{0, 1}] = Direction::down_right;
  policy[{1, 1}] = Direction::down;
  policy[{0, 2}] = Direction::right;
  policy[{1, 2}] = Direction::right;
  EXPECT_EQ(text_arrows(scene, policy), lines_of({
                                            "↓ # .",
                                            "↘ ↓ ?",
                                            "→ → G",
                                        }));
}

TEST(TextArrows, DrawsTheLastRowFirstWithYUp) {
  const Scene scene{.space = FreeSpace(map_of({"..", ".#"}, {.y_up = true}))};
  Grid<std::optional<Direction>> policy(2, 2);
  policy[{0, 0}] = Direction::up;  // the bottom row
  policy[{0, 1}] = Direction::up_right;
  EXPECT_EQ(text_arrows(scene, policy), lines_of({"↗ .", "↑ #"}));
}

TEST(TextNumbers, AlignsWholeNumbersWithoutDecimals) {
  const FreeSpace space(map_of({
      "...",
      ".#.",
  }));
  Grid<double> costs(3, 2);
  costs[{0, 0}] = 0;
  costs[{1, 0}] = 1;
  costs[{2, 0}] = 12;
  costs[{0, 1}] = 100;
  costs[{2, 1}] = kInfinity;
  EXPECT_EQ(text_numbers(space, costs), lines_of({
                                            "  0   1  12",
                                            "100   -   ∞",
                                        }));
  EXPECT_EQ(columns_a_number(costs), 4);
}

TEST(TextNumbers, ShowsAsManyDecimalsAsAreNeeded) {
  const FreeSpace space(map_of({"...."}));
  Grid<double> costs(4, 1);
  costs[{0, 0}] = 1.5;
  costs[{1, 0}] = 0.1 + 0.2;
  costs[{2, 0}] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(text_numbers(space, costs), "1.5 0.3   . 0.0\n");
  costs[{3, 0}] = 1 + std::numbers::sqrt2;
  EXPECT_EQ(text_numbers(space, costs), "1.50 0.30    . 2.41\n");
}

TEST(TextNumbers, DrawsTheLastRowFirstWithYUp) {
  const FreeSpace space(map_of({".", "."}, {.y_up = true}));
  Grid<double> costs(1, 2);
  costs[{0, 1}] = 7;
  EXPECT_EQ(text_numbers(space, costs), lines_of({"7", "0"}));
}

}  // namespace
}  // namespace wend
