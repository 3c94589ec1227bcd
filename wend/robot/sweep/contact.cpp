#include "wend/robot/sweep/contact.hpp"

#include <array>
#include <cmath>

#include "wend/base/parse.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend/robot/sweep/sweep.hpp"
#include "wend/robot/zone_name.hpp"

namespace wend {
namespace {

bool lies_in(Point point, Cell square) {
  const auto within = [](double value, int low) {
    return value > low + kOverlapTolerance && value < low + 1 - kOverlapTolerance;
  };
  return within(point.x, square.x) && within(point.y, square.y);
}

std::optional<Contact> contact_of(const FreeSpace& space, Point point, std::size_t corner) {
  const bool closed = space.outside() == OutsidePolicy::blocked;
  if (closed && distance_inside(space, point) < -kOverlapTolerance) return Contact{{}, corner, {}};
  const auto cell = cell_under(space, point);
  if (!cell || !space.obstacles().blocked()[*cell] || !lies_in(point, *cell)) return std::nullopt;
  return Contact{cell, corner, {}};
}

/// In which quadrant around the base point a corner lies, counted from the front on the +y side against the clock;
/// nothing on the axes.
std::optional<std::size_t> quadrant_of(Point corner) {
  if (corner.x == 0 || corner.y == 0) return std::nullopt;
  if (corner.y > 0) return corner.x > 0 ? 0 : 1;
  return corner.x < 0 ? 2 : 3;
}

bool has_a_corner_in_each_quadrant(const Polygon& outline) {
  std::array<int, 4> corners{};
  for (const Point corner : outline.corners()) {
    const auto quadrant = quadrant_of(corner);
    if (!quadrant || ++corners[*quadrant] > 1) return false;
  }
  return outline.corners().size() == corners.size();
}

std::string cell_text(Cell cell) {
  return '(' + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ')';
}

}  // namespace

std::optional<Contact> contact_at(const FreeSpace& space, const Pose& pose) {
  if (space.outline() == nullptr) return std::nullopt;
  const PlacedPolygon robot(*space.outline(), pose);
  for (std::size_t i = 0; i < robot.corners().size(); ++i) {
    if (const auto contact = contact_of(space, robot.corners()[i], i)) return contact;
  }
  std::optional<Contact> contact;
  any_obstacle(space, robot.box(), [&](Cell square) {
    if (robot.overlaps(square)) contact = Contact{square, {}, robot.side_across(square)};
    return contact.has_value();
  });
  return contact;
}

std::string corner_name(const Polygon& outline, std::size_t corner, const Frame& frame) {
  const Point at = outline.corners()[corner];
  if (!has_a_corner_in_each_quadrant(outline)) {
    return "corner (" + format_number(at.x) + ',' + format_number(at.y) + ')';
  }
  return std::string(at.x > 0 ? "front " : "rear ") +
         ((at.y > 0) == frame.y_up ? "left" : "right") + " corner";
}

std::string describe(const Contact& contact, const FreeSpace& space) {
  const Polygon& outline = *space.footprint().outline();
  const Frame& frame = space.map().frame();
  const auto named = [&](std::size_t corner) { return corner_name(outline, corner, frame); };
  if (!contact.obstacle) {
    return "its " + named(contact.corner.value_or(0)) + " reaches over the map's edge";
  }
  const bool unknown = space.map().state(*contact.obstacle) == CellState::unknown;
  const auto mask = mask_that_blocks(space, *contact.obstacle);
  const std::string cell =
      mask ? "the cell " + cell_text(*contact.obstacle) + " of " + *mask
           : (unknown ? "the unknown cell " : "the obstacle cell ") + cell_text(*contact.obstacle);
  if (contact.corner) return "its " + named(*contact.corner) + " lies in " + cell;
  if (!contact.side) return "it covers " + cell;
  const std::size_t next = (*contact.side + 1) % outline.corners().size();
  return "its side from the " + named(*contact.side) + " to the " + named(next) + " crosses " +
         cell;
}

}  // namespace wend
