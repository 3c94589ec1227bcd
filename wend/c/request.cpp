#include "wend/c/request.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "wend/base/registry.hpp"
#include "wend/c/objects.hpp"
#include "wend/session/request_fields.hpp"

namespace wend::c {
namespace {

using Done = Expected<void, Failure>;

constexpr std::size_t kMostGoals = 1'000'000;
constexpr double kTwoTo64 = 18446744073709551616.0;
constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

wend_request request_defaults() {
  wend_request request{};
  request.struct_size = sizeof(wend_request);
  request.planner = "astar";
  request.expansions = UINT64_MAX;
  request.seconds = std::numeric_limits<double>::infinity();
  request.explain = 1;
  request.nearest_limit = kUnset;
  std::ranges::fill(request.by_name, kUnset);
  return request;
}

/// Where the structure has a field of the list.
struct Member {
  std::string_view name;
  std::variant<double wend_request::*, std::int32_t wend_request::*, std::uint64_t wend_request::*>
      place;
};

constexpr std::array kMembers{Member{"goal_tolerance", &wend_request::tolerance},
                              Member{"goal_heading_tolerance", &wend_request::heading_tolerance},
                              Member{"time_limit", &wend_request::seconds},
                              Member{"expansions", &wend_request::expansions},
                              Member{"nearest", &wend_request::nearest},
                              Member{"nearest_limit", &wend_request::nearest_limit},
                              Member{"escape", &wend_request::escape},
                              Member{"closest", &wend_request::closest},
                              Member{"keep", &wend_request::keep},
                              Member{"explain", &wend_request::explain},
                              Member{"straighten", &wend_request::straighten},
                              Member{"spacing", &wend_request::spacing}};

/// The member of each field of the list; null for one that is kept in `by_name`, at its place in the list.
const std::vector<const Member*>& members() {
  static const std::vector<const Member*> members = [] {
    std::vector<const Member*> found;
    for (const RequestField& field : request_fields()) {
      const auto* const member = std::ranges::find(kMembers, field.info.name, &Member::name);
      found.push_back(member == kMembers.end() ? nullptr : &*member);
    }
    assert(found.size() <= std::size(wend_request{}.by_name));
    return found;
  }();
  return members;
}

/// NaN: unset.
double value_of(const wend_request& request, std::size_t field) {
  const Member* const member = members()[field];
  if (member == nullptr) return request.by_name[field];
  return std::visit(
      [&](auto place) {
        using Value = std::remove_reference_t<decltype(request.*place)>;
        const auto value = static_cast<double>(request.*place);
        return std::is_same_v<Value, const std::int32_t> && value != 0 ? 1 : value;
      },
      member->place);
}

void assign(wend_request& request, std::size_t field, double value) {
  const Member* const member = members()[field];
  if (member == nullptr) {
    request.by_name[field] = value;
  } else if (const auto* count = std::get_if<std::uint64_t wend_request::*>(&member->place)) {
    request.** count = value < kTwoTo64 ? static_cast<std::uint64_t>(value) : UINT64_MAX;
  } else if (const auto* flag = std::get_if<std::int32_t wend_request::*>(&member->place)) {
    request.** flag = static_cast<std::int32_t>(value);
  } else {
    request.*std::get<double wend_request::*>(member->place) = value;
  }
}

/// Puts all fields into a request that has its goals.
Done put_fields(const wend_request& given, double resolution, PlanRequest& asked) {
  const std::span<const RequestField> fields = request_fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const double value = value_of(given, i);
    const bool may_be_unset = members()[i] == nullptr || std::isnan(fields[i].info.default_value);
    if (std::isnan(value) && may_be_unset) continue;
    const auto set = fields[i].set(asked, value, resolution);
    if (!set) return refused("wend_request: " + set.error().message);
  }
  return {};
}

/// The goals of a request; NaN is any heading.
Expected<std::vector<MapGoal>, Failure> goals_of(const wend_request& request) {
  if (request.goals == nullptr || request.goal_count == 0) {
    return refused("wend_request has no goals");
  }
  if (request.goal_count > kMostGoals) {
    return refused("wend_request.goal_count is " + std::to_string(request.goal_count) +
                   ": at most " + std::to_string(kMostGoals) + " expected");
  }
  std::vector<MapGoal> goals;
  goals.reserve(request.goal_count);
  for (std::size_t i = 0; i < request.goal_count; ++i) {
    const auto& [x, y, heading] = request.goals[i];
    if (!std::isfinite(x) || !std::isfinite(y) || std::isinf(heading)) {
      return refused("wend_request.goals[" + std::to_string(i) + "] contains NaN or infinity");
    }
    MapGoal& goal = goals.emplace_back(MapPoint{x, y});
    if (!std::isnan(heading)) goal.heading = heading;
  }
  return goals;
}

Expected<PlannerSpec, Failure> planner_of(const wend_request& request) {
  if (request.planner == nullptr) return refused("wend_request.planner is null");
  auto specs = parse_planner_specs(request.planner);
  if (!specs) return failed(std::move(specs.error()));
  if (specs->size() != 1) {
    return refused("wend_request.planner names " + std::to_string(specs->size()) +
                   " planners: one expected");
  }
  return std::move(specs->front());
}

Error unknown_field(std::string_view name) {
  std::vector<std::string> names;
  for (const RequestField& field : request_fields()) names.emplace_back(field.info.name);
  return {Status::invalid_option, unknown_name("field of a request", name, names), {}};
}

}  // namespace

