#include "wend/map/masked.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

// In cells: a point this near to a border belongs to the greater side, in spite of rounding.
constexpr double kBorder = 1e-6;

/// Where the middles of one grid's cells lie on another grid: an affine function of the cell.
class Placement {
 public:
  /// Both in metres.
  static Placement by_frames(const GridMap& from, const GridMap& to) {
    const Frame& one = from.frame();
    const Frame& other = to.frame();
    const Point first = other.to_grid(one.to_metres(Point{0.5, 0.5}));
    const double ratio = one.resolution / other.resolution;
    const double turn = one.origin.heading - other.origin.heading;
    const auto [sine, cosine] = sine_and_cosine(turn);
    return {to, first, {ratio * cosine, ratio * sine}, {-ratio * sine, ratio * cosine}};
  }

  /// Of the same size: the upper row on the upper row.
  static Placement as_drawn(const GridMap& from, const GridMap& to) {
    if (from.frame().y_up == to.frame().y_up) return {to, {0.5, 0.5}, {1, 0}, {0, 1}};
    return {to, {0.5, from.height() - 0.5}, {1, 0}, {0, -1}};
  }

  /// The cell of the other grid, if the middle is on it.
  std::optional<Cell> operator()(Cell cell) const {
    const double x = std::floor(first_.x + cell.x * right_.x + cell.y * below_.x + kBorder);
    const double y = std::floor(first_.y + cell.x * right_.y + cell.y * below_.y + kBorder);
    if (!(x >= 0 && y >= 0 && x < width_ && y < height_)) return std::nullopt;
    return Cell{static_cast<int>(x), static_cast<int>(y)};
  }

 private:
  Placement(const GridMap& to, Point first, Point right, Point below)
      : width_(to.width()), height_(to.height()), first_(first), right_(right), below_(below) {}

  double width_;
  double height_;
  Point first_;  // of the middle of cell (0, 0)
  Point right_;  // from a cell to the next in its row
  Point below_;  // to the next in its column
};

/// The map as it becomes.
class MaskedCells {
 public:
  MaskedCells(const GridMap& map, const GridMap& mask)
      : map_(map),
        mask_(mask),
        occupied_(map.occupied()),
        unknown_(map.unknown()),
        zones_(map.zones().begin(), map.zones().end()) {
    if (!mask.uniform_terrain()) factors_ = {map.width(), map.height(), 1};
  }

  void take(Cell cell, Cell of_mask) {
    touched_ = true;
    switch (mask_.state(of_mask)) {
      case CellState::unknown:
        return;
      case CellState::occupied:
        if (map_.state(cell) == CellState::free && !occupied_[cell]) add_to_zone(cell, of_mask);
        occupied_.set(cell, true);
        unknown_.set(cell, false);
        return;
      case CellState::free:
        break;
    }
    if (!factors_.empty()) factors_[cell] = std::max(factors_[cell], mask_.terrain(of_mask));
  }

  bool touched() const { return touched_; }

  Expected<GridMap, Error> finish() && {
    Grid<double> terrain = map_.terrain();
    if (terrain.empty()) {
      terrain = std::move(factors_);
    } else if (!factors_.empty()) {
      for (int y = 0; y < terrain.height(); ++y) {
        std::ranges::transform(terrain.row(y), std::as_const(factors_).row(y),
                               terrain.row(y).begin(), std::multiplies<>());
      }
    }
    auto made =
        make_grid_map(std::move(occupied_), std::move(unknown_), map_.frame(), std::move(terrain));
    if (!made) return made;
    for (MapZone& zone : zones_) made->add_zone(std::move(zone));
    return made;
  }

 private:
  /// The zone of the same name, made if there is none.
  void add_to_zone(Cell cell, Cell of_mask) {
    const MapZone* const own = mask_.zone(of_mask);
    const std::string_view name = own == nullptr ? std::string_view() : own->name;
    auto zone = std::ranges::find(zones_, name, &MapZone::name);
    if (zone == zones_.end()) {
      zone = zones_.insert(zone, {std::string(name), BitGrid(map_.width(), map_.height())});
    }
    zone->cells.set(cell, true);
  }

