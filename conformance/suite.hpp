#pragma once

// The conformance suite: checks that hold a planner to what its PlannerInfo declares. Which of them apply
// follows from the declaration. Planners on cells are compared with a reference that shares no code with
// wend; planners with headings are held to what is true without knowing their motions.
//
//   for (const ConformanceCheck& check : conformance_checks()) {
//     const CheckReport report = run_check(check, info, {.maps = 100});
//     if (!report.passed()) complain(report.smallest->came);
//   }

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/examination.hpp"

namespace wend::test {

struct SuiteOptions {
  std::uint64_t maps = 600;  // of the checks on most maps; others take a share of these
  std::uint64_t seed = 1;    // of the first map
  std::optional<OptionValues> options = {};  // of the planner; unset: random ones
  std::function<bool(std::uint64_t maps_done)> go_on =
      {};  // called before each map; false ends a check
};

struct ConformanceCheck {
  std::string name;       // a word for programs: "reused"
  std::string guarantee;  // what it holds the planner to, in a few words
  std::uint64_t one_in;   // runs on this share of SuiteOptions::maps; 0: once for each of `cases`
  std::uint64_t cases;    // seeds 0 to cases - 1, if they are always the same
  /// Why the check is not for this planner; empty if it is.
  std::function<std::string(const PlannerInfo&)> not_applicable;
  /// Runs the trial of one seed.
  std::function<void(Examination&, std::uint64_t seed)> examine;
  /// What the whole run has to show; may be null.
  std::function<void(Examination&)> conclude;
};

/// All checks, in the order in which they are shown.
const std::vector<ConformanceCheck>& conformance_checks();

/// The check of that name, or null.
const ConformanceCheck* find_check(const std::string& name);

/// How many maps the check runs on with these options.
std::uint64_t maps_of(const ConformanceCheck& check, const SuiteOptions& options);

/// The report of a check that was ended because the planner gave no answer for so long on a map, when it had done others.
CheckReport hanging(const ConformanceCheck& check, const SuiteOptions& options,
                    std::uint64_t maps_done, double seconds);

/// Runs a check on all its maps, also after a violation: the report shows the smallest one. A planner that throws
/// violates it.
CheckReport run_check(const ConformanceCheck& check, const PlannerInfo& info,
                      const SuiteOptions& options);

}  // namespace wend::test
