#pragma once

// What a check of planners finds: the trials that it ran, and the smallest one in which the planner broke
// its guarantee.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "conformance/trial.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend::test {

/// How a planner broke a guarantee, in a trial that a seed makes again.
struct Violation {
  std::string expected;
  std::string came;
  std::uint64_t seed = 0;
  std::string options;      // of the planner: "weight=2"
  std::string trial;        // map, robot and options
  std::string query;        // empty if there was none
  std::uint64_t cells = 0;  // of the map
};

struct CheckReport {
  std::string check;           // its name
  std::string guarantee;       // what it holds the planner to
  std::string not_applicable;  // why, if the check is not for this planner
  std::uint64_t maps = 0;
  std::uint64_t queries = 0;
  std::uint64_t found = 0;  // paths among the answers
  std::uint64_t violations = 0;
  std::optional<Violation> smallest;  // on the smallest map

  bool passed() const { return violations == 0; }
};

/// A check of one planner while it runs.
class Examination {
 public:
  /// Without fixed options the trials draw options.
  Examination(const PlannerInfo& info, std::optional<OptionValues> fixed);

  const PlannerInfo& info() const { return info_; }
  const std::optional<OptionValues>& fixed_options() const { return fixed_; }

  /// A random trial for the planner.
  Trial random_trial(std::uint64_t seed) const;

  /// A planner for a trial. Null if it does not plan on such a map and says so as it declares; for any
  /// other refusal too, which is a violation.
  std::unique_ptr<Planner> planner_for(const Trial& trial);

  /// What follows happens on this trial, without a query yet.
  void on(const Trial& trial, std::uint64_t seed);
  /// What follows is about this query. Counts it.
  void ask(const Query& query);
  /// The answer to the last query was a path.
  void count_found() { ++report_.found; }

  void violate(const std::string& expected, const std::string& came);

  const CheckReport& report() const { return report_; }

 private:
  const PlannerInfo& info_;
  std::optional<OptionValues> fixed_;
  CheckReport report_;
  std::optional<Trial> trial_;
  std::optional<Query> query_;
  std::uint64_t seed_ = 0;
};

}  // namespace wend::test
