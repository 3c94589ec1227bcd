#include <algorithm>
#include <array>
#include <utility>

#include "wend/analysis/widest_path.hpp"
#include "wend/cover/plan_coverage.hpp"
#include "wend/map/distance_field.hpp"

namespace wend {
namespace {

constexpr std::array<Cell, 8> kBesideMissed{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Takes the cells that hang together with one of them out of `cells`. The place is the one farthest from obstacles.
MissedPlace take_place(BitGrid& cells, Cell first, const FreeSpace& space) {
  MissedPlace place{.cell = first};
  std::vector<Cell> members{first};
  cells.set(first, false);
  std::uint32_t widest = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Cell from = members[i];
    const std::uint32_t clearance = space.squared_half_cell_clearance(from, kNoObstacle);
    if (clearance > widest) {
      widest = clearance;
      place.cell = from;
    }
    for (const Cell by : kBesideMissed) {
      const Cell to{from.x + by.x, from.y + by.y};
      if (!cells[to]) continue;
      cells.set(to, false);
      members.push_back(to);
    }
  }
  place.cells = members.size();
  return place;
}

void append_places(std::vector<MissedPlace>& places, BitGrid cells, bool reachable,
                   const FreeSpace& space) {
  for (const Cell cell : every_cell(cells)) {
    if (!cells[cell]) continue;
    places.push_back(take_place(cells, cell, space));
    places.back().reachable = reachable;
  }
}

/// A cell from which the robot gets everywhere that it can.
std::optional<Cell> robot_cell(const Coverage& coverage, const FreeSpace& space) {
  if (!coverage.path.empty()) return cell_at(coverage.path.points().front());
  for (const Cell cell : every_cell(coverage.wanted)) {
    if (coverage.wanted[cell] && space.passable(cell)) return cell;
  }
  return std::nullopt;
}

}  // namespace

std::vector<MissedPlace> missed_places(const FreeSpace& space, const Coverage& coverage,
                                       std::size_t most) {
  std::vector<MissedPlace> places;
  BitGrid left = coverage.wanted;
  for (const Cell cell : every_cell(left)) {
    if (coverage.covered[cell]) left.set(cell, false);
  }
  append_places(places, std::move(left), true, space);
  append_places(places, coverage.unreached, false, space);
  std::ranges::stable_sort(places, std::ranges::greater(), &MissedPlace::cells);
  if (places.size() > most) places.resize(most);
  const std::optional<Cell> robot = robot_cell(coverage, space);
  for (MissedPlace& place : places) {
    if (place.reachable || !robot) continue;
    const auto width = squared_half_cell_width(space, *robot, place.cell);
    if (width) place.radius = distance_in_cells(*width) * space.map().frame().resolution;
  }
  return places;
}

}  // namespace wend
