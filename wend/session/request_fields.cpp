#include "wend/session/request_fields.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace wend {
namespace {

using Request = PlanRequest;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
constexpr double kLongest = 1e9;

template <auto kMember>
void put(Request& request, double value, double /*resolution*/) {
  request.*kMember = static_cast<std::remove_reference_t<decltype(request.*kMember)>>(value);
}

template <auto kMember>
void put_in_goals(Request& request, double value, double /*resolution*/) {
  for (MapGoal& goal : request.goals) goal.*kMember = value;
}

void put_expansions(Request& request, double value, double /*resolution*/) {
  constexpr double kMost = 18446744073709549568.0;  // the greatest double below 2^64
  request.limits.expansions =
      value > kMost ? Limits::kUnlimited : static_cast<std::uint64_t>(value);
}

void put_straighten(Request& request, double value, double /*resolution*/) {
  request.refinement.simplify.reset();
  if (value != 0) request.refinement.simplify = Simplification{};
}

void put_spacing(Request& request, double value, double resolution) {
  request.refinement.spacing.reset();
  if (value > 0) request.refinement.spacing = value / resolution;
}

constexpr auto kFields = std::to_array<RequestField>(
    {{{"goal_tolerance", OptionKind::number, "m", kLongest, 0,
       "how far from its goal a path may end; the goal may then be blocked", "tolerance"},
      &put_in_goals<&MapGoal::tolerance>},
     {{"goal_heading_tolerance", OptionKind::number, "rad", kLongest, 0,
       "how far from its goal's heading a path may end", "heading_tolerance"},
      &put_in_goals<&MapGoal::heading_tolerance>},
     {{"time_limit", OptionKind::number, "s", kInfinity, kInfinity,
       "limit on the time of the whole call, s: making of space and planner, search, reason of a "
       "failure, refinement of the path",
       "seconds"},
      [](Request& request, double value, double) { request.limits.seconds = value; }},
     {{"expansions", OptionKind::integer, "", kInfinity, kInfinity,
       "limit on the number of states to expand"},
      &put_expansions},
     {{"nearest", OptionKind::flag, "", 1, 0,
       "if the start or a goal is blocked, or no path reaches a goal, uses the nearest place that "
       "is connected to the other end"},
      &put<&Request::nearest>},
     {{"nearest_limit", OptionKind::number, "m", kInfinity, kUnset,
       "how far nearest moves an end at most; unset: 1 m, on a map without a resolution any "
       "distance"},
      &put<&Request::nearest_limit>},
     {{"escape", OptionKind::number, "m", kLongest, 0,
       "if the robot does not fit at the start, begins with the shortest way out, at most this "
       "long, along which it never overlaps more of what blocks it; 0: off"},
      &put<&Request::escape>},
     {{"closest", OptionKind::flag, "", 1, 0,
       "if no path reaches a goal (it is walled in, blocked or outside the map), ends at the "
       "reachable place nearest to it, and says what distance remains"},
      &put<&Request::closest>},
     {{"keep", OptionKind::number, "", kInfinity, 0,
       "the share by which another path must be cheaper than what is left of the last one to be "
       "taken when planning again"},
      &put<&Request::keep>},
     {{"explain", OptionKind::flag, "", 1, 1,
       "says at length why there is no path, which may take longer than the search"},
      &put<&Request::explain>},
     {{"from_field", OptionKind::flag, "", 1, 0,
       "answers from the costs to the goals from everywhere, which are kept; for planners from "
       "cell to cell"},
      &put<&Request::from_field>},
     {{"straighten", OptionKind::flag, "", 1, 0,
       "joins the path's cells by lines along which the robot fits"},
      &put_straighten},
     {{"spacing", OptionKind::number, "m", kLongest, 0,
       "distance of the poses along the path; 0: where the planner has them"},
      &put_spacing}});

}  // namespace

std::span<const RequestField> request_fields() { return kFields; }

const RequestField* request_field(std::string_view name) {
  return find_field(request_fields(), name);
}

}  // namespace wend