  const GridMap& map_;
  const GridMap& mask_;
  BitGrid occupied_;
  BitGrid unknown_;
  std::vector<MapZone> zones_;
  Grid<double> factors_;  // empty if the mask makes nothing dearer
  bool touched_ = false;
};

std::string size_text(const GridMap& map) {
  return std::to_string(map.width()) + " x " + std::to_string(map.height()) + " cells";
}

/// "x from 0 to 30.2 and y from 0 to 15.35 m": the box around a map.
std::string extent_text(const GridMap& map) {
  const auto width = static_cast<double>(map.width());
  const auto height = static_cast<double>(map.height());
  MapPoint least = map.frame().to_metres(Point{0, 0});
  MapPoint most = least;
  for (const Point corner : {Point{width, 0}, Point{0, height}, Point{width, height}}) {
    const MapPoint at = map.frame().to_metres(corner);
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y)};
  }
  return "x from " + format_number(least.x) + " to " + format_number(most.x) + " and y from " +
         format_number(least.y) + " to " + format_number(most.y) + " m";
}

bool share_metres(const GridMap& map, const GridMap& mask) {
  const Frame& one = map.frame();
  const Frame& other = mask.frame();
  return one.metric && other.metric && one.y_up == other.y_up;
}

std::string why_same_size(const GridMap& map, const GridMap& mask) {
  if (!map.frame().metric) return "the map has no resolution";
  if (!mask.frame().metric) return "the mask has no resolution";
  return "one has y up, the other y down";
}

Unexpected<Error> unfit(std::string message) {
  return failure(Status::invalid_map, std::move(message), "mask");
}

}  // namespace

Expected<GridMap, Error> masked(const GridMap& map, const GridMap& mask) {
  MaskedCells cells(map, mask);
  const bool by_frames = share_metres(map, mask);
  if (!by_frames && (map.width() != mask.width() || map.height() != mask.height())) {
    return unfit("the mask has " + size_text(mask) + ", the map " + size_text(map) + ", and " +
                 why_same_size(map, mask) + ": the same size expected");
  }
  const auto place = by_frames ? &Placement::by_frames : &Placement::as_drawn;
  const Placement on_mask = place(map, mask);
  for (const Cell cell : every_cell(map)) {
    if (const auto at = on_mask(cell)) cells.take(cell, *at);
  }
  const Placement on_map = place(mask, map);
  for (const Cell cell : every_cell(mask)) {
    if (const auto at = on_map(cell)) cells.take(*at, cell);
  }
  if (!cells.touched()) {
    return unfit("the mask does not touch the map: the mask covers " + extent_text(mask) +
                 ", the map " + extent_text(map));
  }
  return std::move(cells).finish();
}

Expected<GridMap, Error> mask_on_grid_of(const GridMap& map, const GridMap& mask) {
  const BitGrid none(map.width(), map.height());
  auto open = make_grid_map(none, none, map.frame());
  if (!open) return open;
  return masked(*open, mask);
}

MapEdit masked_edit(MapEdit edit, const GridMap& mask) {
  const CellBox box = edit.box();
  const auto on_map = [&](Cell cell) { return Cell{box.begin.x + cell.x, box.begin.y + cell.y}; };
  for (const Cell cell : every_cell(edit.states)) {
    if (mask.occupied()[on_map(cell)]) edit.states[cell] = CellState::occupied;
  }
  for (const Cell cell : every_cell(edit.terrain)) edit.terrain[cell] *= mask.terrain(on_map(cell));
  for (CellEdit& each : edit.cells) {
    if (mask.occupied()[each.cell]) each.state = CellState::occupied;
    if (each.terrain) *each.terrain *= mask.terrain(each.cell);
  }
  return edit;
}

}  // namespace wend
