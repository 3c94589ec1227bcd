#include "wend/session/legs.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/path/joins.hpp"
#include "wend/path/lead_out.hpp"

namespace wend {
namespace {

MapPose as_given(const Pose& pose) { return {pose.x, pose.y, pose.heading}; }

MapGoal as_given(const Goal& goal) {
  return {{goal.point.x, goal.point.y}, goal.heading, goal.tolerance, goal.heading_tolerance};
}

/// "the start", "via 1"
std::string in_sentence(const std::string& name) {
  return name.starts_with("via") ? name : "the " + name;
}

void add(SearchMetrics& all, const SearchMetrics& one) {
  all.expanded += one.expanded;
  all.generated += one.generated;
  all.max_frontier = std::max(all.max_frontier, one.max_frontier);
}

/// What the requests of all legs have in common: they plan one leg, in grid coordinates (so a pose at which a leg ends
/// is, to the last bit, where the next one begins), and what is done with the path is done with the whole.
PlanRequest common_to_legs(PlanRequest request) {
  request.coordinates = MapUnits::cells;
  request.goals.clear();
  request.vias.clear();
  request.closed = false;
  request.refinement = {};
  request.trajectory.reset();
  request.texts = {};
  return request;
}

/// Plans leg after leg, and joins them.
class LegWalk {
 public:
  LegWalk(const PlanRequest& request, const Frame& frame, const LegPlanner& planner,
          const Deadline& deadline)
      : request_(request),
        planner_(planner),
        deadline_(deadline),
        common_(common_to_legs(request)),
        query_(query_of(request, frame)),
        vias_(goals_in_grid(request.vias, request.coordinates, frame)),
        legs_(named_legs(vias_.size(), request.closed)) {}

  Expected<PlanAnswer, RequestFailure> walk() {
    for (now_ = 0; now_ < legs_.size(); ++now_) {
      auto answer = plan(request_of(now_));
      if (!answer) return Unexpected<RequestFailure>(failed(std::move(answer.error())));
      take(*std::move(answer));
    }
    return joined_answer();
  }

 private:
  PlanRequest request_of(std::size_t leg) const;
  Expected<PlanAnswer, RequestFailure> plan(const PlanRequest& request);
  Expected<PlanAnswer, RequestFailure> plan_within(const PlanRequest& request, std::size_t shares);
  RequestFailure failed(RequestFailure failure);
  bool is_fixed(const PlanAnswer& answer) const;
  void take(PlanAnswer answer);
  PlanAnswer joined_answer();

