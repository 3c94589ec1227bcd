#include "wend/session/units.hpp"

#include <cmath>
#include <optional>

#include "wend/base/number_text.hpp"
#include "wend/base/parse.hpp"

namespace wend {
namespace {

std::string pair(double x, double y) { return general_text(x, 6) + ',' + general_text(y, 6); }

/// The cell that a point lies in; nothing if a Cell cannot hold its numbers.
std::optional<Cell> cell_around(Point point) {
  constexpr double kMost = 1e9;
  const bool fits = std::abs(point.x) < kMost && std::abs(point.y) < kMost;
  return fits ? std::optional(cell_at(point)) : std::nullopt;
}

}  // namespace

Place Units::place(const std::string& name, Point point) const {
  constexpr Cell kFarOutside{-1, -1};
  const auto cell = cell_around(point);
  const bool is_centre = cell && point == centre_of(*cell);
  return {name, cell.value_or(kFarOutside), is_centre ? text(*cell) : text(point)};
}

std::string Units::text(Cell cell) const {
  if (!metric_) return cell_text(cell);
  return text(centre_of(cell));
}

std::string Units::text(Point point) const {
  const auto cell = cell_around(point);
  if (!metric_ && cell && point == centre_of(*cell)) return "cell " + cell_text(*cell);
  const std::string place =
      metric_ ? metres_text(frame_.to_metres(point)) : '(' + pair(point.x, point.y) + ')';
  return cell ? place + ", cell " + cell_text(*cell) : place;
}

std::string Units::radius(double cells) const {
  // A multiple of 1 / kDigits, up to rounding, is not rounded down.
  constexpr double kDigits = 1e4;
  const double radius = metric_ ? cells * frame_.resolution : cells;
  return format_number(std::floor(radius * kDigits * (1 + 1e-9)) / kDigits);
}

std::string Units::length(double cells) const {
  Frame named = frame_;
  named.metric = metric_;
  return distance_text(cells, named);
}

std::string Units::area(std::size_t cells) const {
  std::string count = std::to_string(cells) + (cells == 1 ? " cell" : " cells");
  if (!frame_.metric) return count;
  constexpr double kWhole = 100;  // square metres, from which fractions do not matter
  const double area = static_cast<double>(cells) * frame_.resolution * frame_.resolution;
  const std::string metres =
      area < kWhole ? general_text(area, 3) : std::to_string(std::llrint(area));
  return count + " (" + metres + " m2)";
}

std::string Units::extent() const {
  if (metric_) return covered_metres(frame_, width_, height_);
  return "the cells with x from 0 to " + std::to_string(width_ - 1) + " and y from 0 to " +
         std::to_string(height_ - 1);
}

std::string Units::extent_of_corners() const {
  if (metric_) return covered_metres(frame_, width_, height_);
  return "the grid vertices with x from 0 to " + std::to_string(width_) + " and y from 0 to " +
         std::to_string(height_);
}

}  // namespace wend
