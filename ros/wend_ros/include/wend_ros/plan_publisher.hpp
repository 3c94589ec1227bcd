#pragma once

// PlanPublisher: the topics that show maps and plans; docs/ros.md lists them.

#include <ros/ros.h>

#include <string>

#include "wend/map/grid_map.hpp"
#include "wend/session/session.hpp"
#include "wend_ros/planning.hpp"
#include "wend_ros/search_watch.hpp"

namespace wend_ros {

class PlanPublisher {
 public:
  explicit PlanPublisher(ros::NodeHandle& node);

  /// Obstacles and rough cells; of large maps nothing.
  void show_map(const wend::GridMap& map, const std::string& frame_id) const;

  /// An answer on the map of a view, or that there is none. `watch`: of a search whose order of expansion is shown.
  void show(const Answer& answer, const wend::Session::View& map, const SearchWatch* watch) const;

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
};

}  // namespace wend_ros
