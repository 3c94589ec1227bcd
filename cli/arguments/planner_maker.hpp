#pragma once

// PlannerMaker: makes planners for one map, on one index where the planner needs one.

#include <optional>

#include "cli/arguments/index_argument.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/map/free_space.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/plan_report.hpp"

namespace wend::cli {

class PlannerMaker {
 public:
  /// `given`: what the planner is to plan on, if an index was given; or what is wrong with it.
  PlannerMaker(PlannerSpec spec, FreeSpace space,
               std::optional<Expected<GivenIndex, std::string>> given);

  /// A planner with scratch memory of its own, and what it and its index took. An index that was not
  /// given is built by the first call.
  PlannerResult make(WorkTimes& times);

  bool built_index() const { return built_.has_value(); }

  const PlannerSpec& spec() const { return spec_; }

 private:
  PlannerSpec spec_;
  FreeSpace space_;
  std::optional<Expected<GivenIndex, std::string>> given_;
  std::optional<IndexBytes> built_;
};

}  // namespace wend::cli
