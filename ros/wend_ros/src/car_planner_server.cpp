// car_planner_server: the car's planner as the service `plan_car` and the action `plan_car_action`.
// What a request means: msg/CarRequest.msg.

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <wend_ros/PlanCar.h>
#include <wend_ros/PlanCarAction.h>

#include <atomic>

#include "wend_ros/car_planning.hpp"
#include "wend_ros/feedback.hpp"
#include "wend_ros/master_watch.hpp"

namespace {

class CarPlannerServer {
 public:
  explicit CarPlannerServer(ros::NodeHandle& node)
      : service_(node.advertiseService("plan_car", &CarPlannerServer::serve, this)),
        action_(
            node, "plan_car_action",
            [this](const wend_ros::PlanCarGoalConstPtr& goal) { execute(*goal); }, false) {
    action_.registerPreemptCallback([this] { cancel_ = true; });
    action_.start();
  }

 private:
  static wend_ros::CarResult answer(const wend_ros::CarRequest& request,
                                    const wend_ros::Watch& watch) {
    wend_ros::CarResult result = wend_ros::plan_car(request, watch);
    if (result.status == 0) {
      ROS_INFO_STREAM("drive: " << result.moves.size() << " moves, fuel " << result.fuel << ", "
                                << result.metrics.expanded << " expanded");
    } else {
      ROS_WARN_STREAM("no drive, " << result.status << " " << result.status_name << ": "
                                   << result.reason);
    }
    return result;
  }

  bool serve(wend_ros::PlanCar::Request& request, wend_ros::PlanCar::Response& response) {
    response.result = answer(request.request, {});
    return true;
  }

  void execute(const wend_ros::PlanCarGoal& goal) {
    wend_ros::carry_out<wend_ros::PlanCarResult, wend_ros::PlanCarFeedback>(
        action_, cancel_, [&](const std::atomic<bool>* cancel, wend_ros::SearchWatch* watch) {
          return answer(goal.request, {cancel, watch});
        });
  }

  std::atomic<bool> cancel_{false};
  ros::ServiceServer service_;
  actionlib::SimpleActionServer<wend_ros::PlanCarAction> action_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "car_planner_server");
  ros::NodeHandle node;
  CarPlannerServer server(node);
  const wend_ros::MasterWatch watch;
  constexpr int kThreads = 2;
  ros::AsyncSpinner spinner(kThreads);
  spinner.start();
  ROS_INFO("the car's planner is ready");
  ros::waitForShutdown();
  return 0;
}
