#pragma once

// PlanPublisher: the topics that show maps and plans; docs/ros.md lists them. Plans to the topics' goals are to be
// driven, and followers do that. What services and the action ask for is only shown, by ~queried_plan and its like.

#include <ros/ros.h>
#include <wend_ros/PlannerAlive.h>

#include <string>

#include "wend/map/grid_map.hpp"
#include "wend/session/session.hpp"
#include "wend_ros/planning.hpp"
#include "wend_ros/search_watch.hpp"

namespace wend_ros {

class PlanPublisher {
 public:
  PlanPublisher(ros::NodeHandle& node, ros::NodeHandle& own);

  /// Obstacles and rough cells; of large maps nothing.
  void show_map(const wend::GridMap& map, const std::string& frame_id) const;

  /// A plan to be driven, on the map of a view, or that there is none. `watch`: of a search whose order of expansion
  /// is shown.
  void show(const Answer& answer, const wend::Session::View& map, const SearchWatch* watch) const;

  /// A plan that somebody has asked for, or that there is none.
  void show_queried(const Answer& answer, const wend::Session::View& map) const;

  /// The node lives.
  void tell_alive() const;

  /// The result of a plan that topics have asked for.
  void tell(const PlanResult& result) const { results_.publish(result); }

 private:
  ros::Publisher plan_;
  ros::Publisher smoothed_;
  ros::Publisher trajectory_;
  ros::Publisher poses_;
  ros::Publisher expansion_;
  ros::Publisher markers_;
  ros::Publisher results_;
  ros::Publisher queried_plan_;
  ros::Publisher queried_markers_;
  ros::Publisher alive_;
  PlannerAlive sign_;
};

}  // namespace wend_ros
