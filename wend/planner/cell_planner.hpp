#pragma once

// CellPlanner: the base of a planner of your own that moves from cell to cell. It checks the query, keeps
// limits, observer, metrics and the tree of reached cells, and makes the path. You write search() and
// clone().
//
//   class Swirl final : public wend::CellPlanner {
//    public:
//     explicit Swirl(const wend::FreeSpace& space) : CellPlanner(space, kMoves) {}
//
//    private:
//     std::optional<wend::Cell> search(wend::CellSearch& search) override;
//     std::unique_ptr<wend::Planner> do_clone() const override {
//       return std::make_unique<Swirl>(free_space());
//     }
//   };
//
// examples/swirl.cpp is a whole one.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/planner/planner.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

struct GridQuery;  // wend/planner/grid/grid_planner.hpp

/// One search of a CellPlanner: what is asked, and the tree of cells that it has reached.
class WEND_API CellSearch {
 public:
  /// Where the path begins: a passable cell, the root of the tree.
  Cell start() const { return start_; }
  /// Where it may end: one or more cells, which the planner's moves can reach from the start. These are all
  /// cells within the tolerances of the query's goals; overlapping goals give a cell more than once.
  std::span<const Cell> goals() const { return goals_; }
  /// Is the cell a goal? O(goals of the query), however large their tolerances are.
  bool is_goal(Cell cell) const;

  /// Adds a cell of the map to the tree, or gives it another parent, at the cost g from the start. A step
  /// of the planner's moves leads from the parent, which is in the tree, to the cell. O(1).
  void reach(Cell cell, Cell parent, double g);

  /// Is the cell, one of the map, in the tree? O(1).
  bool reached(Cell cell) const { return node(cell).search == number_; }
  /// The cost from the start of a cell in the tree. O(1).
  double cost(Cell cell) const { return node(cell).g; }
  /// The parent of a cell in the tree; nothing for the start. O(1).
  std::optional<Cell> parent(Cell cell) const;

  /// Counts the expansion of a cell in the tree; call it before its successors are reached. False if a
  /// limit ends the search: then search() returns nothing.
  [[nodiscard]] bool expand(Cell cell);

 private:
  friend class CellPlanner;

  struct Node {
    std::uint64_t search = 0;  // the number of the search that reached it; 0: none
    Cell parent;               // of the start: itself
    double g = 0;
  };

  CellSearch(const Query& query, const GridQuery& cells, std::span<const Cell> goals, Node* nodes,
             int width, std::uint64_t number);

  const Node& node(Cell cell) const { return nodes_[index(cell)]; }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }

  Cell start_;
  const GridQuery& cells_;
  std::span<const Cell> goals_;
  Node* nodes_;  // one for each cell, row by row
  int width_;
  std::uint64_t number_;
  LimitCheck limits_;
  SearchObserver* observer_;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;  // unless a limit ended it
};

/// The base class. It needs 24 bytes per cell. Its planners cannot be stepped:
/// Capabilities::can_step is false.
class WEND_API CellPlanner : public Planner {
 public:
  ~CellPlanner() override;

 protected:
  /// `moves` are the steps of its paths. `bound` is Plan::bound of every answer: 1 if the planner is
  /// optimal.
  CellPlanner(FreeSpace space, GridMoves moves, double bound = Plan::kNoBound);

 private:
  /// Searches from the start, which is in the tree. Returns the goal that it reached: the path leads there
  /// through the tree. Nothing if it reached none.
  virtual std::optional<Cell> search(CellSearch& search) = 0;

  std::optional<Status> do_check(const Query& query) final;
  Status do_plan(const Query& query, Plan& out) final;
  std::optional<GridMoves> do_grid_moves() const final { return moves_; }
  std::optional<Plan> do_rest_of(const Path& path, const Query& query,
                                 std::size_t& passed) const final;
  /// Nothing is prepared for a map. Override it if search() keeps something of the map.
  std::optional<Error> do_update(const SpaceChange& change) override;

  bool allocate();

  GridMoves moves_;
  double bound_;
  std::unique_ptr<CellSearch::Node[]> nodes_;  // made by the first search; null: none yet
  std::size_t node_count_ = 0;
  std::uint64_t searches_ = 0;        // on these nodes
  std::unique_ptr<GridQuery> cells_;  // of the query that was checked last
  std::vector<Cell> goals_;           // the same as cells
};

}  // namespace wend
