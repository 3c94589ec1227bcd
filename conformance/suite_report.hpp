#pragma once

// What the suite found out about a planner, for people and for programs.

#include <string>
#include <vector>

#include "conformance/examination.hpp"

namespace wend::test {

struct SuiteReport {
  std::string planner;   // as typed: "astar:weight=2"
  std::string declared;  // its guarantee
  std::vector<CheckReport> checks;

  bool passed() const;
};

/// The line of a check, and the violation below it if there is one. `command` tests this planner: "wend test-planner
/// astar".
std::string check_text(const CheckReport& check, const std::string& command);

/// "astar keeps to its guarantee: 9 checks passed", or which checks failed.
std::string summary_text(const SuiteReport& report);

/// One line of JSON, with a line feed.
std::string suite_json(const SuiteReport& report);

}  // namespace wend::test
