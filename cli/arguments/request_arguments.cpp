#include "cli/arguments/request_arguments.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "cli/arguments/flags.hpp"

namespace wend::cli {
namespace {

constexpr std::array<std::string_view, 2> kMostUsed{"nearest", "time_limit"};
constexpr std::array<std::string_view, 2> kLimits{"expansions", "time_limit"};

bool is_among(const RequestField& field, std::span<const std::string_view> names) {
  return std::ranges::find(names, field.info.name) != names.end();
}

}  // namespace

void RequestArguments::add_to(Parser& app, const std::vector<std::string_view>& fields) {
  for (const std::string_view name : fields) add(app, *request_field(name));
}

void RequestArguments::add_limits_to(Parser& app) { add_to(app, {kLimits.begin(), kLimits.end()}); }

void RequestArguments::add_others_to(Parser& app, const std::vector<std::string_view>& fields) {
  for (const RequestField& field : request_fields()) {
    const bool has_flag = !flag_of(field.info).empty() && !is_among(field, kLimits);
    if (has_flag && !is_among(field, fields)) add(app, field);
  }
}

void RequestArguments::add(Parser& app, const RequestField& field) {
  flags_.add_to(app, field);
  if (!is_among(field, kMostUsed)) app.further({flag_of(field.info)});
}

void RequestArguments::check(const Parser& command) const {
  if (!command.given("--nearest")) {
    refuse_idle(command, {"--nearest-limit"}, "it needs --nearest");
  }
}

void RequestArguments::put(PlanRequest& request, const Coordinates& coordinates) const {
  flags_.put(request, coordinates);
}

void RequestArguments::put(Limits& limits) const {
  PlanRequest request;
  flags_.put(request);
  limits = request.limits;
}

Leeway RequestArguments::leeway(const Coordinates& coordinates) const {
  PlanRequest request;
  put(request, coordinates);
  return request.leeway();
}

}  // namespace wend::cli
