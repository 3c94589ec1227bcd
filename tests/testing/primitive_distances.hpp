#pragma once

// PrimitiveDistances: Dijkstra's algorithm over a map of states, for the planner lattice: with fits_along() instead of
// swept cells, and lengths of segments instead of steps.

#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "wend/geometry/segment.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/motion_primitives.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend::test {

inline constexpr double kNoMotion = std::numeric_limits<double>::infinity();

struct GridPose {
  Cell cell;
  int heading;

  friend bool operator<(const GridPose& a, const GridPose& b) {
    return std::tie(a.cell.x, a.cell.y, a.heading) < std::tie(b.cell.x, b.cell.y, b.heading);
  }
};

/// Costs from a start to all states.
class PrimitiveDistances {
 public:
  PrimitiveDistances(const FreeSpace& space, const MotionPrimitives& primitives,
                     double reverse_factor, double turn_cost)
      : space_(space),
        primitives_(primitives),
        reverse_factor_(reverse_factor),
        turn_cost_(turn_cost) {}

  std::map<GridPose, double> from(const GridPose& start) const {
    std::map<GridPose, double> costs{{start, 0}};
    using Entry = std::pair<double, GridPose>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(0, start);
    while (!open.empty()) {
      const auto [cost, state] = open.top();
      open.pop();
      if (cost > costs.at(state)) continue;
      for (const MotionPrimitive& primitive : primitives_.leaving(state.heading)) {
        const GridPose next{{state.cell.x + primitive.by.x, state.cell.y + primitive.by.y},
                            primitive.to};
        const auto step = cost_of(primitive, state.cell);
        if (!space_.contains(next.cell) || !step) continue;
        const auto known = costs.find(next);
        if (known != costs.end() && known->second <= cost + *step) continue;
        costs[next] = cost + *step;
        open.emplace(cost + *step, next);
      }
    }
    return costs;
  }

 private:
  std::optional<double> cost_of(const MotionPrimitive& primitive, Cell cell) const {
    double cost = 0;
    for (std::size_t i = 1; i < primitive.poses.size(); ++i) {
      Segment segment = segment_between(primitive.poses[i - 1], primitive.poses[i]);
      segment.from.x += cell.x + 0.5;
      segment.from.y += cell.y + 0.5;
      for (int n = 0; n <= 20; ++n) {
        if (!cell_under(space_, pose_on(segment, n / 20.0).point())) return std::nullopt;
      }
      if (!fits_along(space_, segment)) return std::nullopt;
      cost += segment.length == 0  ? turn_cost_ * std::abs(segment.turn)
              : segment.length < 0 ? -segment.length * reverse_factor_
                                   : segment.length;
    }
    return cost * primitive.cost_factor;
  }

  const FreeSpace& space_;
  const MotionPrimitives& primitives_;
  double reverse_factor_;
  double turn_cost_;
};

}  // namespace wend::test
