#include "wend/session/request_fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/base/registry.hpp"

namespace wend {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
constexpr double kLongest = 1e9;

using Put = void (*)(PlanRequest& request, double value, double resolution);

template <auto kMember>
void put(PlanRequest& request, double value, double /*resolution*/) {
  request.*kMember = static_cast<std::remove_reference_t<decltype(request.*kMember)>>(value);
}

RequestField number(std::string name, std::string_view unit, double greatest, double default_value,
                    Put put, std::string help, std::vector<std::string> aliases = {}) {
  std::string flag = name;
  std::ranges::replace(flag, '_', '-');
  return {{.name = std::move(name),
           .aliases = std::move(aliases),
           .kind = OptionKind::number,
           .default_value = std::isnan(default_value) ? "" : format_number(default_value),
           .choices = {},
           .least = 0,
           .greatest = greatest,
           .help = std::move(help)},
          unit,
          default_value,
          put,
          std::move(flag)};
}

RequestField flag(std::string name, bool default_value, Put put, std::string help) {
  RequestField field = number(std::move(name), "", 1, default_value ? 1 : 0, put, std::move(help));
  field.info.kind = OptionKind::flag;
  field.info.default_value = option_text::format(default_value);
  return field;
}

/// A field whose flag has another name, or none.
RequestField with_flag(std::string flag, RequestField field) {
  field.flag = std::move(flag);
  return field;
}

RequestField count(std::string name, double default_value, Put put, std::string help) {
  RequestField field = number(std::move(name), "", kInfinity, default_value, put, std::move(help));
  field.info.kind = OptionKind::integer;
  return field;
}

void put_expansions(PlanRequest& request, double value, double /*resolution*/) {
  constexpr double kMost = 18446744073709549568.0;  // the greatest double below 2^64
  request.limits.expansions =
      value > kMost ? Limits::kUnlimited : static_cast<std::uint64_t>(value);
}

void put_tolerance(PlanRequest& request, double value, double /*resolution*/) {
  for (MapGoal& goal : request.goals) goal.tolerance = value;
}

void put_heading_tolerance(PlanRequest& request, double value, double /*resolution*/) {
  for (MapGoal& goal : request.goals) goal.heading_tolerance = value;
}

void put_seconds(PlanRequest& request, double value, double /*resolution*/) {
  request.limits.seconds = value;
}

void put_straighten(PlanRequest& request, double value, double /*resolution*/) {
  request.refinement.simplify.reset();
  if (value != 0) request.refinement.simplify = Simplification{};
}

void put_spacing(PlanRequest& request, double value, double resolution) {
  request.refinement.spacing.reset();
  if (value > 0) request.refinement.spacing = value / resolution;
}

std::vector<RequestField> make_fields() {
  const PlanRequest unset{};
  constexpr const char* kNoFlag = "";
  return {
      // --goal-tolerance has both
      with_flag(kNoFlag, number("goal_tolerance", "m", kLongest, 0, &put_tolerance,
                                "how far from its goal a path may end; the goal may then be "
                                "blocked",
                                {"tolerance"})),
      with_flag(kNoFlag,
                number("goal_heading_tolerance", "rad", kLongest, 0, &put_heading_tolerance,
                       "how far from its goal's heading a path may end", {"heading_tolerance"})),
      with_flag("limit-time",
                number("time_limit", "s", kInfinity, unset.limits.seconds, &put_seconds,
                       "limit on the time of the whole call, s: making of space and planner, "
                       "search, reason of a failure, refinement of the path",
                       {"seconds"})),
      with_flag("limit-expansions", count("expansions", kInfinity, &put_expansions,
                                          "limit on the number of states to expand")),
      flag("nearest", unset.nearest, &put<&PlanRequest::nearest>,
           "if the start or a goal is blocked, or no path reaches a goal, uses the nearest place "
           "that is connected to the other end"),
      number("nearest_limit", "m", kInfinity, kUnset, &put<&PlanRequest::nearest_limit>,
             "how far nearest moves an end at most; unset: 1 m, on a map without a resolution any "
             "distance"),
      number("escape", "m", kLongest, unset.escape, &put<&PlanRequest::escape>,
             "if the robot does not fit at the start, begins with the shortest way out, at most "
             "this long, along which it never overlaps more of what blocks it; 0: off"),
      flag("closest", unset.closest, &put<&PlanRequest::closest>,
           "if no path reaches a goal (it is walled in, blocked or outside the map), ends at the "
           "reachable place nearest to it, and says what distance remains"),
      with_flag(kNoFlag,  // the command line plans once
                number("keep", "", kInfinity, unset.keep, &put<&PlanRequest::keep>,
                       "the share by which another path must be cheaper than what is left of the "
                       "last one to be taken when planning again")),
      with_flag(kNoFlag,  // it always does
                flag("explain", unset.explain, &put<&PlanRequest::explain>,
                     "says at length why there is no path, which may take longer than the "
                     "search")),
      with_flag(kNoFlag,  // `wend field` has the costs
                flag("from_field", unset.from_field, &put<&PlanRequest::from_field>,
                     "answers from the costs to the goals from everywhere, which are kept; for "
                     "planners from cell to cell")),
      with_flag(kNoFlag,  // --simplify
                flag("straighten", false, &put_straighten,
                     "joins the path's cells by lines along which the robot fits")),
      with_flag(kNoFlag,  // --resample
                number("spacing", "m", kLongest, 0, &put_spacing,
                       "distance of the poses along the path; 0: where the planner has them")),
  };
}

}  // namespace

std::optional<Error> RequestField::fault_of(double value, std::string_view called) const {
  const bool whole = info.kind == OptionKind::number || value == std::floor(value);
  if (whole && value >= info.least && value <= info.greatest) return std::nullopt;
  const std::string text = format_number(value);
  const std::string name(called.empty() ? info.name : called);
  if (info.kind == OptionKind::flag) {
    return option_text::option_error(name, "'" + text + "' is neither 0 nor 1");
  }
  return option_text::option_error(name, option_text::fault_of(info, text));
}

Expected<double, Error> RequestField::number_of(std::string_view text) const {
  const std::string fault = option_text::fault_of(info, text);
  if (!fault.empty()) return Unexpected<Error>(option_text::option_error(info.name, fault));
  if (info.kind == OptionKind::flag) return text == "true" ? 1.0 : 0.0;
  return parse_number(text).value_or(default_value);
}

Expected<void, Error> RequestField::set(PlanRequest& request, double value,
                                        double resolution) const {
  if (auto fault = fault_of(value)) return Unexpected<Error>(*std::move(fault));
  put(request, value, resolution);
  return {};
}

std::span<const RequestField> request_fields() {
  static const std::vector<RequestField> fields = make_fields();
  return fields;
}

const RequestField* request_field(std::string_view name) {
  for (const RequestField& field : request_fields()) {
    if (field.info.name == name ||
        std::ranges::find(field.info.aliases, name) != field.info.aliases.end()) {
      return &field;
    }
  }
  return nullptr;
}

Error unknown_request_field(std::string_view name) {
  std::vector<std::string> names;
  for (const RequestField& field : request_fields()) names.push_back(field.info.name);
  return {Status::invalid_option, unknown_name("field of a request", name, names),
          std::string(name)};
}

}  // namespace wend
