#pragma once

// Visibility: the shortest paths of a point at any angle, by brute force and in whole numbers: Dijkstra's algorithm
// on the lines between all corners. It shares no code with what it checks.
//
// The rules, in words. A cell that is blocked, or off the map, is an open square that a path must not enter; so a
// path may touch squares and run along them.
// 1. A path does not run between two blocked squares that share an edge, along that edge.
// 2. At a vertex where exactly two blocked squares touch, diagonally, a path neither passes nor turns, unless
//    corner_rule is `both`. There it does both.
// 3. A path goes from the centre of a cell to the centre or another point of a cell, by lines. It turns at corners:
//    vertices at which exactly one of the four squares is blocked, or two as in rule 2. (Turning elsewhere shortens no
//    path.)
//
// Everything is in sixteenths of a cell: (16x + 8, 16y + 8) is the centre of cell (x, y), (16x, 16y) a vertex.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend::test {

class Visibility {
 public:
  static constexpr std::int64_t kCell = 16;  // units

  struct At {
    std::int64_t x;
    std::int64_t y;

    friend bool operator==(const At&, const At&) = default;
  };

  /// `free(cell)` is asked about cells of the map only.
  template <class Free>
  Visibility(int width, int height, Free&& free, bool passes_gaps)
      : width_(width), height_(height), passes_gaps_(passes_gaps) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) free_.push_back(free(Cell{x, y}) ? 1 : 0);
    }
  }

  /// Finds all lines between corners, for lengths_from(). O(corners^2 cells).
  void join_corners() {
    corners_.clear();
    lines_.clear();
    for (int y = 1; y < height_; ++y) {
      for (int x = 1; x < width_; ++x) {
        if (turns_at(x, y)) corners_.push_back({kCell * x, kCell * y});
      }
    }
    lines_.resize(corners_.size());
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      for (std::size_t j = 0; j < corners_.size(); ++j) {
        if (i != j && sees(corners_[i], corners_[j])) lines_[i].push_back(j);
      }
    }
  }

  static At centre(Cell cell) { return {kCell * cell.x + kCell / 2, kCell * cell.y + kCell / 2}; }
  /// Nothing for a point that is not a whole number of units from the vertices.
  static std::optional<At> at(Point point) {
    const auto units = static_cast<double>(kCell);
    const At at{std::llround(units * point.x), std::llround(units * point.y)};
    const bool whole = static_cast<double>(at.x) == units * point.x &&
                       static_cast<double>(at.y) == units * point.y;
    return whole ? std::optional(at) : std::nullopt;
  }

  /// Is the line free, by rules 1 and 2? Its ends are not looked at.
  bool sees(At a, At b) const {
    return !enters_a_square(a, b) && !runs_between(a, b) && !passes_a_gap(a, b);
  }

  /// The length of the shortest paths from a free cell to all others, in cells; infinite where there is none. Call
  /// join_corners() before.
  std::vector<double> lengths_from(Cell start) const {
    const std::vector<double> to_corner = lengths_to_corners(start);
    std::vector<double> lengths(free_.size(), kNever);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (is_free(x, y)) lengths[number(x, y)] = length_to(start, centre({x, y}), to_corner);
      }
    }
    return lengths;
  }

  /// The same to one point of a free cell.
  double length_between(Cell start, At goal) const {
    return length_to(start, goal, lengths_to_corners(start));
  }

  std::size_t number(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  /// What is wrong with a path from the centre of a cell to a point; empty if nothing is.
  std::string fault(std::span<const Point> path, Cell from, Point to) const {
    std::vector<At> points;
    for (const Point point : path) {
      const auto here = at(point);
      if (!here) return "a waypoint is neither an end nor a vertex";
      points.push_back(*here);
    }
    if (points.empty()) return "it is empty";
    if (points.front() != centre(from) || points.back() != at(to)) return "its ends are wrong";
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (!sees(points[i - 1], points[i])) return "line " + std::to_string(i) + " is not free";
      const bool is_vertex = points[i].x % kCell == 0 && points[i].y % kCell == 0;
      if (is_vertex && is_closed_gap(points[i])) return "it turns in a gap";
    }
    return {};
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  static double length(At a, At b) {
    const auto dx = static_cast<double>(a.x - b.x);
    const auto dy = static_cast<double>(a.y - b.y);
    return std::sqrt(dx * dx + dy * dy) / static_cast<double>(kCell);
  }

  bool is_free(std::int64_t x, std::int64_t y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ &&
           free_[number(static_cast<int>(x), static_cast<int>(y))] != 0;
  }

  bool is_gap(std::int64_t x, std::int64_t y) const {
    const bool low_left = is_free(x - 1, y - 1);
    const bool low_right = is_free(x, y - 1);
    return low_left == is_free(x, y) && low_right == is_free(x - 1, y) && low_left != low_right;
  }

  bool is_closed_gap(At at) const { return !passes_gaps_ && is_gap(at.x / kCell, at.y / kCell); }

  bool turns_at(int x, int y) const {
    const int blocked = (is_free(x - 1, y - 1) ? 0 : 1) + (is_free(x, y - 1) ? 0 : 1) +
                        (is_free(x - 1, y) ? 0 : 1) + (is_free(x, y) ? 0 : 1);
    return blocked == 1 || (passes_gaps_ && is_gap(x, y));
  }

  /// By separating axes: the box of the line overlaps the open square, and the square has corners on both sides.
  bool enters_a_square(At a, At b) const {
    const auto [left, right] = std::minmax(a.x, b.x);
    const auto [low, high] = std::minmax(a.y, b.y);
    for (std::int64_t row = low / kCell - 1; row <= high / kCell; ++row) {
      for (std::int64_t column = left / kCell - 1; column <= right / kCell; ++column) {
        if (is_free(column, row)) continue;
        const At one{kCell * column, kCell * row};
        const At other{one.x + kCell, one.y + kCell};
        if (right <= one.x || left >= other.x || high <= one.y || low >= other.y) continue;
        bool any_left = false;
        bool any_right = false;
        for (const At corner : {one, At{other.x, one.y}, At{one.x, other.y}, other}) {
          const std::int64_t side = (b.x - a.x) * (corner.y - a.y) - (b.y - a.y) * (corner.x - a.x);
          any_left = any_left || side > 0;
          any_right = any_right || side < 0;
        }
        if (any_left && any_right) return true;
      }
    }
    return false;
  }

  bool runs_between(At a, At b) const {
    if (a.x == b.x && a.x % kCell == 0) {
      const auto [low, high] = std::minmax(a.y, b.y);
      for (std::int64_t y = low / kCell; kCell * y < high; ++y) {
        if (!is_free(a.x / kCell - 1, y) && !is_free(a.x / kCell, y)) return true;
      }
    }
    if (a.y == b.y && a.y % kCell == 0) {
      const auto [left, right] = std::minmax(a.x, b.x);
      for (std::int64_t x = left / kCell; kCell * x < right; ++x) {
        if (!is_free(x, a.y / kCell - 1) && !is_free(x, a.y / kCell)) return true;
      }
    }
    return false;
  }

  bool passes_a_gap(At a, At b) const {
    if (passes_gaps_) return false;
    const auto [left, right] = std::minmax(a.x, b.x);
    const auto [low, high] = std::minmax(a.y, b.y);
    for (std::int64_t y = (low + kCell - 1) / kCell; kCell * y <= high; ++y) {
      for (std::int64_t x = (left + kCell - 1) / kCell; kCell * x <= right; ++x) {
        const At at{kCell * x, kCell * y};
        if (at == a || at == b || !is_gap(x, y)) continue;
        if ((b.x - a.x) * (at.y - a.y) == (b.y - a.y) * (at.x - a.x)) return true;
      }
    }
    return false;
  }

  /// Dijkstra's algorithm without a heap.
  void spread(std::vector<double>& to_corner) const {
    std::vector<char> closed(corners_.size(), 0);
    for (;;) {
      std::optional<std::size_t> next;
      for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (closed[i] == 0 && to_corner[i] < kNever && (!next || to_corner[i] < to_corner[*next])) {
          next = i;
        }
      }
      if (!next) return;
      closed[*next] = 1;
      for (const std::size_t to : lines_[*next]) {
        to_corner[to] =
            std::min(to_corner[to], to_corner[*next] + length(corners_[*next], corners_[to]));
      }
    }
  }

  std::vector<double> lengths_to_corners(Cell start) const {
    std::vector<double> to_corner(corners_.size(), kNever);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (sees(centre(start), corners_[i])) to_corner[i] = length(centre(start), corners_[i]);
    }
    spread(to_corner);
    return to_corner;
  }

  double length_to(Cell start, At goal, const std::vector<double>& to_corner) const {
    if (sees(centre(start), goal)) return length(centre(start), goal);
    double least = kNever;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const double here = to_corner[i] + length(corners_[i], goal);
      if (here < least && sees(corners_[i], goal)) least = here;
    }
    return least;
  }

  int width_;
  int height_;
  bool passes_gaps_;
  std::vector<char> free_;
  std::vector<At> corners_;
  std::vector<std::vector<std::size_t>> lines_;  // of each corner, to others
};

}  // namespace wend::test