  const PlanRequest& request_;
  const LegPlanner& planner_;
  const Deadline& deadline_;
  const PlanRequest common_;      // to the legs
  const Query query_;             // of the request, in grid coordinates
  const std::vector<Goal> vias_;  // the same
  std::vector<PlanLeg> legs_;     // the first ones are planned
  std::size_t now_ = 0;           // the leg that is being planned
  std::vector<Path> paths_;       // theirs, behind the lead
  Path lead_;
  std::optional<PlanAnswer> whole_;  // all but its path
  SearchMetrics metrics_;            // of all searches
  double seconds_ = 0;               // the same
  bool joins_are_fixed_ = true;      // could no leg end elsewhere, or with another heading?
};

PlanRequest LegWalk::request_of(std::size_t leg) const {
  PlanRequest request = common_;
  const bool last = leg + 1 == legs_.size();
  request.closest = request_.closest && last;
  request.start = as_given(leg == 0 ? query_.start : end_of(paths_.back()));
  const std::vector<std::string>& texts = request_.texts.vias;
  if (leg == 0) {
    request.texts.start = request_.texts.start;
  } else {
    request.escape = 0;
    if (leg <= texts.size()) request.texts.start = texts[leg - 1];
  }
  if (!last) {
    request.goals.push_back(as_given(vias_[leg]));
    if (leg < texts.size()) request.texts.goals = {texts[leg]};
  } else if (request_.closed) {
    const Pose back = beginning_of(paths_.front());
    request.goals.push_back({{back.x, back.y}, back.heading});
    request.texts.goals = {request_.texts.start};
  } else {
    for (const Goal& goal : query_.goals) request.goals.push_back(as_given(goal));
    request.texts.goals = request_.texts.goals;
  }
  return request;
}

/// What an anytime planner needs a first path for may be more than its share: then it gets all that is left.
Expected<PlanAnswer, RequestFailure> LegWalk::plan(const PlanRequest& request) {
  const std::size_t left = legs_.size() - now_;
  auto answer = plan_within(request, planner_.anytime ? left : 1);
  if (answer || !planner_.anytime || left == 1 || !is_limit(answer.error().status) ||
      deadline_.passed()) {
    return answer;
  }
  return plan_within(request, 1);
}

Expected<PlanAnswer, RequestFailure> LegWalk::plan_within(const PlanRequest& request,
                                                          std::size_t shares) {
  Limits limits = deadline_.left();
  limits.seconds /= static_cast<double>(shares);
  std::uint64_t expansions = request_.limits.expansions;
  if (expansions != Limits::kUnlimited) {
    expansions = (expansions - std::min(expansions, metrics_.expanded)) / shares;
  }
  auto answer = planner_.plan(request, shares == 1 ? deadline_ : Deadline(limits), expansions);
  add(metrics_, answer ? answer->plan.metrics : answer.error().metrics);
  seconds_ += answer ? answer->search_seconds : answer.error().search_seconds;
  return answer;
}

RequestFailure LegWalk::failed(RequestFailure failure) {
  PlanLeg& leg = legs_[now_];
  leg.status = failure.status;
  leg.metrics = failure.metrics;
  const std::uint64_t before = metrics_.expanded - leg.metrics.expanded;
  failure.message.insert(0, leg_words(legs_, now_));
  if (failure.status == Status::expansion_limit && before > 0) {
    failure.message += "; the legs before took " + std::to_string(before);
  }
  failure.metrics = metrics_;
  failure.search_seconds = seconds_;
  legs_.resize(now_ + 1);
  failure.legs = std::move(legs_);
  return failure;
}

/// Could the leg end nowhere else, and with no other heading?
bool LegWalk::is_fixed(const PlanAnswer& answer) const {
  if (now_ == vias_.size()) return true;  // no leg begins where the last one ends
  const Goal& via = vias_[now_];
  const bool turned = planner_.headings && (!via.heading || via.heading_tolerance > 0);
  return !turned && via.tolerance == 0 && answer.remaining.value_or(0) == 0;
}

void LegWalk::take(PlanAnswer answer) {
  PlanLeg& leg = legs_[now_];
  Plan& plan = answer.plan;
  if (answer.lead_out) {
    const std::size_t points = answer.lead_out->points;
    lead_ = lead_of(plan.path, points);
    plan.path = behind_lead(plan.path, points);
    const auto named = static_cast<std::ptrdiff_t>(std::min(points, plan.moves.size()));
    plan.moves.erase(plan.moves.begin(), plan.moves.begin() + named);
  }
  leg.cost = plan.cost;
  leg.bound = plan.bound;
  leg.length = plan.path.length() * answer.space.map().frame().resolution;
  leg.goal_shift = answer.goal_shift();
  leg.metrics = plan.metrics;
  leg.first = now_ == 0 ? 0 : legs_[now_ - 1].last;
  leg.last = leg.first + plan.path.size() - 1;
  joins_are_fixed_ = joins_are_fixed_ && is_fixed(answer);
  paths_.push_back(std::move(plan.path));
  for (std::string& note : answer.notes) note.insert(0, leg_words(legs_, now_));
  if (!whole_) {
    whole_ = std::move(answer);
    return;
  }
  PlanAnswer& all = *whole_;
  all.plan.cost += plan.cost;
  all.plan.bound = std::max(all.plan.bound, plan.bound);
  all.plan.moves.insert(all.plan.moves.end(), plan.moves.begin(), plan.moves.end());
  all.plan.goal_snapping_error = plan.goal_snapping_error;
  all.remaining = answer.remaining;
  std::ranges::move(answer.notes, std::back_inserter(all.notes));
}

PlanAnswer LegWalk::joined_answer() {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): there are two legs at least
  PlanAnswer answer = *std::move(whole_);
  answer.plan.path = end_to_end(paths_);
  answer.plan.metrics = metrics_;
  if (!joins_are_fixed_) answer.plan.bound = Plan::kNoBound;
  answer.search_seconds = seconds_;
  answer.legs = std::move(legs_);
  finish_path(answer, request_, lead_, deadline_);
  return answer;
}

}  // namespace

Pose beginning_of(const Path& path) {
  return path.visit(
      [](std::span<const Cell> cells) { return pose_at(cells.front()); },
      [](std::span<const Point> points) { return Pose{points.front().x, points.front().y, 0}; },
      [](const JoinedPoses& drive) { return drive.poses().front(); });
}

Pose end_of(const Path& path) {
  return path.visit(
      [](std::span<const Cell> cells) { return pose_at(cells.back()); },
      [](std::span<const Point> points) { return Pose{points.back().x, points.back().y, 0}; },
      [](const JoinedPoses& drive) { return drive.poses().back(); });
}

std::vector<PlanLeg> named_legs(std::size_t vias, bool closed) {
  std::vector<PlanLeg> legs;
  std::string from = "start";
  for (std::size_t via = 1; via <= vias; ++via) {
    std::string to = "via " + std::to_string(via);
    legs.push_back({.from = std::move(from), .to = to});
    from = std::move(to);
  }
  legs.push_back({.from = std::move(from), .to = closed ? "start" : "goal"});
  return legs;
}

std::string leg_words(std::span<const PlanLeg> legs, std::size_t leg) {
  return "leg " + std::to_string(leg + 1) + " of " + std::to_string(legs.size()) + ", from " +
         in_sentence(legs[leg].from) + " to " + in_sentence(legs[leg].to) + ": ";
}

std::optional<Error> fault_of_legs(const PlanRequest& request) {
  const auto refused = [](Status status, const char* what, const char* where) {
    return Error{status, what, where};
  };
  if (request.closed && request.vias.empty()) {
    return refused(Status::unsupported_query, "a closed path needs a via", "closed");
  }
  if (request.closed && !request.goals.empty()) {
    return refused(Status::unsupported_query, "a closed path ends at its start: it has no goal",
                   "goals");
  }
  if (!request.closed && request.goals.empty()) {
    return refused(Status::unsupported_query, "there is no goal", "goals");
  }
  if (request.on_solution) {
    return refused(Status::unsupported_query,
                   "the paths of an anytime planner are told one by one without vias only: with "
                   "vias there is a search for each leg",
                   "vias");
  }
  return std::nullopt;
}

Expected<PlanAnswer, RequestFailure> plan_legs(const PlanRequest& request, const Frame& frame,
                                               const LegPlanner& planner,
                                               const Deadline& deadline) {
  return LegWalk(request, frame, planner, deadline).walk();
}

}  // namespace wend
