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
#include "wend/map/grid_map.hpp"
#include "wend/map/obstacles.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/session/session.hpp"
#include "wend/wend.h"

struct wend_map {
  wend::GridMap map;
  std::vector<std::string> notes = {};  // on the file that it was loaded from
};

struct wend_robot {
  wend::Robot robot;
};

struct wend_cancel {
  std::atomic<bool> flag = false;
};

struct wend_session {
  wend_session(const wend::GridMap& first_map, const wend::Robot& robot,
               const wend::ObstacleOptions& chosen);

  /// The options of a robot on this session's obstacles.
  wend::FreeSpaceOptions options_of(const wend::Robot& robot) const;

  void set_map(const wend::GridMap& next);

  /// Edits the map in place: this object's copy lets go of it meanwhile.
  wend::Expected<void, wend::Error> edit(const wend::MapEdit& edit);

  /// Planners that an exception stopped are of no use any more.
  void drop_planners();

  wend::ObstacleOptions obstacles;
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
  wend::FreeSpace space;
  wend::Path path;
  mutable std::once_flag measured;  // guards `measures`
  mutable wend::Expected<wend::PathMetrics, wend::Error> measures;
};

struct wend_field {
  wend::FreeSpace space;
  wend::Session::Field field;
};
