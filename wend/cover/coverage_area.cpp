#include "wend/cover/coverage_area.hpp"

#include <cstdint>

#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

BitGrid component_of(const FreeSpace& space, Cell from) {
  BitGrid cells(space.width(), space.height());
  const ConnectedComponents& components = space.components();
  const std::uint32_t wanted = components.component(from, Adjacency::edges);
  for (const Cell cell : every_cell(cells)) {
    if (space.passable(cell) && components.component(cell, Adjacency::edges) == wanted) {
      cells.set(cell, true);
    }
  }
  return cells;
}

bool is_inner(const BitGrid& cells, Cell cell) {
  constexpr unsigned kAllNine = 511;
  return cells.block(cell) == kAllNine;
}

BitGrid reached_from(const BitGrid& places, double reach, const BitGrid& blocked) {
  BitGrid reached(places.width(), places.height());
  for (const Cell cell : every_cell(places)) {
    if (!places[cell]) continue;
    if (!blocked[cell]) reached.set(cell, true);
    if (is_inner(places, cell)) continue;
    const Point centre = centre_of(cell);
    visit_cells_near({centre, centre}, reach, places.width(), places.height(), [&](Cell near) {
      if (!blocked[near]) reached.set(near, true);
    });
  }
  return reached;
}

}  // namespace

double length_of(const Stroke& stroke) {
  double length = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) length += distance(stroke[i - 1], stroke[i]);
  return length;
}

CoverageArea::CoverageArea(const FreeSpace& space, Cell from, double tool_width)
    : space_(space),
      tool_width_(tool_width),
      reachable_(component_of(space, from)),
      wanted_(reached_from(reachable_, reach(), space.obstacles().blocked())),
      left_(wanted_),
      count_left_(left_.count()) {}

void CoverageArea::confine_to(const BitGrid& area) {
  for (const Cell cell : every_cell(wanted_)) {
    if (area[cell]) continue;
    wanted_.set(cell, false);
    left_.set(cell, false);
  }
  count_left_ = left_.count();
}

void CoverageArea::add_covered(const BitGrid& covered) {
  for (const Cell cell : every_cell(left_)) {
    if (covered[cell]) left_.set(cell, false);
  }
  count_left_ = left_.count();
}

bool CoverageArea::free_along(Point from, Point to) const {
  return reachable(cell_at(from)) && reachable(cell_at(to)) &&
         disc_fits_along(space_, Line{from, to});
}

void CoverageArea::cover(std::span<const Point> stroke) {
  const auto take = [&](Point from, Point to) {
    visit_left(from, to, [&](Cell cell) {
      left_.set(cell, false);
      --count_left_;
    });
  };
  if (stroke.size() == 1) take(stroke.front(), stroke.front());
  for (std::size_t i = 1; i < stroke.size(); ++i) take(stroke[i - 1], stroke[i]);
}

}  // namespace wend
