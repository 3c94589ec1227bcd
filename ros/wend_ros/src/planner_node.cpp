#include "wend_ros/planner_node.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <string>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/base/thread_time.hpp"
#include "wend_ros/feedback.hpp"
#include "wend_ros/option_parameters.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {
namespace {

constexpr std::size_t kMostGoals = 1000;

wend::Unexpected<PlanResult> refused(StatusCode code, std::string reason) {
  return wend::Unexpected<PlanResult>(refusal(code, std::move(reason)));
}

/// "plan: 12 poses, cost 11, 40 expanded in 0.1 ms of CPU time, 2 s after the last change of the map".
std::string text_of(const PlanResult& result) {
  std::ostringstream text;
  if (result.status == static_cast<std::uint16_t>(StatusCode::found)) {
    text << "plan: " << result.path.poses.size() << " poses, cost " << result.cost << ", "
         << result.metrics.expanded << " expanded in " << 1e3 * result.metrics.seconds << " ms of "
         << wend::thread_time_name() << ", " << result.since_change
         << " s after the last change of the map";
    if (!result.reason.empty()) text << "; " << result.reason;
  } else {
    text << "no plan, " << result.status << " " << result.status_name << ": " << result.reason;
  }
  return text.str();
}

void tell(const PlanResult& result) {
  if (result.status == static_cast<std::uint16_t>(StatusCode::found)) {
    ROS_INFO_STREAM(text_of(result));
  } else {
    ROS_WARN_STREAM(text_of(result));
  }
}

MapFeed::CostReading costs_of(const Parameters& parameters) {
  return {parameters.flag("rough"), parameters.number("cost_factor")};
}

}  // namespace

PlannerNode::PlannerNode(ros::NodeHandle& node, ros::NodeHandle& own, ros::NodeHandle& services)
    : publisher_(node, own), robot_(node, own) {
  reconfigure_ = std::make_unique<Reconfigure>(
      own, [this](const Parameters& parameters) { take_parameters(parameters); });
  const double replan_rate = own.param("replan_rate", 0.0);
  if (replan_rate > 0) replan_period_ = 1 / replan_rate;
  take_goal_parameter(own);
  feed_ = std::make_unique<MapFeed>(node, own, session_, costs_of(reconfigure_->parameters()),
                                    [this](const MapFeed::Change& change) { take_change(change); });
  constexpr double kShowPeriod = 1;  // s
  show_timer_ =
      node.createWallTimer(ros::WallDuration(kShowPeriod), &PlannerNode::show_edited_map, this);
  constexpr double kAlivePeriod = 0.05;  // s
  alive_timer_ =
      node.createWallTimer(ros::WallDuration(kAlivePeriod), &PlannerNode::tell_alive, this);
  worker_ = std::thread([this] { plan_for_topics(); });
  subscribers_ = {node.subscribe("move_base_simple/goal", 1, &PlannerNode::take_goal, this),
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

void PlannerNode::take_parameters(const Parameters& parameters) {
  session_.set_robot(robot_of(parameters));
  {
    const std::lock_guard lock(mutex_);
    replanning_.set(parameters.replan_on_change());
  }
  if (feed_) feed_->set_costs(costs_of(parameters));
  wake();
}

void PlannerNode::take_change(const MapFeed::Change& change) {
  if (change.whole) {
    publisher_.show_map(*change.whole, change.frame_id);
    wake();
    return;
  }
  edited_ = true;
  const auto& [space, frame_id, version] = *change.edited;
  std::optional<wend::Pose> robot;
  if (const auto pose = robot_.in(frame_id)) robot = space.map().frame().to_grid(*pose);
  {
    const std::lock_guard lock(mutex_);
    const bool matters = goal_ && !arrived_;
    if (!matters || !replanning_.change({version, change.cells}, space, robot)) return;
    wanted_ = std::max(wanted_, Reason::change);
  }
  asked_.notify_all();
}

void PlannerNode::show_edited_map(const ros::WallTimerEvent&) {
  if (!edited_.exchange(false)) return;
  if (const auto map = session_.view()) publisher_.show_map(map->space.map(), map->frame_id);
}

void PlannerNode::tell_alive(const ros::WallTimerEvent&) { publisher_.tell_alive(); }

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
    arrived_ = false;
  }
  wake();
}

/// Forgets the topics' goal, and takes the plan to it away.
void PlannerNode::cancel(const std_msgs::Empty&) {
  {
    const std::lock_guard lock(mutex_);
    goal_.reset();
    wanted_ = Reason::none;
    active_ = lost_ = false;
    cancel_topics_ = true;
  }
  if (const auto map = session_.view()) publisher_.show({}, *map, nullptr);
}

void PlannerNode::take_start(const geometry_msgs::PoseWithCovarianceStamped&) { wake(); }

