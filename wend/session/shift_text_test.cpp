#include "wend/session/shift_text.hpp"

#include <gtest/gtest.h>

#include "tests/testing/drawn_map.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

TEST(ShiftText, SaysHowFarAnEndIsInTheUnitsOfTheMap) {
  const Units cells(test::drawn_map("..."));
  EXPECT_EQ(shift_text({}, cells), "");
  EXPECT_EQ(shift_text({1e-12, 1e-12}, cells), "") << "rounding";
  EXPECT_EQ(shift_text({1, 0}, cells), "1 cell from what was asked");
  EXPECT_EQ(shift_text({1.5, radians_from(40)}, cells),
            "1.5 cells and 40 degrees from what was asked");
  EXPECT_EQ(shift_text({0, radians_from(40)}, cells), "40 degrees from what was asked");
  const Grid<CellState> free(3, 1, CellState::free);
  const Units metres(*make_grid_map(free, {.resolution = 0.5, .metric = true}));
  EXPECT_EQ(shift_text({0.7, 0}, metres), "0.35 m from what was asked");
}

TEST(ShiftText, NamesTheEnds) {
  const Units cells(test::drawn_map("..."));
  EXPECT_EQ(shifts_text({}, {}, cells), "");
  EXPECT_EQ(shifts_text({}, {2, 0}, cells), "the goal 2 cells from what was asked");
  EXPECT_EQ(shifts_text({1, 0}, {2, 0}, cells),
            "the start 1 cell from what was asked, the goal 2 cells from what was asked");
}

}  // namespace
}  // namespace wend
