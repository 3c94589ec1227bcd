#pragma once

// CheckedAnswers: what a planner answers for a disc on a map that changes, compared cell by cell with the map that each
// answer names.

#include <geometry_msgs/Point.h>
#include <wend_ros/PlanResult.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "map_history.hpp"

namespace wend_ros {

inline constexpr double kResolution = 0.05;  // m
inline constexpr double kRadius = 0.3;       // m, as in changing_map.test

/// Is the robot's disc free of occupied cells with its middle there? Cell by cell.
inline bool is_free(const ValueMap& map, double x, double y) {
  const double radius = kRadius / kResolution;
  const int reach = static_cast<int>(radius) + 1;
  for (int row = static_cast<int>(y) - reach; row <= static_cast<int>(y) + reach; ++row) {
    for (int column = static_cast<int>(x) - reach; column <= static_cast<int>(x) + reach;
         ++column) {
      const bool inside = column >= 0 && row >= 0 && column < map.side && row < map.side;
      if (inside && map.at(column, row) != 100) continue;
      const double dx = std::max({column - x, x - column - 1, 0.0});
      const double dy = std::max({row - y, y - row - 1, 0.0});
      if (std::hypot(dx, dy) < radius - 1e-6) return false;
    }
  }
  return true;
}

/// 1 where the robot's disc does not fit, cell by cell.
inline ValueMap blocked_cells(const ValueMap& map) {
  const double radius = kRadius / kResolution - 1e-6;
  const int reach = static_cast<int>(radius) + 1;
  ValueMap blocked(map.side);
  for (int y = 0; y < map.side; ++y) {
    for (int x = 0; x < map.side; ++x) {
      const double edge = std::min({x, y, map.side - 1 - x, map.side - 1 - y}) + 0.5;
      if (edge < radius) blocked.at(x, y) = 1;
      if (map.at(x, y) != 100) continue;
      for (int row = std::max(0, y - reach); row <= std::min(map.side - 1, y + reach); ++row) {
        for (int column = std::max(0, x - reach); column <= std::min(map.side - 1, x + reach);
             ++column) {
          const double dx = std::max(std::abs(column - x) - 0.5, 0.0);
          const double dy = std::max(std::abs(row - y) - 0.5, 0.0);
          if (std::hypot(dx, dy) < radius) blocked.at(column, row) = 1;
        }
      }
    }
  }
  return blocked;
}

/// Do steps to the side lead from one place to the other? By flooding.
inline bool are_connected(const ValueMap& map, const geometry_msgs::Point& from,
                          const geometry_msgs::Point& to) {
  ValueMap closed = blocked_cells(map);
  const auto cell_of = [](double metres) { return static_cast<int>(metres / kResolution); };
  std::vector<std::pair<int, int>> open{{cell_of(from.x), cell_of(from.y)}};
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    if (x < 0 || y < 0 || x >= map.side || y >= map.side || closed.at(x, y) != 0) continue;
    if (x == cell_of(to.x) && y == cell_of(to.y)) return true;
    closed.at(x, y) = 1;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      open.emplace_back(x + dx, y + dy);
    }
  }
  return false;
}

/// Counts answers, and those that are wrong: without the map that they name, not free on it, or without a path
/// where there is one.
class CheckedAnswers {
 public:
  CheckedAnswers(const MapHistory& history, ValueMap first) : replay_(history, std::move(first)) {}

  void check(const PlanResult& result, const geometry_msgs::Point& start,
             const geometry_msgs::Point& goal) {
    const std::lock_guard lock(mutex_);
    ++answers_;
    last_stamp_ = result.map_stamp;
    if (!replay_.go_to(result.map_stamp)) return fail("the map of its stamp was not published");
    if (result.status_name == "no_valid_path") return check_failure(result, start, goal);
    if (result.status != 0) return;
    ++found_;
    ages_.push_back(result.since_change);
    for (const auto& stamped : result.path.poses) {
      const auto& at = stamped.pose.position;
      if (!is_free(replay_.map(), at.x / kResolution, at.y / kResolution)) {
        return fail("not free at " + std::to_string(at.x) + ',' + std::to_string(at.y));
      }
    }
  }

  ros::Time last_stamp() const {
    const std::lock_guard lock(mutex_);
    return last_stamp_;
  }

  int answers() const { return answers_; }
  int found() const { return found_; }
  int flooded() const { return flooded_; }
  std::string fault() const { return fault_; }

  /// The median of the time since the change, ms.
  double age() {
    if (ages_.empty()) return 0;
    const auto middle = ages_.begin() + static_cast<std::ptrdiff_t>(ages_.size() / 2);
    std::nth_element(ages_.begin(), middle, ages_.end());
    return 1e3 * *middle;
  }

 private:
  /// Flooding takes long: the first few.
  void check_failure(const PlanResult& result, const geometry_msgs::Point& start,
                     const geometry_msgs::Point& goal) {
    constexpr int kMostFlooded = 5;
    if (flooded_ == kMostFlooded) return;
    ++flooded_;
    if (are_connected(replay_.map(), start, goal)) fail("there is a path: " + result.reason);
  }

  void fail(const std::string& what) {
    if (fault_.empty()) fault_ = "answer " + std::to_string(answers_) + ": " + what;
  }

  mutable std::mutex mutex_;
  MapReplay replay_;
  ros::Time last_stamp_;
  int answers_ = 0;
  int found_ = 0;
  int flooded_ = 0;
  std::string fault_;
  std::vector<double> ages_;
};

}  // namespace wend_ros
