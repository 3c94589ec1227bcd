#include "wend_ros/planner_node.hpp"

#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>

#include <chrono>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend_ros/feedback.hpp"
#include "wend_ros/markers.hpp"
#include "wend_ros/option_parameters.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {
namespace {

wend::Unexpected<PlanResult> refused(StatusCode code, std::string reason) {
  return wend::Unexpected<PlanResult>(refusal(code, std::move(reason)));
}

}  // namespace

PlannerNode::PlannerNode(ros::NodeHandle& node, ros::NodeHandle& own, ros::NodeHandle& services)
    : robot_(node, own),
      plan_(node.advertise<nav_msgs::Path>("plan", 1, true)),
      smoothed_(node.advertise<nav_msgs::Path>("plan_smoothed", 1, true)),
      trajectory_(node.advertise<nav_msgs::Path>("trajectory", 1, true)),
      poses_(node.advertise<geometry_msgs::PoseArray>("plan_poses", 1, true)),
      expansion_(node.advertise<nav_msgs::OccupancyGrid>("expansion", 1, true)),
      markers_(node.advertise<visualization_msgs::MarkerArray>("markers", 8, true)) {
  reading_.occupied_from = own.param("occupied_from", reading_.occupied_from);
  reconfigure_ = std::make_unique<Reconfigure>(own, [this](const Parameters& parameters) {
    session_.set_robot(robot_of(parameters));
    wake();
  });
  const double replan_rate = own.param("replan_rate", 0.0);
  if (replan_rate > 0) replan_period_ = 1 / replan_rate;
  take_goal_parameter(own);
  load_map_parameter(own);
  worker_ = std::thread([this] { plan_for_topics(); });
  subscribers_ = {node.subscribe("map", 1, &PlannerNode::take_map, this),
                  node.subscribe("move_base_simple/goal", 1, &PlannerNode::take_goal, this),
                  node.subscribe("initialpose", 1, &PlannerNode::take_start, this),
                  node.subscribe("cancel", 1, &PlannerNode::cancel, this)};
  servers_ = {services.advertiseService("make_plan", &PlannerNode::make_plan, this),
              services.advertiseService("plan_path", &PlannerNode::plan_path, this)};
  action_ = std::make_unique<ActionServer>(
      node, "plan_path_action", [this](const PlanPathGoalConstPtr& goal) { execute(goal); }, false);
  action_->registerPreemptCallback([this] { cancel_action_ = true; });
  action_->start();
}

PlannerNode::~PlannerNode() {
  cancel_action_ = true;
  action_.reset();
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    cancel_topics_ = true;
  }
  asked_.notify_all();
  worker_.join();
}

void PlannerNode::load_map_parameter(ros::NodeHandle& own) {
  const auto file = own.param<std::string>("map", "");
  if (file.empty()) return;
  const auto loaded = wend::load_map(file);
  if (!loaded) {
    ROS_ERROR_STREAM("~map: " << loaded.error().message);
    session_.clear_map(loaded.error().message);
    return;
  }
  take_map(to_message(loaded->map, own.param<std::string>("frame_id", "map")));
}

void PlannerNode::take_map(const nav_msgs::OccupancyGrid& message) {
  MapReading reading = reading_;
  reading.rough = reconfigure_->parameters().flag("rough");
  auto map = map_from(message, reading);
  if (!map) {
    ROS_ERROR_STREAM("/map: " << map.error().message);
    session_.clear_map(map.error().message);
    return;
  }
  ROS_INFO_STREAM("/map: " << map->width() << " x " << map->height() << " cells in the frame '"
                           << message.header.frame_id << "'");
  // rviz draws a box for each; of large maps /map itself has to do.
  constexpr std::size_t kMostBoxes = 250'000;
  if (map->size() <= kMostBoxes) markers_.publish(yard_markers(*map, message.header.frame_id));
  session_.set_map(*std::move(map), message.header.frame_id);
  wake();
}

/// A first goal: ~goalx and ~goaly, numbers or texts of numbers; empty ones are none.
void PlannerNode::take_goal_parameter(ros::NodeHandle& own) {
  const auto number = [&](const char* name) {
    return wend::parse_number(parameter_text(own, name).value_or(""));
  };
  const auto x = number("goalx");
  const auto y = number("goaly");
  if (!x || !y) return;
  goal_.emplace();
  goal_->pose = to_message(wend::MapPose{*x, *y, number("goalyaw").value_or(0)});
}

void PlannerNode::take_goal(const geometry_msgs::PoseStamped& goal) {
  {
    const std::lock_guard lock(mutex_);
    goal_ = goal;
  }
  wake();
}

/// Forgets the topics' goal, and takes the plan to it away.
void PlannerNode::cancel(const std_msgs::Empty&) {
  {
    const std::lock_guard lock(mutex_);
    goal_.reset();
    wanted_ = active_ = false;
    cancel_topics_ = true;
  }
  if (const auto map = session_.view()) publish({}, *map, nullptr);
}

void PlannerNode::take_start(const geometry_msgs::PoseWithCovarianceStamped&) { wake(); }

/// Plans to the topics' goal again, if there is one, and stops the search for it that may be running.
void PlannerNode::wake() {
  {
    const std::lock_guard lock(mutex_);
    if (!goal_) return;
    wanted_ = true;
    cancel_topics_ = true;
  }
  asked_.notify_all();
}

