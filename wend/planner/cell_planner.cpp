#include "wend/planner/cell_planner.hpp"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/rest_of_path.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {

CellSearch::CellSearch(const Query& query, const GridQuery& cells, std::span<const Cell> goals,
                       Node* nodes, int width, std::uint64_t number)
    : start_(cells.start),
      cells_(cells),
      goals_(goals),
      nodes_(nodes),
      width_(width),
      number_(number),
      observer_(query.observer) {
  limits_.begin(query.limits);
  reach(start_, start_, 0);
}

bool CellSearch::is_goal(Cell cell) const { return any_contains(cells_.goals, cell); }

void CellSearch::reach(Cell cell, Cell parent, double g) {
  const bool again = reached(cell);
  nodes_[index(cell)] = {number_, parent, g};
  if (!again) {
    ++metrics_.generated;
    metrics_.max_frontier = std::max(metrics_.max_frontier, metrics_.generated - metrics_.expanded);
  }
  if (observer_ == nullptr) return;
  const SearchEvent event{cell, this->parent(cell), g, 0, g};
  if (again) {
    observer_->on_relax(event);
  } else {
    observer_->on_generate(event);
  }
}

std::optional<Cell> CellSearch::parent(Cell cell) const {
  if (cell == start_) return std::nullopt;
  return node(cell).parent;
}

bool CellSearch::expand(Cell cell) {
  if (limits_.due(metrics_.expanded)) {
    const SearchOutcome outcome = limits_.look(metrics_.expanded);
    if (outcome != SearchOutcome::running) {
      outcome_ = outcome;
      return false;
    }
  }
  ++metrics_.expanded;
  if (observer_ != nullptr) {
    const double g = cost(cell);
    observer_->on_expand({cell, parent(cell), g, 0, g});
  }
  return true;
}

CellPlanner::CellPlanner(FreeSpace space, GridMoves moves, double bound)
    : Planner(std::move(space)),
      moves_(moves),
      bound_(bound),
      cells_(std::make_unique<GridQuery>()) {}

CellPlanner::~CellPlanner() = default;

std::optional<Status> CellPlanner::do_check(const Query& query) {
  goals_.clear();
  if (const auto refused = cells_->assign(free_space(), moves_.adjacency(), query)) return refused;
  const ConnectedComponents& components = free_space().components();
  for (const GoalRegion& region : cells_->goals) {
    region.for_each([&](Cell cell) {
      if (components.connected(cells_->start, cell, moves_.adjacency())) goals_.push_back(cell);
    });
  }
  return std::nullopt;
}

bool CellPlanner::allocate() {
  const std::size_t cells = free_space().map().size();
  if (nodes_ != nullptr && node_count_ == cells) return true;
  nodes_.reset();  // its memory first
  nodes_.reset(new (std::nothrow) CellSearch::Node[cells]);
  node_count_ = cells;
  searches_ = 0;
  return nodes_ != nullptr;
}

Status CellPlanner::do_plan(const Query& query, Plan& out) {
  if (!allocate()) return Status::memory_limit;
  CellSearch task(query, *cells_, goals_, nodes_.get(), free_space().width(), ++searches_);
  const std::optional<Cell> goal = search(task);
  out.metrics = task.metrics_;
  if (!goal) return status_of(task.outcome_);
  for (std::optional<Cell> cell = goal; cell; cell = task.parent(*cell)) out.path.append(*cell);
  out.path.reverse();
  out.cost = grid_path_cost(free_space(), out.path.cells());
  out.bound = bound_;
  return Status::found;
}

std::optional<Plan> CellPlanner::do_rest_of(const Path& path, const Query& query,
                                            std::size_t& passed) const {
  return rest_of_steps(free_space(), moves_, path.cells(), query, passed);
}

std::optional<Error> CellPlanner::do_update(const SpaceChange& /*change*/) { return std::nullopt; }

}  // namespace wend
