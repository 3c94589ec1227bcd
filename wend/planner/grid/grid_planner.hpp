#pragma once

// GridPlanner: a planner that moves from cell to cell. It checks queries the same way for all of
// them, runs the GridEngine that it was made with, a search on the cells of a grid, and says what the
// answer is worth.

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/search_planner.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

class GridEngine : public SearchEngine<Cell, GoalRegion> {
 public:
  /// The point in its cell at which the next search is to begin. Only engines of any angle use it; others begin at
  /// the centre.
  virtual void set_start_point(Point /*start*/) {}
};

struct GridNames {
  static Cell place(const auto& state) { return state.cell; }
  static void tell_place(SearchEvent& event, const auto& /*space*/, Cell cell) {
    event.cell = cell;
  }
  static void tell_parent(SearchEvent& event, const auto& /*space*/, Cell cell) {
    event.parent = cell;
  }
  static void append(Path& path, const auto& /*space*/, Cell cell) { path.append(cell); }
};

template <class Space, class Frontier, class Priority, DuplicateRule kDuplicates,
          class Links = StepLinks>
using GridEngineOf =
    SearchEngineOf<GridEngine, GridNames, Space, Frontier, Priority, kDuplicates, Links>;

/// The cells that a query names, once it has been found answerable.
struct WEND_API GridQuery {
  Cell start;
  Point start_point;              // in that cell
  std::vector<GoalRegion> goals;  // those with cells that can be reached, which bound them

  /// Takes the cells of a query; a status other than nothing if it cannot be answered.
  std::optional<Status> assign(const FreeSpace& space, Adjacency adjacency, const Query& query);
  /// The same for the usual query, one goal without a tolerance in a free cell, but for whether a path can lead there.
  /// False if it is another one.
  bool assign_ends(const FreeSpace& space, const Query& query);
};

class GridPlanner final : public SearchPlanner<GridEngine> {
 public:
  struct Parts {
    GridMoves moves;
    std::shared_ptr<GridEngine> engine;  // none: the map is of a kind that it cannot plan on
    double bound;                        // what Plan::bound says of every answer
    bool any_angle = false;              // its paths are lines, not steps
    /// Makes another engine from what was prepared for this one; null if nothing was.
    std::function<std::unique_ptr<GridEngine>()> another = {};
    /// Makes the parts for the same space after a change from what was prepared for this one, which does
    /// not hold the FreeSpace; null: they are made as for any other space.
    std::function<Parts(const FreeSpace&, const SpaceChange&)> repaired = {};
  };

  /// Called again for another FreeSpace. Parts that are not finished before the deadline are of no use.
  using PartsChooser = std::function<Parts(const FreeSpace&, DeadlineCheck&)>;

  GridPlanner(FreeSpace space, PartsChooser choose_parts,
              DeadlineCheck& stop = DeadlineCheck::never());

  /// Why this planner cannot plan on its FreeSpace, if it cannot.
  std::optional<Error> fault(std::string_view name) const;

 private:
  std::optional<Status> do_check(const Query& query) override;
  Status do_plan(const Query& query, Plan& out) override;
  std::optional<Status> do_begin(const Query& query, Plan& out) override;
  std::optional<Status> unless_connected(const Deadline& deadline) const;
  void begin_search(const Limits& limits, SearchObserver* observer) override;
  void assess(Plan& out) override;
  double do_heuristic(const Pose& pose) const override;
  std::optional<GridMoves> do_grid_moves() const override { return moves_; }
  std::optional<Plan> do_rest_of(const Path& path, const Query& query,
                                 std::size_t& passed) const override;
  std::unique_ptr<Planner> do_clone() const override;
  std::optional<Error> do_update(const SpaceChange& change) override;
  void do_release() override;

  GridPlanner(FreeSpace space, PartsChooser choose_parts, Parts parts);
  void take(Parts parts);

  PartsChooser choose_parts_;
  GridMoves moves_;
  double bound_ = Plan::kNoBound;
  bool any_angle_ = false;
  std::function<std::unique_ptr<GridEngine>()> another_engine_;
  std::function<Parts(const FreeSpace&, const SpaceChange&)> repaired_parts_;
  GridQuery cells_;
  bool uniform_ = true;              // did every cell cost the same when the parts were chosen?
  bool may_be_unreachable_ = false;  // nobody has asked for the components
};

/// A planner that is made from options as text: `parts(space, options)` chooses its parts, or
/// `parts(space, options, stop)` where that takes long.
template <class Options, class ChooseParts>
PlannerInfo grid_planner(PlannerInfo info, const ChooseParts& parts) {
  info.capabilities.can_step = true;
  info.options = option_schema<Options>();
  info.make_within = [parts, name = info.name](const FreeSpace& space, const OptionValues& values,
                                               const Deadline& deadline) -> PlannerResult {
    const auto options = parse_options<Options>(values);
    if (!options) {
      return Unexpected<Error>(options.error());
    }
    const auto choose = [options = *options, parts](const FreeSpace& other, DeadlineCheck& stop) {
      if constexpr (std::is_invocable_v<ChooseParts, const FreeSpace&, const Options&,
                                        DeadlineCheck&>) {
        return parts(other, options, stop);
      } else {
        return parts(other, options);
      }
    };
    DeadlineCheck stop(&deadline);
    auto planner = std::make_unique<GridPlanner>(space, choose, stop);
    if (stop.has_passed()) return failure(deadline.status(), deadline.text());
    if (auto fault = planner->fault(name)) return Unexpected<Error>(*std::move(fault));
    return planner;
  };
  info.make = [make = info.make_within](const FreeSpace& space, const OptionValues& values) {
    return make(space, values, {});
  };
  return info;
}

}  // namespace wend
