#pragma once

// CellPlanner: the base of a planner of your own that moves from cell to cell. It checks the query, keeps
// limits, observer and metrics, and computes the cost of the path. You write search() and clone().
//
//   class Swirl final : public wend::CellPlanner {
//    public:
//     explicit Swirl(const wend::FreeSpace& space) : CellPlanner(space, kMoves) {}
//
//    private:
//     wend::SearchOutcome search(wend::CellSearch& search, wend::Path& path) override;
//     std::unique_ptr<wend::Planner> do_clone() const override {
//       return std::make_unique<Swirl>(free_space());
//     }
//   };
//
// examples/swirl.cpp is a whole one.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/planner/planner.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// One search of a CellPlanner: what is asked, and where it reports what it does.
class WEND_API CellSearch {
 public:
  /// For CellPlanner.
  CellSearch(Cell start, std::span<const Cell> goals, const Query& query);

  /// Where the path begins: a passable cell.
  Cell start() const { return start_; }
  /// Where it may end: one or more cells, which the planner's moves can reach from the start.
  std::span<const Cell> goals() const { return goals_; }
  /// Is the cell a goal? O(goals).
  bool is_goal(Cell cell) const;

  /// Say that a cell was reached for the first time, at the cost g; the start has no parent.
  void generate(Cell cell, std::optional<Cell> parent, double g);

  /// Say that a cell is expanded: once a cell, before its successors are generated. False if a limit
  /// ends the search: return outcome().
  [[nodiscard]] bool expand(Cell cell, std::optional<Cell> parent, double g);

  /// Why expand() said false.
  SearchOutcome outcome() const { return outcome_; }

  /// The work until now.
  const SearchMetrics& metrics() const { return metrics_; }

 private:
  Cell start_;
  std::span<const Cell> goals_;
  LimitCheck limits_;
  SearchObserver* observer_;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::running;
};

/// The base class. Its planners cannot be stepped: PlannerInfo::can_step is false.
class WEND_API CellPlanner : public Planner {
 protected:
  /// `moves` are the steps of its paths. `bound` is Plan::bound of every answer: 1 if the planner is
  /// optimal.
  CellPlanner(FreeSpace space, GridMoves moves, double bound = Plan::kNoBound);

 private:
  /// Finds a path and writes it, from the start to one of the goals, into `path`, which is empty.
  /// Returns found, outcome() if expand() said false, or exhausted.
  virtual SearchOutcome search(CellSearch& search, Path& path) = 0;

  std::optional<Status> do_check(const Query& query) final;
  Status do_plan(const Query& query, Plan& out) final;
  std::string do_reason(const Query& query, Status status) const final;
  std::optional<GridMoves> do_grid_moves() const final { return moves_; }
  /// Nothing is prepared for a map. Override it if search() keeps something of the map.
  std::optional<Error> do_update(std::span<const Cell> changed) override;

  GridMoves moves_;
  double bound_;
  Cell start_;
  std::vector<Cell> goals_;  // of the query that was checked last
};

}  // namespace wend
