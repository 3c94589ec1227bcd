#include "wend/cover/stroke_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "wend/cover/coarse_ways.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/tour/cost_matrix.hpp"
#include "wend/tour/plan_tour.hpp"

namespace wend {
namespace {

constexpr std::size_t kMostStops = 8'000;  // half a gigabyte of costs
constexpr double kSight = 8;               // tool widths, up to which lines of sight are looked for

/// An end of a stroke, or a place of the robot.
struct Stop {
  Point place;
  std::optional<Point> leaving =
      {};  // the direction of who leaves the stroke here, of length 1; nothing: any
  std::size_t stroke = 0;
  bool front = true;
};

std::optional<Point> direction(Point from, Point to) {
  const double length = distance(from, to);
  if (length <= 0) return std::nullopt;
  return Point{(to.x - from.x) / length, (to.y - from.y) / length};
}

/// The share of half a turn between two directions; 0 where one of them does not matter.
double turn_between(const std::optional<Point>& from, const std::optional<Point>& to) {
  if (!from || !to) return 0;
  const double cross = from->x * to->y - from->y * to->x;
  const double dot = from->x * to->x + from->y * to->y;
  return std::abs(arc_tangent(cross, dot)) / kPi;
}

Point reversed(Point p) { return {-p.x, -p.y}; }

/// The stops of strokes: two for each, one for a stroke of a single point; then start and end.
std::vector<Stop> stops_of(const std::vector<Stroke>& strokes, const StrokeOrderOptions& options) {
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Stroke& stroke = strokes[i];
    if (stroke.size() == 1) {
      stops.push_back({stroke.front(), {}, i, true});
      continue;
    }
    stops.push_back({stroke.front(), direction(stroke[1], stroke[0]), i, true});
    stops.push_back({stroke.back(), direction(stroke[stroke.size() - 2], stroke.back()), i, false});
  }
  if (options.start) stops.push_back({*options.start, {}, strokes.size(), true});
  if (options.end) stops.push_back({*options.end, {}, strokes.size() + 1, true});
  return stops;
}

/// Costs between stops.
class StopCosts {
 public:
  StopCosts(const CoverageArea& area, const std::vector<Stop>& stops, double turn_cost)
      : area_(area),
        stops_(stops),
        turn_cost_(turn_cost),
        ways_(area, std::max(1, static_cast<int>(2 * area.tool_width()))) {}

  CostMatrix matrix() const {
    CostMatrix costs(static_cast<int>(stops_.size()), 0.0);
    std::vector<std::size_t> by_node(stops_.size());
    for (std::size_t i = 0; i < by_node.size(); ++i) by_node[i] = i;
    std::ranges::stable_sort(by_node, {}, [&](std::size_t i) { return node_of(stops_[i]); });
    std::vector<double> from_node;
    for (std::size_t k = 0; k < by_node.size(); ++k) {
      const std::size_t i = by_node[k];
      if (k == 0 || node_of(stops_[by_node[k - 1]]) != node_of(stops_[i])) {
        from_node = ways_.lengths_from(node_of(stops_[i]));
      }
      for (std::size_t j = 0; j < i; ++j) {
        const double cost = cost_between(stops_[i], stops_[j], from_node);
        costs.set(static_cast<int>(i), static_cast<int>(j), cost);
        costs.set(static_cast<int>(j), static_cast<int>(i), cost);
      }
    }
    return costs;
  }

 private:
  std::uint32_t node_of(const Stop& stop) const { return ways_.node_of(cell_at(stop.place)); }

  double cost_between(const Stop& a, const Stop& b, const std::vector<double>& from_a) const {
    const double straight = distance(a.place, b.place);
    if (straight <= 0) return turn_cost_ * turn_between(a.leaving, arriving(b));
    if (straight < kSight * area_.tool_width() && area_.free_along(a.place, b.place)) {
      const auto ahead = direction(a.place, b.place);
      return straight +
             turn_cost_ * (turn_between(a.leaving, ahead) + turn_between(ahead, arriving(b)));
    }
    const double coarse = from_a[node_of(b)] + distance(a.place, ways_.middle_of(node_of(a))) / 2 +
                          distance(b.place, ways_.middle_of(node_of(b))) / 2;
    return std::max(straight, coarse) + turn_cost_;
  }

  static std::optional<Point> arriving(const Stop& stop) {
    return stop.leaving ? std::optional(reversed(*stop.leaving)) : std::nullopt;
  }

  const CoverageArea& area_;
  const std::vector<Stop>& stops_;
  double turn_cost_;
  CoarseWays ways_;
};

TourOptions tour_options(const std::vector<Stop>& stops, const StrokeOrderOptions& options) {
  TourOptions tour;
  tour.kicks = options.kicks_per_stop * stops.size();
  tour.bound = false;
  tour.seed = options.seed;
  tour.limits = options.limits;
  for (int i = 0; i + 1 < static_cast<int>(stops.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (stops[at].stroke == stops[at + 1].stroke) tour.fixed.push_back({i, i + 1});
  }
  const int last = static_cast<int>(stops.size()) - 1;
  if (options.end) tour.end = last;
  if (options.start) tour.start = options.end ? last - 1 : last;
  return tour;
}

}  // namespace

Expected<std::vector<Stroke>, Error> ordered(const CoverageArea& area, std::vector<Stroke> strokes,
                                             const StrokeOrderOptions& options) {
  const std::vector<Stop> stops = stops_of(strokes, options);
  if (stops.size() < 2) return strokes;
  if (stops.size() > kMostStops) {
    return failure(
        Status::memory_limit,
        "the order of " + std::to_string(strokes.size()) +
            " strokes takes too much memory: cover parts of the map (area), one after the other");
  }
  const CostMatrix costs = StopCosts(area, stops, options.turn_cost).matrix();
  const auto tour = plan_tour(costs, tour_options(stops, options));
  if (!tour) return Unexpected<Error>(tour.error());
  std::vector<Stroke> result;
  std::size_t last = std::numeric_limits<std::size_t>::max();
  for (const int row : tour->order) {
    const Stop& stop = stops[static_cast<std::size_t>(row)];
    if (stop.stroke == last || stop.stroke >= strokes.size()) continue;
    last = stop.stroke;
    result.push_back(std::move(strokes[stop.stroke]));
    if (!stop.front) std::ranges::reverse(result.back());
  }
  return result;
}

}  // namespace wend
