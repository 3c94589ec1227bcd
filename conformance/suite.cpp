#include "conformance/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "conformance/checks.hpp"
#include "wend/base/parse.hpp"

namespace wend::test {
namespace {

std::string always(const PlannerInfo& /*info*/) { return {}; }

std::string on_cells(const PlannerInfo& info) {
  return info.capabilities.headings ? "for planners on cells" : "";
}

std::string with_headings(const PlannerInfo& info) {
  return info.capabilities.headings ? "" : "for planners with headings";
}

std::string anytime_on_cells(const PlannerInfo& info) {
  const bool applies = info.capabilities.anytime && !info.capabilities.headings;
  return applies ? "" : "for anytime planners on cells";
}

std::string plans_only_on_flat_maps(const PlannerInfo& info) {
  return info.capabilities.terrain ? "it plans on terrain" : "";
}

std::uint64_t first_seed(const ConformanceCheck& check, const SuiteOptions& options) {
  return check.one_in == 0 ? 0 : options.seed;
}

void examine(const ConformanceCheck& check, Examination& examination, std::uint64_t seed) {
  try {
    check.examine(examination, seed);
  } catch (const std::exception& error) {
    examination.violate("an answer", fmt::format("an exception: {}", error.what()));
  }
}

std::vector<ConformanceCheck> make_checks() {
  return {
      {"answers", "answers agree with the reference: status, path, cost, bound", 1, 0, on_cells,
       examine_cell_answers, conclude_answers},
      {"nine_cells", "the same on all 512 maps of nine cells", 0, 512, on_cells, examine_nine_cells,
       nullptr},
      {"poses", "paths are free and end where they claim; failures are empty", 1, 0, with_headings,
       examine_pose_answers, conclude_answers},
      {"start_is_goal", "a start that is the goal is a path of one cell", 12, 0, on_cells,
       examine_start_is_goal, nullptr},
      {"anytime", "every reported path has a true bound; costs and bounds never rise", 2, 0,
       anytime_on_cells, examine_anytime, nullptr},
      {"status", "says why a query cannot be answered", 0, 1, always, examine_status, nullptr},
      {"limits", "stops at its limits, with the right status", 0, 1, always, examine_limits,
       nullptr},
      {"terrain", "refuses terrain when updated, as when made", 0, 1, plans_only_on_flat_maps,
       examine_terrain, nullptr},
      {"reused", "a reused planner answers like a new one", 100, 0, always, examine_reused,
       nullptr},
      {"updated", "an updated planner answers like a new one", 150, 0, always, examine_updated,
       nullptr},
      {"edited", "a planner that was told of edits answers like a new one", 6, 0, always,
       examine_edited, nullptr},
      {"cloned", "a clone answers like the original", 6, 0, always, examine_cloned, nullptr},
      {"stepped", "stepping and watching change nothing", 3, 0, always, examine_stepped, nullptr},
      {"mirrored", "an optimal path costs the same on the mirrored map", 3, 0, on_cells,
       examine_mirrored, nullptr},
      {"y_up", "the same grid gives the same search with y up and down", 3, 0, on_cells,
       examine_y_up, nullptr},
  };
}

}  // namespace

const std::vector<ConformanceCheck>& conformance_checks() {
  static const std::vector<ConformanceCheck> checks = make_checks();
  return checks;
}

const ConformanceCheck* find_check(const std::string& name) {
  const auto& checks = conformance_checks();
  const auto found = std::ranges::find(checks, name, &ConformanceCheck::name);
  return found == checks.end() ? nullptr : &*found;
}

std::uint64_t maps_of(const ConformanceCheck& check, const SuiteOptions& options) {
  if (check.one_in == 0) return check.cases;
  return (options.maps + check.one_in - 1) / check.one_in;
}

CheckReport hanging(const ConformanceCheck& check, const SuiteOptions& options,
                    std::uint64_t maps_done, double seconds) {
  CheckReport report;
  report.check = check.name;
  report.guarantee = check.guarantee;
  report.maps = maps_done + 1;
  report.violations = 1;
  const std::uint64_t seed = first_seed(check, options) + maps_done;
  report.smallest = Violation{.expected = "an answer",
                              .came = fmt::format("none for {} s", format_number(seconds)),
                              .seed = seed,
                              .options = {},
                              .trial = fmt::format("the map of seed {}", seed),
                              .query = {}};
  return report;
}

CheckReport run_check(const ConformanceCheck& check, const PlannerInfo& info,
                      const SuiteOptions& options) {
  Examination examination(info, options.options);
  const std::string why_not = check.not_applicable(info);
  bool ended = false;
  if (why_not.empty()) {
    const std::uint64_t maps = maps_of(check, options);
    const std::uint64_t first = first_seed(check, options);
    for (std::uint64_t i = 0; i < maps && !ended; ++i) {
      ended = options.go_on && !options.go_on(i);
      if (!ended) examine(check, examination, first + i);
    }
    if (check.conclude && !ended) check.conclude(examination);
  }
  CheckReport report = examination.report();
  report.check = check.name;
  report.guarantee = check.guarantee;
  report.not_applicable = why_not;
  return report;
}

}  // namespace wend::test
