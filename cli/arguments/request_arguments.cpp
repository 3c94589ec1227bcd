#include "cli/arguments/request_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <span>
#include <string>

#include "cli/arguments/flags.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

constexpr std::array<std::string_view, 2> kMostUsed{"nearest", "time_limit"};
constexpr std::array<std::string_view, 2> kLimits{"expansions", "time_limit"};
constexpr std::string_view kLength = "m";

bool is_among(const RequestField& field, std::span<const std::string_view> names) {
  return std::ranges::find(names, field.info.name) != names.end();
}

std::string help_of(const RequestField& field) {
  std::string text = field.info.help;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (field.unit == kLength) text += " (units as --robot-radius)";
  return wrapped(text);
}

double number_of(const RequestField& field, const std::string& flag, const std::string& text) {
  constexpr double kLargest = 1e9;
  double number = 0;
  if (field.info.kind == OptionKind::integer) {
    const auto whole = parse_integer<std::uint64_t>(text);
    if (!whole) refuse_value(flag, quote(text) + " is not a whole number of at least 0");
    return static_cast<double>(*whole);
  }
  const std::string wrong =
      parse_in_range(text, number, field.info.least, std::min(field.info.greatest, kLargest),
                     field.unit == kLength ? kMapUnit : field.unit);
  if (!wrong.empty()) refuse_value(flag, wrong);
  return number;
}

}  // namespace

void RequestArguments::add_to(Parser& app, const std::vector<std::string_view>& fields) {
  for (const std::string_view name : fields) add(app, *request_field(name));
}

void RequestArguments::add_limits_to(Parser& app) { add_to(app, {kLimits.begin(), kLimits.end()}); }

void RequestArguments::add_others_to(Parser& app, const std::vector<std::string_view>& fields) {
  for (const RequestField& field : request_fields()) {
    const bool has_flag = !field.flag.empty() && !is_among(field, kLimits);
    if (has_flag && !is_among(field, fields)) add(app, field);
  }
}

void RequestArguments::add(Parser& app, const RequestField& field) {
  const std::string flag = "--" + field.flag;
  if (field.info.kind == OptionKind::flag) {
    app.add_flag(
        flag, [this, &field](std::int64_t) { typed_.emplace_back(&field, 1); }, help_of(field));
  } else {
    const auto take = [this, &field, flag](const std::string& text) {
      typed_.emplace_back(&field, number_of(field, flag, text));
    };
    app.add_option(flag, take, help_of(field))
        .type_name(field.info.kind == OptionKind::integer ? "N" : "NUMBER");
  }
  if (!is_among(field, kMostUsed)) app.further({flag});
}

void RequestArguments::check(const Parser& command) const {
  if (!command.given("--nearest")) {
    refuse_idle(command, {"--nearest-limit"}, "it needs --nearest");
  }
}

void RequestArguments::put(PlanRequest& request, const Coordinates& coordinates) const {
  for (const auto& [field, value] : typed_) {
    field->put(request, field->unit == kLength ? coordinates.in_metres(value) : value,
               coordinates.frame().resolution);
  }
}

void RequestArguments::put(Limits& limits) const {
  PlanRequest request;
  for (const auto& [field, value] : typed_) field->put(request, value, 1);
  limits = request.limits;
}

Leeway RequestArguments::leeway(const Coordinates& coordinates) const {
  PlanRequest request;
  put(request, coordinates);
  return request.leeway();
}

}  // namespace wend::cli
