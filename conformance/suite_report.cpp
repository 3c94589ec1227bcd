#include "conformance/suite_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace wend::test {
namespace {

using Json = nlohmann::ordered_json;

std::string indented(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    lines += fmt::format("    {}\n", line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return lines;
}

/// `command` tests this planner.
std::string violation_text(const Violation& violation, const std::string& command) {
  std::string text =
      fmt::format("    expected: {}\n    came:     {}\n", violation.expected, violation.came);
  if (!violation.query.empty()) text += fmt::format("    query:    {}\n", violation.query);
  if (violation.trial.empty()) return text;
  return text + fmt::format("    again:    {} --seed {} --maps 1\n", command, violation.seed) +
         indented(violation.trial);
}

Json violation_json(const Violation& violation) {
  return {{"expected", violation.expected}, {"came", violation.came},   {"seed", violation.seed},
          {"options", violation.options},   {"query", violation.query}, {"trial", violation.trial},
          {"cells", violation.cells}};
}

std::string outcome_of(const CheckReport& check) {
  if (!check.not_applicable.empty()) return "not applicable";
  return check.passed() ? "passed" : "failed";
}

Json check_json(const CheckReport& check) {
  Json json{{"name", check.check},           {"guarantee", check.guarantee},
            {"outcome", outcome_of(check)},  {"maps", check.maps},
            {"queries", check.queries},      {"paths", check.found},
            {"violations", check.violations}};
  if (!check.not_applicable.empty()) json["why"] = check.not_applicable;
  if (check.smallest) json["smallest"] = violation_json(*check.smallest);
  return json;
}

}  // namespace

bool SuiteReport::passed() const { return std::ranges::all_of(checks, &CheckReport::passed); }

std::string check_text(const CheckReport& check, const std::string& command) {
  const std::string head = fmt::format("{:<14}  {}\n{:16}", check.check, check.guarantee, "");
  if (!check.not_applicable.empty()) {
    return head + fmt::format("not applicable: {}\n", check.not_applicable);
  }
  const std::string work = fmt::format("{} maps, {} queries", check.maps, check.queries);
  if (check.passed()) return head + fmt::format("passed ({})\n", work);
  std::string text = head + fmt::format("FAILED ({}): violations: {}, on the smallest map:\n", work,
                                        check.violations);
  if (check.smallest) text += violation_text(*check.smallest, command);
  return text;
}

std::string summary_text(const SuiteReport& report) {
  const auto failed = std::ranges::count_if(
      report.checks, [](const CheckReport& check) { return !check.passed(); });
  const auto idle = std::ranges::count_if(
      report.checks, [](const CheckReport& check) { return !check.not_applicable.empty(); });
  const auto all = std::ssize(report.checks) - idle;
  return failed == 0 ? fmt::format("{} passed all {} checks\n", report.planner, all)
                     : fmt::format("{} failed {} of {} checks\n", report.planner, failed, all);
}

std::string suite_json(const SuiteReport& report) {
  Json checks = Json::array();
  for (const CheckReport& check : report.checks) checks.push_back(check_json(check));
  const Json json{{"schema", 1},
                  {"planner", report.planner},
                  {"guarantee", report.declared},
                  {"passed", report.passed()},
                  {"checks", std::move(checks)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace wend::test