Expected<PlanRequest, Failure> request_of(const wend_request* given, double resolution) {
  if (given == nullptr) return refused("request is null");
  const auto request = options_of("wend_request", given, request_defaults());
  if (!request) return Unexpected<Failure>(request.error());
  auto goals = goals_of(*request);
  if (!goals) return Unexpected<Failure>(std::move(goals.error()));
  auto planner = planner_of(*request);
  if (!planner) return Unexpected<Failure>(std::move(planner.error()));
  PlanRequest asked{{}, *std::move(goals), *std::move(planner)};
  if (auto put = put_fields(*request, resolution, asked); !put) {
    return Unexpected<Failure>(std::move(put.error()));
  }
  if (request->cancel != nullptr) asked.limits.cancel = &request->cancel->flag;
  return asked;
}

}  // namespace wend::c

using namespace wend::c;

wend_status wend_request_init(wend_request* request, size_t struct_size) {
  return init(request, struct_size, request_defaults());
}

wend_status wend_request_set(wend_request* request, const char* name, double value,
                             wend_error* error) {
  return guarded(error, [&]() -> Done {
    if (request == nullptr) return refused("request is null");
    if (name == nullptr) return refused("name is null");
    if (const auto sized = options_of("wend_request", request, request_defaults()); !sized) {
      return wend::Unexpected<Failure>(sized.error());
    }
    const wend::RequestField* const field = wend::request_field(name);
    if (field == nullptr) return failed(unknown_field(name));
    const wend::FieldInfo& info = field->info;
    const bool unset = std::isnan(value) && std::isnan(info.default_value);
    if (auto fault = info.fault_of(value); fault && !unset) return failed(*std::move(fault));
    assign(*request, static_cast<std::size_t>(field - wend::request_fields().data()), value);
    return {};
  });
}

size_t wend_request_field_count() { return wend::request_fields().size(); }

wend_status wend_request_field_at(size_t index, wend_field_info* info) {
  if (index >= wend::request_fields().size() || info == nullptr) return WEND_INVALID_ARGUMENT;
  const wend::FieldInfo& field = wend::request_fields()[index].info;
  const std::int32_t is_flag = field.kind == wend::OptionKind::flag ? 1 : 0;
  *info = {field.name.data(), field.unit.data(),  field.help.data(), is_flag, 0,
           field.greatest,    field.default_value};
  return WEND_OK;
}
