#pragma once

// Explorer: a simulated robot that drives to a goal over a map that it does not know, or knows as it was.
//
// The robot treats cells that it has not seen as free. Before each step it looks around with a laser scanner
// (append_visible_cells()), puts what it sees on its own map, and plans again if it must. If its shape would touch
// an unseen obstacle, the robot feels that obstacle. It steps from cell to cell, so its planner must do so, too.
//
//   auto explorer = wend::Explorer::make(map, {2, 3}, {40, 60}, {.sensor_range = 30});
//   if (!explorer) return report(explorer.error().message);
//   while (!explorer->step()) draw(explorer->believed(), explorer->ahead());
//   std::cout << explorer->totals().replans << " plans\n";
//
// One thread.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/limits.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/map_edit.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// When an explorer plans again.
enum class ReplanWhen {
  path,       // its path is blocked now, or costs more
  discovery,  // anything is blocked, free or costs otherwise than it believed
};

/// Their names for front ends.
constexpr std::array<Choice<ReplanWhen>, 2> choice_names(ReplanWhen) {
  return {{{"path", ReplanWhen::path}, {"discovery", ReplanWhen::discovery}}};
}

/// The robot, what it knows, and how it plans.
struct ExplorerOptions {
  FreeSpaceOptions robot =
      {};  // `unknown` is about the true map; what the robot does not know is free
  std::optional<GridMap> known = {};   // what it believes at first; nothing: it knows nothing
  double sensor_range = 30;            // of the laser scanner, in cells, finite, at least 1
  PlannerSpec planner{"replanner"};    // from cell to cell
  ReplanWhen when = ReplanWhen::path;  // it plans again
  double keep = 0;     // as PlanRequest::keep: of the path ahead, when it plans again
  Limits limits = {};  // of each search
  Clock clock = {};    // measures planning; null: the steady clock
};

/// What a drive has taken so far.
struct ExplorationTotals {
  std::uint64_t replans = 0;    // plans, the first included
  std::uint64_t seen = 0;       // cells that were not as believed, or unknown
  double planning_seconds = 0;  // of all plans, and of telling the planner of changes
  double worst_seconds = 0;     // of one plan, the first excluded
  double first_seconds = 0;     // of the first plan, and of making the planner
  std::uint64_t expanded = 0;   // states, by all searches
};

class WEND_API Explorer {
 public:
  /// A robot at a cell of the true map, on its way to another. Fails with invalid_option for a planner that does
  /// not step from cell to cell, a range below 1, or a known map of another size; with start_outside,
  /// start_blocked, goal_outside; and as make_free_space() and make_planner() do.
  static Expected<Explorer, Error> make(const GridMap& truth, Cell start, Cell goal,
                                        const ExplorerOptions& options);

  /// Leaves the other one without a robot: it may only be deleted or assigned to.
  Explorer(Explorer&&) noexcept;
  /// The same.
  Explorer& operator=(Explorer&&) noexcept;
  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;
  ~Explorer();

  /// Looks around, plans if it has to, and drives to the next cell. The end, once it is there: found at the
  /// goal, else why the last plan failed.
  std::optional<Status> step();

  /// Why the drive has ended without reaching the goal; words_of() says it.
  const PlanFailure& failure() const;

  /// The map as the robot believes it to be, for this robot. Unknown cells are free.
  const FreeSpace& believed() const;
  /// The true map, for this robot.
  const FreeSpace& truth() const;
  /// Where the robot is.
  Cell cell() const;
  /// Where it goes.
  Cell goal() const;
  /// The cells that it has driven over, in order.
  const std::vector<Cell>& driven() const;
  /// The rest of the path that it believes in, from its cell on; empty before the first plan.
  std::span<const Cell> ahead() const;
  /// What the last step changed on the believed map.
  const MapEdit& last_edit() const;
  /// Did the last step plan?
  bool planned() const;
  /// What it has taken so far.
  const ExplorationTotals& totals() const;
  /// What driving has cost so far, on the true map: cells times terrain.
  double driven_cost() const;

 private:
  struct State;
  explicit Explorer(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace wend