/// Plans to the topics' goal again, if there is one, and stops the search for it that may be running.
void PlannerNode::wake() {
  {
    const std::lock_guard lock(mutex_);
    if (!goal_) return;
    wanted_ = Reason::asked;
    arrived_ = false;
    cancel_topics_ = true;
  }
  asked_.notify_all();
}

/// After which time to plan anew, s; 0: not by itself. Called with the lock.
double PlannerNode::period() const {
  constexpr double kLostPeriod = 0.2;  // s
  if (lost_) return kLostPeriod;
  return active_ ? replan_period_ : 0;
}

/// Waits for something to plan, or for the next time to plan anew. None: it is time to stop.
PlannerNode::Reason PlannerNode::wait_for_topics() {
  std::unique_lock lock(mutex_);
  const auto called = [this] { return wanted_ != Reason::none || stopping_; };
  if (const double seconds = period(); seconds > 0) {
    asked_.wait_for(lock, std::chrono::duration<double>(seconds), called);
  } else {
    asked_.wait(lock, called);
  }
  cancel_topics_ = false;
  const Reason reason = std::exchange(wanted_, Reason::none);
  if (stopping_) return Reason::none;
  if (reason != Reason::none) return reason;
  return lost_ ? Reason::lost : Reason::time;
}

bool PlannerNode::knows_pose() const {
  const auto map = session_.view();
  return map && robot_.in(map->frame_id);
}

void PlannerNode::plan_for_topics() {
  for (Reason reason = wait_for_topics(); reason != Reason::none; reason = wait_for_topics()) {
    if (reason == Reason::lost && !knows_pose()) continue;
    std::optional<geometry_msgs::PoseStamped> goal;
    {
      const std::lock_guard lock(mutex_);
      goal = goal_;
      if (goal) replanning_.begin();
    }
    if (goal) plan_to(*goal, reason);
  }
}

void PlannerNode::plan_to(const geometry_msgs::PoseStamped& goal, Reason reason) {
  constexpr double kArrived = 0.3;  // m of path left
  PlanRequest request;
  request.goals = {goal};
  request.nearest = reconfigure_->parameters().flag("nearest") ? 1 : 0;
  request.closest = reconfigure_->parameters().flag("closest") ? 1 : 0;
  const Map map = feed_->now();
  // A search that is watched expands cell by cell, and why there is no path takes even longer.
  SearchWatch watch(true);
  const bool quiet = reason < Reason::time;
  Answer answered = answer(map, request,
                           {.cancel = &cancel_topics_,
                            .watch = quiet ? nullptr : &watch,
                            .explain = !quiet,
                            .keep = reconfigure_->parameters().number("keep")});
  const PlanResult& result = answered.result;
  if (map) publisher_.show(answered, map->view, quiet ? nullptr : &watch);
  publisher_.tell(result);
  if (!quiet) tell(result);
  const bool found = result.status == static_cast<std::uint16_t>(StatusCode::found);
  // A goal in an unknown frame fails alike, and is not tried for ever.
  const bool lost = result.status == static_cast<std::uint16_t>(StatusCode::tf_error) &&
                    (reason != Reason::lost || !knows_pose());
  const std::lock_guard lock(mutex_);
  const bool again = replanning_.end(std::move(answered.driven), result.map_version);
  arrived_ = goal_ && found && result.path_metrics.length <= kArrived;
  active_ = goal_ && found && !arrived_;
  lost_ = goal_ && lost;
  if (again && goal_ && !arrived_) wanted_ = std::max(wanted_, Reason::change);
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
          .nearest = request.nearest != 0,
          .closest = request.closest != 0};
  if (request.goals.empty()) return refused(StatusCode::invalid_request, "there is no goal");
  if (request.goals.size() > kMostGoals) {
    return refused(StatusCode::invalid_request, std::to_string(request.goals.size()) +
                                                    " goals, and at most " +
                                                    std::to_string(kMostGoals) + " are allowed");
  }
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
  const Map map = feed_->now();
  Answer answered = answer(map, request, {cancel, watch});
  if (map) publisher_.show_queried(answered, map->view);
  tell(answered.result);
  return answered;
}

Answer PlannerNode::answer(const Map& map, const PlanRequest& request, const Manner& manner) {
  if (!map) return {refusal(code_of(map.error().status), map.error().message)};
  const wend::Session::View& view = map->view;
  auto ask = ask_of(request, view);
  if (ask) {
    ask->explain = manner.explain;
    ask->keep = manner.keep;
  }
  Watch watch{manner.cancel, manner.watch};
  if (manner.watch != nullptr) {
    watch.on_solution = [&](const wend::Plan& plan) { manner.watch->on_solution(plan); };
  }
  Answer answered = ask ? wend_ros::answer(session_, view, reconfigure_->parameters(), *ask, watch)
                        : Answer{ask.error()};
  answered.result.map_version = view.version;
  answered.result.map_stamp = map->stamp;
  const auto age = std::chrono::steady_clock::now() - map->changed;
  answered.result.since_change = std::chrono::duration<double>(age).count();
  return answered;
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
