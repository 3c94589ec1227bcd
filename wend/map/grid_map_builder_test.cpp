#include "wend/map/grid_map_builder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wend {
namespace {

RC_GTEST_PROP(GridMapBuilder, BuildsWhatTheConstructorDoes, ()) {
  const int width = *rc::gen::inRange(1, 140);
  const int height = *rc::gen::inRange(1, 20);
  const Frame frame{0.5, {1, 2, 3}, *rc::gen::arbitrary<bool>(), true};
  const auto states = *rc::gen::container<std::vector<CellState>>(
      static_cast<std::size_t>(width * height),
      rc::gen::element(CellState::free, CellState::occupied, CellState::unknown));
  const auto rough_from = *rc::gen::inRange(0, 2 * height);  // rows from here on have terrain
  Grid<CellState> cells(width, height);
  Grid<double> terrain(width, height, 1);
  GridMapBuilder rows(width);
  if (*rc::gen::arbitrary<bool>()) rows.reserve(height);
  for (int from_top = 0; from_top < height; ++from_top) {
    const int y = frame.y_up ? height - 1 - from_top : from_top;
    const auto row = std::span(states).subspan(static_cast<std::size_t>(from_top * width),
                                               static_cast<std::size_t>(width));
    std::vector<double> rough;
    if (from_top >= rough_from) rough.assign(row.size(), 1 + from_top % 3);
    std::copy(row.begin(), row.end(), cells.row(y).begin());
    std::copy(rough.begin(), rough.end(), terrain.row(y).begin());
    rows.append(row, rough);
    RC_ASSERT(rows.height() == from_top + 1);
  }
  const GridMap map = std::move(rows).finish(frame);
  const GridMap expected(cells, frame, terrain);
  RC_ASSERT(map.occupied() == expected.occupied());
  RC_ASSERT(map.unknown() == expected.unknown());
  RC_ASSERT(map.terrain() == expected.terrain());
  RC_ASSERT(map.frame() == expected.frame());
}

}  // namespace
}  // namespace wend
