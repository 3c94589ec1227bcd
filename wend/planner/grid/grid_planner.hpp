#pragma once

// GridPlanner: a planner that moves from cell to cell. It checks queries the same way for all of
// them, runs the GridEngine that it was made with, and says what the answer is worth.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "wend/planner/grid/grid_engine.hpp"
#include "wend/planner/planner.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// The cells that a query names, once it has been found answerable.
struct GridQuery {
  Cell start;
  std::vector<Cell> goals;  // those that can be reached

  /// Takes the cells of a query; a status other than nothing if it cannot be answered.
  std::optional<Status> assign(const FreeSpace& space, Adjacency adjacency, const Query& query);
};

/// Planner::reason() of a planner that moves from cell to cell.
std::string reason_in_cells(const FreeSpace& space, const Query& query, Status status);

class GridPlanner final : public Planner {
 public:
  struct Parts {
    GridMoves moves;
    std::unique_ptr<GridEngine> engine;  // none: the map is of a kind that it cannot plan on
    double bound;                        // what Plan::bound says of every answer
  };

  /// Called again for another FreeSpace.
  using PartsChooser = std::function<Parts(const FreeSpace&)>;

  GridPlanner(FreeSpace space, PartsChooser choose_parts);

  bool allocated() const { return parts_.engine == nullptr || parts_.engine->allocated(); }

 private:
  std::optional<Status> do_check(const Query& query) override;
  Status do_plan(const Query& query, Plan& out) override;
  std::optional<Status> do_begin(const Query& query, Plan& out) override;
  std::optional<Status> do_step(Plan& out) override;
  OpenList do_open_list(std::size_t most) const override;
  std::string do_reason(const Query& query, Status status) const override;
  double do_heuristic(const Pose& pose) const override;
  void do_update(std::span<const Cell> changed) override;

  Status finish(SearchOutcome outcome, Plan& out) const;

  PartsChooser choose_parts_;
  Parts parts_;
  GridQuery cells_;
  Limits limits_;  // of a search that is stepped
};

/// Makes a GridPlanner from options as text: `parts(space, options)` chooses its parts.
template <class Options, class ChooseParts>
PlannerResult make_grid_planner(const FreeSpace& space, const OptionValues& values,
                                ChooseParts parts) {
  const auto options = parse_options<Options>(values);
  if (!options) {
    return Unexpected<PlannerError>({Status::invalid_option, options.error().message()});
  }
  auto planner = std::make_unique<GridPlanner>(
      space, [options = *options, parts](const FreeSpace& other) { return parts(other, options); });
  if (!planner->allocated()) {
    return Unexpected<PlannerError>(
        {Status::memory_limit,
         "no memory for the nodes of " + std::to_string(space.map().size()) + " cells"});
  }
  return planner;
}

}  // namespace wend
