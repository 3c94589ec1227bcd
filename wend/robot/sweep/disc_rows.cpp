#include "wend/robot/sweep/disc_rows.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "wend/robot/cell_costs.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

/// Of what touches the disc within this distance along a row, in cells, the rows say nothing.
constexpr double kTouching = 1e-6;

/// An edge of the rectangle: x in terms of y.
struct RowEdge {
  double x;
  double y;
  double slope;

  double at(double other_y) const { return x + (other_y - y) * slope; }
};

/// The rectangle on both sides of a line, without the discs at its ends.
class SweptRectangle {
 public:
  /// The line leads upwards, and is not nearly parallel to an axis unless it is parallel to it.
  SweptRectangle(const Line& line, double radius) : rising_(line.to.x >= line.from.x) {
    const double dx = line.to.x - line.from.x;
    const double dy = line.to.y - line.from.y;
    const double length = line.length();
    const Point& leftmost = rising_ ? line.from : line.to;
    const Point& rightmost = rising_ ? line.to : line.from;
    const double beside = radius * dy / length;
    const double above = radius * std::abs(dx) / length;
    constexpr double kNone = std::numeric_limits<double>::infinity();
    low_ = line.from.y - above;
    high_ = line.to.y + above;
    first_ = leftmost.x - beside;
    last_ = rightmost.x + beside;
    left_side_ = right_side_ = {0, 0, 0};
    left_side_.x = left_end_.x = -kNone;
    right_side_.x = right_end_.x = kNone;
    if (dy != 0) {
      const double half_width = radius * length / dy;
      left_side_ = {line.from.x - half_width, line.from.y, dx / dy};
      right_side_ = {line.from.x + half_width, line.from.y, dx / dy};
    }
    if (dx != 0) {
      left_end_ = {leftmost.x, leftmost.y, -dy / dx};
      right_end_ = {rightmost.x, rightmost.y, -dy / dx};
    }
  }

  double low() const { return low_; }
  double high() const { return high_; }

  /// What it covers of row y: no edge is farther out than where it leaves the row, nor than its farthest corner.
  double left(double y) const {
    const double side = left_side_.at(rising_ ? y : y + 1);
    return std::max({side, left_end_.at(rising_ ? y + 1 : y), first_});
  }
  double right(double y) const {
    const double side = right_side_.at(rising_ ? y + 1 : y);
    return std::min({side, right_end_.at(rising_ ? y : y + 1), last_});
  }

 private:
  bool rising_;
  double low_;
  double high_;
  double first_;
  double last_;
  RowEdge left_side_{};
  RowEdge right_side_{};
  RowEdge left_end_{};  // where the line ends
  RowEdge right_end_{};
};

/// A number of at least 0, rounded; without the functions that a processor without SSE 4.1 calls for that.
int whole_below(double number) { return static_cast<int>(number); }
int whole_above(double number) {
  const int whole = static_cast<int>(number);
  return whole + (whole < number ? 1 : 0);
}

bool any_blocked(const BitGrid& blocked, int y, double left, double right) {
  const double most = blocked.width();
  const auto begin = static_cast<std::size_t>(whole_below(std::clamp(left, 0.0, most))) + 1;
  const auto end = static_cast<std::size_t>(whole_above(std::clamp(right, 0.0, most))) + 1;
  const auto words = blocked.row_words(y);
  for (std::size_t i = begin / 64; 64 * i < end; ++i) {
    std::uint64_t bits = words[i];
    if (64 * i < begin) bits &= ~std::uint64_t{0} << (begin % 64);
    if (64 * i + 64 > end) bits &= ~(~std::uint64_t{0} << (end % 64));
    if (bits != 0) return true;
  }
  return false;
}

/// Is one of a few points of the line so near to an obstacle that the middle of its cell shows it? Most lines that
/// cannot be followed are barred there.
bool is_barred_at_samples(const FreeSpace& space, const Line& line, double radius) {
  constexpr double kToMiddle = 0.7072;  // or less, from any point of a cell
  constexpr double kFar = 1000;         // whose square is a whole number of 32 bits
  constexpr int kMostParts = 16;
  if (distance_inside(space, line) < 0) return false;
  const double least = 2 * std::clamp(radius - kToMiddle, 0.0, kFar);
  const auto clear = static_cast<std::uint32_t>(least * least) + 1;
  const double length = line.length();
  for (int parts = 2; parts <= kMostParts && 2 * parts <= length; parts *= 2) {
    for (int i = 1; i < parts; i += 2) {
      const Cell cell = nearest_cell(space, line.at(static_cast<double>(i) / parts));
      if (space.squared_half_cell_clearance(cell, clear) < clear - 1) return true;
    }
  }
  return false;
}

/// Are distances between the line and obstacles whole half cells?
bool is_of_half_cells(const Line& line) {
  const auto is_whole = [](double number) { return number == std::trunc(number); };
  return (line.from.x == line.to.x || line.from.y == line.to.y) && is_whole(2 * line.from.x) &&
         is_whole(2 * line.from.y) && is_whole(2 * line.to.x) && is_whole(2 * line.to.y);
}

}  // namespace

std::optional<bool> disc_fits_by_rows(const FreeSpace& space, const Line& line) {
  constexpr double kLeastSlope = 1e-3;  // in cells: less is lost by rounding
  const auto is_slight = [](double way) { return way != 0 && std::abs(way) < kLeastSlope; };
  if (is_slight(line.to.x - line.from.x) || is_slight(line.to.y - line.from.y)) return {};
  if (line.from == line.to) return true;
  const bool up = line.to.y >= line.from.y;
  const double radius = std::sqrt(least_squared_half_cells(space.radius_in_cells())) / 2;
  if (is_barred_at_samples(space, line, radius)) return false;
  const SweptRectangle swept(up ? line : Line{line.to, line.from}, radius);
  const double rounding = is_of_half_cells(line) ? 0 : kTouching;
  const BitGrid& blocked = space.obstacles().blocked();
  const double height = space.height();
  const auto first_row = [&](double y) { return whole_below(std::clamp(y, 0.0, height)); };
  const auto end_row = [&](double y) { return whole_above(std::clamp(y, 0.0, height)); };
  const auto is_barred = [&](int y, double inwards) {
    return any_blocked(blocked, y, swept.left(y) + inwards, swept.right(y) - inwards);
  };
  const int first_inside = first_row(swept.low() + rounding);
  const int end_inside = end_row(swept.high() - rounding);
  bool touches = false;
  const int end = end_row(swept.high() + rounding);
  for (int y = first_row(swept.low() - rounding); y < end; ++y) {
    if (!is_barred(y, -rounding)) continue;
    touches = true;
    if (y >= first_inside && y < end_inside && is_barred(y, rounding)) return false;
  }
  return touches ? std::nullopt : std::optional(true);
}

}  // namespace wend
