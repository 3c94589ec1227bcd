#include "cli/arguments/leeway_arguments.hpp"

#include "cli/arguments/flags.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kLengths{0, 1e9, kMapUnit};

}  // namespace

void LeewayArguments::add_ends_to(Parser& app) {
  app.add_flag("--nearest", nearest,
               wrapped("If the start or a goal is blocked, or no path leads to the goal, use the "
                       "nearest free cell that is connected to the other end; for planners with "
                       "headings, the nearest free pose with that heading. See --nearest-limit"));
  add_number(app, "--nearest-limit", nearest_limit, kLengths,
             "How far --nearest moves an end at most (default 1 m; on maps in cells any "
             "distance)");
  app.add_flag("--closest", closest,
               wrapped("If no path leads to a goal (it is walled in, blocked or outside the map), "
                       "end at the reachable place that is nearest to it, and say what distance "
                       "remains"));
  app.further({"--nearest-limit", "--closest"});
}

void LeewayArguments::add_escape_to(Parser& app) {
  add_number(app, "--escape", escape, kLengths,
             "If the robot does not fit at the start, begin with the shortest way out, at most "
             "this long, along which it never overlaps more of what blocks it (default 0: off)");
  app.further({"--escape"});
}

void LeewayArguments::check(const Parser& command) const {
  if (!nearest) refuse_idle(command, {"--nearest-limit"}, "it needs --nearest");
}

Leeway LeewayArguments::leeway(const Coordinates& coordinates) const {
  Leeway leeway{coordinates.in_metres(escape), nearest, {}, closest};
  if (nearest_limit) leeway.nearest_limit = coordinates.in_metres(*nearest_limit);
  return leeway;
}

void LeewayArguments::allow(PlanRequest& request, const Coordinates& coordinates) const {
  const Leeway allowed = leeway(coordinates);
  request.escape = allowed.escape;
  request.nearest = allowed.nearest;
  request.nearest_limit = allowed.nearest_limit;
  request.closest = allowed.closest;
}

}  // namespace wend::cli
