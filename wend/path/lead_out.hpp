#pragma once

// LeadOut: the beginning of a path whose robot does not fit at its start: it leads to a free pose, and along it the
// robot never overlaps more of what blocks it than before (overlap.hpp).
//
//   const auto checked = wend::check_with_lead(path, space, 0.25 / resolution);
//   if (checked.collision) report(wend::describe(checked.collision->kind));

#include <cstddef>
#include <optional>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/path/path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/sweep/overlap.hpp"

namespace wend {

/// The part of a path that leads out.
struct LeadOut {
  double length = 0;  // metres; a turn in place has none
  std::size_t points =
      0;  // of the path's cells, waypoints or poses, that come before the first free one; at least 1
  std::string reason;  // why the robot does not fit at the start: a part of a sentence

  friend bool operator==(const LeadOut&, const LeadOut&) = default;
};

/// A path that goes along `lead` and then along `rest`, which begins where the lead ends. It is made of what `rest` is
/// made of: cells, waypoints or poses.
WEND_API Path joined(const Path& lead, const Path& rest);

/// The parts of such a path: up to its first free point, and from there on. `points` is LeadOut::points.
WEND_API Path lead_of(const Path& path, std::size_t points);
/// The second part.
WEND_API Path behind_lead(const Path& path, std::size_t points);

/// A path, and how far its robot overlaps something at its beginning.
struct LedPath {
  std::optional<PathCollision>
      collision;          // where the overlap grows, the lead is too long, or as first_collision()
  double lead = 0;        // cells: after this length the robot fits, or the path ends
  bool ends_free = true;  // does the robot fit at the path's end, if it does not collide?
};

/// first_collision() for a path (not empty) whose robot may overlap something at the start: no collision is what does
/// not go deeper, up to `most` cells. The overlap is that of the robot as it faces, or, on a path without headings, that
/// of the disc around it, as planners on cells see it. It is looked at every twentieth of a cell.
WEND_API LedPath check_with_lead(const Path& path, const FreeSpace& space, double most,
                                 Adjacency adjacency = Adjacency::edges);

/// Whether a robot that begins to move where it does not fit goes deeper. Off the map it always does.
class WEND_API DepthWatch {
 public:
  /// `rounding` is by how much the overlap may grow: controllers do not keep exactly to lines.
  DepthWatch(const FreeSpace& space, const Pose& start, double rounding = 1e-3);

  /// Does the robot not fit, at the last place that was looked at?
  bool overlaps() const { return !least_.none(); }
  /// Moves on along a segment. False where the robot overlaps more than it did before.
  bool go_along(const Segment& segment);

 private:
  OverlapMeasure measure_;
  double radius_;
  double rounding_;
  Overlap least_;
};

}  // namespace wend
