#pragma once

// IndexPlanner: a planner that answers queries from an index. It checks queries like every planner on
// cells.

#include <functional>
#include <memory>
#include <string>

#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/index/index_engine.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

/// How an index is built and used. Both take the passable cells.
struct IndexMethod {
  std::function<Expected<IndexBytes, Error>(const BitGrid&, const IndexBuilding&)> build;
  /// Checks the index, which is cheap compared with reading it once. The error is index_mismatch.
  std::function<Expected<std::unique_ptr<IndexEngine>, Error>(IndexBytes, const BitGrid&)> open;
};

/// Completes the info of an index planner without options: sets make and index_support, and what all
/// such planners have in common.
PlannerInfo with_index(PlannerInfo info, const IndexMethod& method);

}  // namespace wend
