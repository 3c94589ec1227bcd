#include "cli/output/explainer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend::cli {
namespace {

/// Adds the cells that the robot can reach from any of `ends`.
void mark_components(Scene& scene, CellRole role, std::span<const Cell> ends, GridMoves moves) {
  for (const Cell end : ends) {
    if (scene.space.passable(end)) {
      scene.marked.push_back({role, component_of(scene.space, end, moves)});
    }
  }
}

/// If the robot cannot stand at an end, marks the nearest cell where it can.
void mark_nearest_free(Scene& scene, Cell end, Cell other, GridMoves moves) {
  if (!scene.space.contains(end) || scene.space.passable(end)) return;
  if (const auto cell = nearest_free(scene.space, end, other, moves)) {
    scene.nearest_free.push_back(*cell);
  }
}

/// Draws the way that needs the fewest changes, and the place where it is too narrow now.
void add_way(Scene& scene, const Way& way, const Coordinates& coordinates) {
  const WidestPath& widest = way.widest;
  if (way.changes() == 0) {
    scene.path = widest.path;
    scene.narrowest = widest.narrowest;
    return;
  }
  scene.lines.push_back({LineRole::possible, widest.path.points(), describe(way, coordinates)});
  if (way.smaller_robot || way.squeeze) scene.narrowest = widest.narrowest;
}

/// Does way `a` need fewer changes than `b`, or as many and allow a larger robot?
bool is_easier(const Way& a, const Way& b) {
  if (a.changes() != b.changes()) return a.changes() < b.changes();
  return a.widest.radius > b.widest.radius;
}

/// The easiest way to any of the goals.
std::optional<Way> easiest_way(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                               GridMoves moves) {
  std::optional<Way> easiest;
  if (!space.contains(start)) return easiest;
  for (const Cell goal : goals) {
    if (!space.contains(goal)) continue;
    const NoPath why = explain_no_path(space, start, goal, moves);
    if (why.ways.empty()) continue;
    if (!easiest || is_easier(why.ways.front(), *easiest)) easiest = why.ways.front();
  }
  return easiest;
}

/// The scene without the way.
Scene components_scene(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                       GridMoves moves) {
  Scene scene{.space = space};
  scene.start = centre_of(start);
  for (const Cell goal : goals) scene.goals.emplace_back(centre_of(goal));
  mark_components(scene, CellRole::goal_component, goals, moves);
  mark_components(scene, CellRole::start_component, {&start, 1}, moves);
  mark_nearest_free(scene, start, goals.front(), moves);
  for (const Cell goal : goals) mark_nearest_free(scene, goal, start, moves);
  return scene;
}

}  // namespace

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
  return fmt::format("the {} {} is outside the map, which covers {}", place.name, place.text,
                     coordinates_.extent());
}

std::string Explainer::blocked(const Place& place) const {
  const auto reason = space_.why_blocked(place.cell);
  if (!reason) return {};
  if (*reason == BlockReason::outside) return outside(place);
  return fmt::format("the {} {} is blocked: {}", place.name, place.text, why(place, *reason));
}

/// Planners on cells know no headings and take a polygon for the disc around it.
std::string_view Explainer::radius_name() const {
  return space_.outline() ? "the radius of the disc around the robot's footprint"
                          : "the robot's radius";
}

std::string Explainer::why(const Place& place, BlockReason reason) const {
  switch (reason) {
    case BlockReason::obstacle:
      return "the cell is an obstacle";
    case BlockReason::unknown:
      return "the cell is unknown (--unknown free makes unknown cells free)";
    case BlockReason::too_close:
      return fmt::format("the nearest obstacle is {} away, {} is {}",
                         coordinates_.length(space_.clearance(place.cell)), radius_name(),
                         coordinates_.length(space_.radius_in_cells()));
    case BlockReason::over_edge:
      return fmt::format(
          "the robot would extend beyond the map: the edge is {} away, {} is {} (--outside free "
          "allows it)",
          coordinates_.length(space_.clearance(place.cell)), radius_name(),
          coordinates_.length(space_.radius_in_cells()));
    case BlockReason::outside:
    case BlockReason::overlaps:
    case BlockReason::leaves:
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
  if (!cell) return "The map has no free cell for this robot";
  const double away = distance(centre_of(*cell), centre_of(place.cell));
  const std::string connected = other_is_free ? " that is connected to the " + other.name : "";
  return fmt::format("The nearest free cell{} is {}, {} away: --nearest plans {} that cell",
                     connected, coordinates_.text(*cell), coordinates_.length(away),
                     place.name == "start" ? "from" : "to");
}

std::string Explainer::unreachable(const Ends& ends) const {
  const NoPath why = explain_no_path(space_, ends.start.cell, ends.goal.cell, moves_);
  std::string text = fmt::format(
      "there is no path from start {} to goal {}: the start's connected component has {}, the "
      "goal's has {}. ",
      ends.start.text, ends.goal.text, coordinates_.area(why.start_component),
      coordinates_.area(why.goal_component));
  if (why.ways.empty()) return text + "Obstacles separate the two, even for a robot with radius 0";
  text += "A path exists with ";
  for (std::size_t i = 0; i < why.ways.size(); ++i) {
    text += (i == 0 ? "" : "; or ") + change(why.ways[i]);
  }
  return text + ". `wend explain` shows where";
}

std::string Explainer::change(const Way& way) const {
  std::vector<std::string> changes;
  if (way.unknown_free) changes.emplace_back("unknown cells free (--unknown free)");
  if (way.squeeze) {
    changes.emplace_back(
        "moves between obstacles that touch at a corner (--connectivity 8 --corner-rule both)");
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
      return fmt::format("stopped after {} expansions (--limit-expansions {})", metrics.expanded,
                         limits.expansions);
    case Status::time_limit:
      return fmt::format("stopped after {:g} s and {} expansions (--limit-time {:g})",
                         limits.seconds, metrics.expanded, limits.seconds);
    case Status::cancelled:
      return fmt::format("cancelled after {} expansions", metrics.expanded);
    case Status::step_limit:
      return fmt::format("the walk ended after {} steps (--max-steps)", metrics.expanded - 1);
    default:
      return std::string(describe(status));
  }
}

std::optional<Cell> nearest_free(const FreeSpace& space, Cell cell, Cell other, GridMoves moves) {
  if (!space.passable(other)) return nearest_passable(space, cell);
  return nearest_passable(space, cell, other, moves.adjacency());
}

std::string describe(const Way& way, const Coordinates& coordinates) {
  std::string text = "path";
  if (way.smaller_robot) {
    text += fmt::format(" for a robot of {}", coordinates.length(way.widest.radius));
  }
  if (way.unknown_free) text += " through unknown cells";
  if (way.squeeze) {
    text += way.unknown_free ? " and between touching obstacles" : " between touching obstacles";
  }
  return text;
}

Scene no_path_scene(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                    const Coordinates& coordinates, const NoPath& why) {
  Scene scene = components_scene(space, start, {&goal, 1}, moves);
  if (!why.ways.empty()) add_way(scene, why.ways.front(), coordinates);
  return scene;
}

Scene no_path_scene(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                    GridMoves moves, const Coordinates& coordinates) {
  Scene scene = components_scene(space, start, goals, moves);
  if (const auto way = easiest_way(space, start, goals, moves)) add_way(scene, *way, coordinates);
  return scene;
}

}  // namespace wend::cli
