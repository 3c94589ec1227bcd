// Lab::places(): where the robot fits.

#include <array>

#include "lab/wasm/answers.hpp"
#include "lab/wasm/json.hpp"
#include "lab/wasm/lab.hpp"
#include "wend/session/nearest_ends.hpp"

namespace wend::lab {

std::string Lab::places(const Pose& start, const Pose& goal, bool headings) const {
  const auto view = session_.view();
  if (!view) return error_text(view.error());
  std::array<Pose, 2> ends{start, goal};
  if (headings) {
    for (Pose& end : ends) {
      const auto near = session_.nearest(frame_.to_metres(end));
      if (near) end = frame_.to_grid(*near);
    }
  } else {
    const Cell from = cell_at(start.point());
    const Cell to = cell_at(goal.point());
    const NearestEnds near = nearest_ends(view->space, from, to, Adjacency::edges);
    if (near.start != from) ends[0] = pose_at(near.start, start.heading);
    if (near.goal != to) ends[1] = pose_at(near.goal, goal.heading);
  }
  Json json;
  json.object();
  for (const bool is_start : {true, false}) {
    const Pose& end = is_start ? ends[0] : ends[1];
    json.key(is_start ? "start" : "goal");
    json.object().field("x", end.x).field("y", end.y).field("heading", end.heading).end_object();
  }
  return json.end_object().text();
}

}  // namespace wend::lab
