#pragma once

// Planning: from a request in the map's frame to an answer that ROS clients understand. Knows no
// node; all threads may call it at once.

#include <nav_msgs/Path.h>
#include <wend_ros/PlanResult.h>

#include <atomic>
#include <string>
#include <vector>

#include "wend/geometry/map_pose.hpp"
#include "wend/path/path.hpp"
#include "wend/session/session.hpp"
#include "wend_ros/parameters.hpp"
#include "wend_ros/status_codes.hpp"

namespace wend_ros {

/// In the map's frame: metres, radians.
struct Ask {
  wend::MapPose start;
  std::vector<wend::MapPose> goals;
  bool any_heading = false;  // else the published paths end with the heading of the goal
  std::string planner;       // "astar:weight=2"; empty: the parameter's
  std::string options;       // "heuristic=euclidean"
  double time_limit = 0;     // s; 0: the parameter's
  bool from_field = false;
  bool nearest = false;  // moves blocked ends to the nearest free cells
  double keep = 0;       // above 0: as wend::Session::replan() with PlanRequest::keep
  bool closest = false;  // ends at the reachable place nearest to a goal that no path reaches
  bool explain = true;   // why there is no path, at length, which may take longer than the search
};

struct Watch {
  const std::atomic<bool>* cancel = nullptr;
  wend::SearchObserver* observer = nullptr;
  wend::OnSolution on_solution = {};
};

/// A failure as an answer.
PlanResult refusal(StatusCode code, std::string reason);

/// The robot of the parameters.
wend::FreeSpaceOptions robot_of(const Parameters& parameters);

/// A session that measures CPU time and explains itself in the names of the parameters.
wend::SessionOptions session_options();

/// What comes of a request.
struct Answer {
  PlanResult result;
  wend::Path path = {};     // as planned, in grid coordinates; empty without one
  wend::Path driven = {};   // the same as it is published to be driven: smoothed
  nav_msgs::Path way = {};  // the same with poses on its arcs, for followers and rviz
};

/// Plans on a view of the session, and refines and times the path as the parameters say.
Answer answer(wend::Session& session, const wend::Session::View& view, const Parameters& parameters,
              const Ask& ask, const Watch& watch = {});

}  // namespace wend_ros
