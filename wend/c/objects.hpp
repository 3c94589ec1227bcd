#pragma once

// What the opaque types of wend.h are.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/cover/plan_coverage.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/obstacles.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/session/session.hpp"
#include "wend/wend.h"

namespace wend::c {

/// What a session says of what blocks its robots; nothing: as the robot has it.
struct Policies {
  std::optional<UnknownPolicy> unknown = {};
  std::optional<OutsidePolicy> outside = {};
};

}  // namespace wend::c

struct wend_map {
  wend::GridMap map;
  std::vector<std::string> notes = {};  // on the file that it was loaded from
};

struct wend_robot {
  wend::FreeSpaceOptions options;
};

struct wend_cancel {
  std::atomic<bool> flag = false;
};

struct wend_session {
  wend_session(const wend::GridMap& first_map, const wend_robot* robot,
               const wend::c::Policies& chosen);

  /// The options of a robot, or of a point for null, in this session.
  wend::FreeSpaceOptions options_of(const wend_robot* robot) const;

  void set_map(const wend::GridMap& next);

  /// Edits the map in place: this object's copy lets go of it meanwhile.
  wend::Expected<void, wend::Error> edit(const wend::MapEdit& edit);

  /// Planners that an exception stopped are of no use any more.
  void drop_planners();

  wend::c::Policies policies;
  wend::Session session;
  std::mutex mutex;                  // guards `map`
  std::optional<wend::GridMap> map;  // nothing if an exception stopped an edit
};

namespace wend::c {

/// Runs work(). If it throws, planners may be left in the middle of something.
template <class Work>
auto or_without_planners(wend_session& session, Work&& work) {
  try {
    return work();
  } catch (...) {
    session.drop_planners();
    throw;
  }
}

}  // namespace wend::c

struct wend_plan {
  /// Takes what a caller can ask for from an answer.
  explicit wend_plan(const wend::PlanAnswer& answer);

  std::vector<wend_pose> poses;
  std::vector<std::int32_t> gears;  // one fewer
  double cost;
  double bound;
  double length;  // metres
  wend::SearchMetrics metrics;
  wend::LeadOut lead_out = {};  // of length 0 without one
  double remaining;             // metres; NaN without an answer
  double start_shift;           // metres
  double goal_shift;            // metres
  bool kept;
  std::vector<wend::PlanLeg> legs;  // `first` and `last` are poses
  wend::FreeSpace space;
  wend::Path path;
  mutable std::once_flag measured;  // guards `measures`
  mutable wend::Expected<wend::PathMetrics, wend::Error> measures;
};

struct wend_coverage {
  /// Takes what a caller can ask for.
  wend_coverage(const wend::Coverage& coverage, const wend::Frame& frame);

  std::vector<wend_pose> poses;
  std::vector<std::uint8_t> cells;
  double share;
  double length;       // metres
  double lower_bound;  // metres
  std::size_t turns;
};

struct wend_field {
  wend::FreeSpace space;
  wend::Session::Field field;
};
