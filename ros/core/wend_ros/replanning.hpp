#pragma once

// Replanning: when a change of the map makes the plan to a goal worth making again. Knows no ROS.
//
//   replanning.begin();
//   const auto view = session.view();                          // and the search
//   if (replanning.end(path, view->version)) plan_again();     // a change meanwhile
//   if (replanning.change({version, change}, space, robot)) plan_again();

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/space_change.hpp"

namespace wend_ros {

enum class ReplanOnChange {
  never,   // only another map, goal or parameter is a reason
  ahead,   // a change that spoils the path ahead, and any while there is no path
  always,  // every change: it may have opened a shorter path
};

constexpr std::array<wend::Choice<ReplanOnChange>, 3> choice_names(ReplanOnChange) {
  return {{{"never", ReplanOnChange::never},
           {"ahead", ReplanOnChange::ahead},
           {"always", ReplanOnChange::always}}};
}

/// Does a change touch a path (in grid coordinates, not empty), from the point nearest to the robot on? Without
/// a robot: any of it. O(points * boxes).
bool touches_ahead(const wend::SpaceChange& change, const wend::Path& path,
                   const std::optional<wend::Pose>& robot);

/// Does a change that led to this space spoil a path, from the point nearest to the robot on? It does if it
/// touches the path, and the path is not free any more, or the space has costs, which may have risen.
bool spoils_ahead(const wend::SpaceChange& change, const wend::FreeSpace& space,
                  const wend::Path& path, const std::optional<wend::Pose>& robot);

/// Not for several threads at once.
class Replanning {
 public:
  void set(ReplanOnChange when) { when_ = when; }

  /// A search begins, on the map of now or of a later moment.
  void begin();

  /// It was made on this version of the map, and ended with this path, empty without one. True: a change since
  /// then is a reason to plan again.
  bool end(wend::Path path, std::uint64_t version);

  struct Change {
    std::uint64_t version;  // of the map after it
    wend::SpaceChange cells;
  };

  /// The map has changed, to this space. True: that is a reason to plan again. While a search runs it is not:
  /// end() looks at the change.
  bool change(Change change, const wend::FreeSpace& space, const std::optional<wend::Pose>& robot);

 private:
  ReplanOnChange when_ = ReplanOnChange::ahead;
  wend::Path path_;            // the last one
  std::uint64_t version_ = 0;  // of the map that it was planned on
  bool searching_ = false;
  std::vector<Change> meanwhile_;  // changes while the search runs
};

}  // namespace wend_ros
