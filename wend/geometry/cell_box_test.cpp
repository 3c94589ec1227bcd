#include "wend/geometry/cell_box.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wend {
namespace {

Cell random_cell() {
  const int x = *rc::gen::inRange(-6, 7);
  const int y = *rc::gen::inRange(-6, 7);
  return {x, y};
}

CellBox random_box() {
  const Cell begin = random_cell();
  const Cell end = random_cell();
  return {begin, end};
}

constexpr int kBeyond = 9;  // no box of this test reaches so far

template <class Check>
void for_cells_around(Check&& check) {
  for (int y = -kBeyond; y <= kBeyond; ++y) {
    for (int x = -kBeyond; x <= kBeyond; ++x) check(Cell{x, y});
  }
}

RC_GTEST_PROP(CellBox, CountsItsCells, ()) {
  const CellBox box = random_box();
  std::int64_t count = 0;
  for_cells_around([&](Cell cell) { count += box.contains(cell) ? 1 : 0; });
  RC_ASSERT(box.size() == count);
  RC_ASSERT(box.empty() == (count == 0));
}

RC_GTEST_PROP(CellBox, HasInCommonWhatLiesInBoth, ()) {
  const CellBox a = random_box();
  const CellBox b = random_box();
  const CellBox common = a.common_with(b);
  for_cells_around([&](Cell cell) {
    RC_ASSERT(common.contains(cell) == (a.contains(cell) && b.contains(cell)));
  });
}

RC_GTEST_PROP(CellBox, IsJoinedToTheLeastBoxOfBoth, ()) {
  const CellBox a = random_box();
  const CellBox b = random_box();
  const CellBox joined = a.joined_with(b);
  int least_x = kBeyond;
  int greatest_x = -kBeyond;
  for_cells_around([&](Cell cell) {
    if (!a.contains(cell) && !b.contains(cell)) return;
    RC_ASSERT(joined.contains(cell));
    least_x = std::min(least_x, cell.x);
    greatest_x = std::max(greatest_x, cell.x);
  });
  RC_ASSERT(joined.empty() == (a.empty() && b.empty()));
  if (!joined.empty()) RC_ASSERT(joined.width() == greatest_x + 1 - least_x);
}

RC_GTEST_PROP(CellBox, GrowsOnAllSides, ()) {
  const CellBox box = random_box();
  RC_PRE(!box.empty());
  const int by = *rc::gen::inRange(0, 3);
  const CellBox grown = box.grown_by(by);
  for_cells_around([&](Cell cell) {
    bool near = false;
    for (int dy = -by; dy <= by; ++dy) {
      for (int dx = -by; dx <= by; ++dx) near |= box.contains({cell.x + dx, cell.y + dy});
    }
    RC_ASSERT(grown.contains(cell) == near);
  });
}

}  // namespace
}  // namespace wend