/// Waits for something to plan, or for the next time to plan anew. False: it is time to stop.
bool PlannerNode::wait_for_topics() {
  std::unique_lock lock(mutex_);
  const auto called = [this] { return wanted_ || stopping_; };
  if (active_ && replan_period_ > 0) {
    asked_.wait_for(lock, std::chrono::duration<double>(replan_period_), called);
  } else {
    asked_.wait(lock, called);
  }
  wanted_ = false;
  cancel_topics_ = false;
  return !stopping_;
}

void PlannerNode::plan_for_topics() {
  constexpr double kArrived = 0.3;  // m of path left
  while (wait_for_topics()) {
    PlanRequest request;
    {
      const std::lock_guard lock(mutex_);
      if (!goal_) continue;
      request.goals = {*goal_};
    }
    SearchWatch watch(true);
    const PlanResult result = answer(request, &cancel_topics_, &watch).result;
    const std::lock_guard lock(mutex_);
    active_ = goal_ && result.status == static_cast<std::uint16_t>(StatusCode::found) &&
              result.path_metrics.length > kArrived;
  }
}

wend::Expected<Ask, PlanResult> PlannerNode::ask_of(const PlanRequest& request,
                                                    const wend::Session::View& map) const {
  Ask ask{.start = {},
          .goals = {},
          .any_heading = request.any_heading != 0,
          .planner = request.planner,
          .options = request.options,
          .time_limit = request.time_limit,
          .from_field = request.from_field != 0,
          .nearest = request.nearest != 0};
  if (request.goals.empty()) return refused(StatusCode::invalid_request, "there is no goal");
  const auto start =
      request.use_start ? robot_.in(map.frame_id, request.start) : robot_.in(map.frame_id);
  if (!start) return refused(StatusCode::tf_error, "start: " + start.error());
  ask.start = *start;
  for (const auto& stamped : request.goals) {
    const auto goal = robot_.in(map.frame_id, stamped);
    if (!goal) return refused(StatusCode::tf_error, "goal: " + goal.error());
    ask.goals.push_back(*goal);
  }
  return ask;
}

Answer PlannerNode::answer(const PlanRequest& request, const std::atomic<bool>* cancel,
                           SearchWatch* watch) {
  const auto map = session_.view();
  Answer answer;
  PlanResult& result = answer.result;
  if (!map) {
    result = refusal(code_of(map.error().status), map.error().message);
  } else if (const auto ask = ask_of(request, *map); !ask) {
    result = ask.error();
  } else {
    answer = wend_ros::answer(session_, *map, reconfigure_->parameters(), *ask, {cancel, watch});
  }
  if (result.status == static_cast<std::uint16_t>(StatusCode::found)) {
    ROS_INFO_STREAM("plan: " << result.path.poses.size() << " poses, cost " << result.cost << ", "
                             << result.metrics.expanded << " expanded in "
                             << 1e3 * result.metrics.seconds << " ms of "
                             << wend::thread_time_name());
  } else {
    ROS_WARN_STREAM("no plan, " << result.status << " " << result.status_name << ": "
                                << result.reason);
  }
  if (map) publish(answer, *map, watch);
  return answer;
}

void PlannerNode::publish(const Answer& answer, const wend::Session::View& map,
                          const SearchWatch* watch) {
  const PlanResult& result = answer.result;
  const ros::Time now = ros::Time::now();
  nav_msgs::Path path = answer.way;
  path.header.frame_id = map.frame_id;
  path.header.stamp = now;
  plan_.publish(path);
  geometry_msgs::PoseArray poses = poses_of(result.path);
  poses.header = path.header;
  poses_.publish(poses);
  nav_msgs::Path smoothed = result.smoothed.poses.empty() ? path : result.smoothed;
  smoothed.header = path.header;
  smoothed_.publish(smoothed);
  nav_msgs::Path trajectory = starting_at(now, result.trajectory);
  trajectory.header.frame_id = map.frame_id;
  trajectory_.publish(trajectory);
  markers_.publish(
      path_markers({answer.path, map.space.map().frame(), map.frame_id}, map.space.footprint()));
  if (watch != nullptr && !watch->order().empty()) {
    expansion_.publish(heatmap_of(watch->order(), map.space.map(), map.frame_id));
  }
}

bool PlannerNode::make_plan(nav_msgs::GetPlan::Request& request,
                            nav_msgs::GetPlan::Response& response) {
  PlanRequest ask;
  ask.use_start = !request.start.header.frame_id.empty();
  ask.start = request.start;
  ask.goals = {request.goal};
  response.plan = answer(ask, nullptr, nullptr).way;
  return true;
}

bool PlannerNode::plan_path(PlanPath::Request& request, PlanPath::Response& response) {
  response.result = answer(request.request, nullptr, nullptr).result;
  return true;
}

void PlannerNode::execute(const PlanPathGoalConstPtr& goal) {
  carry_out<PlanPathResult, PlanPathFeedback>(
      *action_, cancel_action_, [&](const std::atomic<bool>* cancel, SearchWatch* watch) {
        return answer(goal->request, cancel, watch).result;
      });
}

}  // namespace wend_ros
