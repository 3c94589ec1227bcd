#pragma once

// IndexPlanner: a planner that answers queries from an index. It checks queries like every planner on
// cells.

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/indexed/index_answers.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

/// How an index is built and used.
struct IndexMethod {
  std::function<Expected<IndexBytes, Error>(const BitGrid&, const IndexBuilding&)> build;
  /// Checks the index, which is cheap compared with reading it once. The error is index_mismatch.
  std::function<Expected<std::unique_ptr<IndexAnswers>, Error>(IndexBytes, const FreeSpace&)> open;
};

/// For IndexMethod::open, from a function that makes an IndexEngine of the passable cells.
template <class Open>
auto opening_in_steps(Open open) {
  return [open](IndexBytes index,
                const FreeSpace& space) -> Expected<std::unique_ptr<IndexAnswers>, Error> {
    auto engine = open(std::move(index), space.passable());
    if (!engine) return Unexpected<Error>(engine.error());
    return answers_in_steps(*std::move(engine), space.passable());
  };
}

/// Completes the info of an index planner without options: sets make and index_support, and what all
/// such planners have in common.
PlannerInfo with_index(PlannerInfo info, const IndexMethod& method);

}  // namespace wend
