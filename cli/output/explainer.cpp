#include "cli/output/explainer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "cli/output/no_path_scene.hpp"
#include "wend/geometry/pose.hpp"

namespace wend::cli {

std::string Explainer::explain(Status status, const Ends& ends, const Limits& limits,
                               const SearchMetrics& metrics) const {
  switch (status) {
    case Status::start_outside:
      return outside(ends.start);
    case Status::goal_outside:
      return outside(ends.goal);
    case Status::start_blocked:
      return blocked_end(ends.start, ends.goal);
    case Status::goal_blocked:
      return blocked_end(ends.goal, ends.start);
    case Status::unreachable:
      return unreachable(ends);
    default:
      return explain_limit(status, limits, metrics);
  }
}

std::string Explainer::outside(const Place& place) const {
  return fmt::format("the {} {} lies outside the map, which covers {}", place.name, place.text,
                     coordinates_.extent());
}

std::string Explainer::blocked(const Place& place) const {
  const auto reason = space_.why_blocked(place.cell);
  if (!reason) return {};
  if (*reason == BlockReason::outside) return outside(place);
  return fmt::format("the {} {} is blocked: {}", place.name, place.text, why(place, *reason));
}

std::string Explainer::why(const Place& place, BlockReason reason) const {
  switch (reason) {
    case BlockReason::obstacle:
      return "it lies on an obstacle";
    case BlockReason::unknown:
      return "the cell is unknown (--unknown free takes such cells for free)";
    case BlockReason::too_close:
      return fmt::format("the nearest obstacle is {} away, the robot's radius is {}",
                         coordinates_.length(space_.clearance(place.cell)),
                         coordinates_.length(space_.radius_in_cells()));
    case BlockReason::over_edge:
      return fmt::format(
          "the robot would leave the map: the edge is {} away, the robot's radius is {} (--outside "
          "free lets it hang over)",
          coordinates_.length(space_.clearance(place.cell)),
          coordinates_.length(space_.radius_in_cells()));
    case BlockReason::outside:
      break;
  }
  return std::string(describe(reason));
}

std::string Explainer::blocked_end(const Place& place, const Place& other) const {
  std::string text = blocked(place);
  if (!space_.passable(other.cell)) text += ". Also, " + blocked(other);
  return text + ". " + nearest(place, other);
}

std::string Explainer::nearest(const Place& place, const Place& other) const {
  const bool other_is_free = space_.passable(other.cell);
  const auto cell = nearest_free(space_, place.cell, other.cell, moves_);
  if (!cell) return "No cell of the map is free for this robot";
  const double away = distance(centre_of(*cell), centre_of(place.cell));
  const std::string connected = other_is_free ? " that is connected to the " + other.name : "";
  return fmt::format("The nearest free cell{} is {}, {} away: --nearest plans {} that cell",
                     connected, coordinates_.text(*cell), coordinates_.length(away),
                     place.name == "start" ? "from" : "to");
}

std::string Explainer::unreachable(const Ends& ends) const {
  const NoPath why = explain_no_path(space_, ends.start.cell, ends.goal.cell, moves_);
  std::string text = fmt::format(
      "no path joins start {} and goal {}: the start's region has {}, the goal's has {}. ",
      ends.start.text, ends.goal.text, coordinates_.area(why.start_component),
      coordinates_.area(why.goal_component));
  if (why.ways.empty()) return text + "Obstacles part the two, whatever the robot's size";
  text += "What would make one: ";
  for (std::size_t i = 0; i < why.ways.size(); ++i) {
    text += (i == 0 ? "" : "; or ") + change(why.ways[i]);
  }
  return text + ". `wend explain` shows where";
}

std::string Explainer::change(const Way& way) const {
  std::vector<std::string> changes;
  if (way.unknown_free) changes.emplace_back("unknown cells taken as free (--unknown free)");
  if (way.squeeze) {
    changes.emplace_back(
        "squeezing between obstacles that touch with their corners (--connectivity 8 "
        "--corner-rule both)");
  }
  if (way.smaller_robot) {
    changes.push_back(fmt::format("a radius of at most {0} (--robot-radius {1})",
                                  coordinates_.length(way.widest.radius),
                                  coordinates_.radius_argument(way.widest.radius)));
  }
  return fmt::format("{}", fmt::join(changes, " and "));
}

std::string Explainer::width(const WidestPath& widest) const {
  if (std::isinf(widest.radius)) return "of any size: no obstacle is in the way";
  return fmt::format("with a radius of up to {}, narrowest at {}",
                     coordinates_.length(widest.radius), coordinates_.text(widest.narrowest));
}

bool is_limit(Status status) {
  return status == Status::expansion_limit || status == Status::time_limit ||
         status == Status::step_limit || status == Status::cancelled;
}

std::string explain_limit(Status status, const Limits& limits, const SearchMetrics& metrics) {
  switch (status) {
    case Status::expansion_limit:
      return fmt::format("gave up after {} expansions (--limit-expansions {})", metrics.expanded,
                         limits.expansions);
    case Status::time_limit:
      return fmt::format("gave up after {:g} s and {} expansions (--limit-time {:g})",
                         limits.seconds, metrics.expanded, limits.seconds);
    case Status::cancelled:
      return fmt::format("cancelled after {} expansions", metrics.expanded);
    case Status::step_limit:
      return fmt::format("the walk used up its {} steps (--max-steps)", metrics.expanded - 1);
    default:
      return std::string(describe(status));
  }
}

}  // namespace wend::cli
