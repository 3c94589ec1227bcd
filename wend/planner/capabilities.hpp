#pragma once

// Capabilities: what a planner plans for, and what can be done with it. Front ends and the conformance suite
// read these facts; they do not ask which planner it is.

#include "wend/robot/motion_primitives.hpp"

namespace wend {

/// Facts about a planner. Those that are false by default hold for planners from cell to cell.
struct Capabilities {
  bool headings = false;  // a state has a heading: starts, goals and paths are poses, else cells
  Vertices vertices = Vertices::centres;  // where its states lie
  bool primitives = false;                // moves by the robot's motion primitives, if it has any
  bool any_angle = false;  // its paths are cells joined by lines, not steps between neighbours
  bool jumps = false;      // expands only some cells of its paths, if any
  bool leaps = false;      // the same on maps with costs, where it may also expand a cell again
  bool terrain = false;    // takes terrain costs into account
  bool can_step = false;   // Planner::begin and step work
  bool learns = false;     // later searches may expand fewer states; their paths are the same
  bool resumes =
      false;  // a search goes on from the last one: it may find another path of equal cost
  /// Planner::anytime() with every option. It may expand a state again.
  bool anytime = false;
};

/// Does a planner expand only some cells of its paths, on a map where every cell costs the same or not?
constexpr bool jumps_on(bool uniform_terrain, const Capabilities& planner) {
  return planner.jumps || (planner.leaps && !uniform_terrain);
}

/// Do two planners have states of the same kind, so that they answer the same queries?
constexpr bool same_states(const Capabilities& a, const Capabilities& b) {
  return a.headings == b.headings && a.vertices == b.vertices;
}

}  // namespace wend
