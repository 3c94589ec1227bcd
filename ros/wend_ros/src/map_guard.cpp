#include "wend_ros/map_guard.hpp"

#include "wend_ros/option_parameters.hpp"
#include "wend_ros/parameters.hpp"
#include "wend_ros/planning.hpp"

namespace wend_ros {
namespace {

wend::FreeSpaceOptions robot_from_parameters(const ros::NodeHandle& own) {
  Parameters parameters;
  for (const char* name : {"robot_radius", "footprint", "unknown_free", "outside"}) {
    const auto text = parameter_text(own, name);
    const std::string fault = text ? parameters.set(name, *text) : std::string();
    if (!fault.empty()) ROS_ERROR_STREAM(fault);
  }
  return robot_of(parameters);
}

}  // namespace

MapGuard::MapGuard(ros::NodeHandle& own, const wend::VelocityLimits& limits, double period) {
  const auto options = options_from_parameters<GuardOptions>(own);
  wend::FreeSpaceOptions robot = robot_from_parameters(own);
  path_ = std::make_unique<PathGuard>(limits, period, robot.footprint.inscribed_radius(), options);
  robot.footprint = swept_footprint(robot.footprint, options.path_margin);
  session_.set_robot(robot);
  node_.setCallbackQueue(&queue_);
  constexpr double kCostFactor = 4;
  feed_ = std::make_unique<MapFeed>(node_, own, session_, MapFeed::CostReading{false, kCostFactor},
                                    [](const MapFeed::Change&) {});
  spinner_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  spinner_->start();
}

MapGuard::~MapGuard() { spinner_->stop(); }

}  // namespace wend_ros
