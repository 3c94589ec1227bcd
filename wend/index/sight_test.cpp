#include "wend/index/sight.hpp"

#include <gtest/gtest.h>

#include "wend/index/brute_distances_test.hpp"

namespace wend {
namespace {

TEST(Sight, IsTheWayWithTheDiagonalStepsFirst) {
  test::for_small_boards(400, [](const BitGrid& bits) {
    SCOPED_TRACE(test::text_of(bits));
    const Sight sight(bits);
    for (const Cell from : test::passable_cells(bits)) {
      for (const Cell to : test::passable_cells(bits)) {
        ASSERT_EQ(sight.sees(from, to), test::brute_sees(bits, from, to))
            << from.x << "," << from.y << " to " << to.x << "," << to.y;
      }
    }
  });
}

}  // namespace
}  // namespace wend
