#include "bench/suites/costs/real_costs.hpp"

#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend::bench {
namespace {

/// The moves of an ExactGrid, at the mean of the multipliers of both cells.
class RealGrid {
 public:
  using State = GridState;
  using Cost = double;
  static constexpr double kUnitsPerCell = 1;

  explicit RealGrid(const FreeSpace& space) : grid_(space) {
    multipliers_.reserve(space.map().size());
    for (const Cell cell : every_cell(space)) multipliers_.push_back(space.terrain(cell));
  }

  StateId state_count() const { return grid_.state_count(); }
  State state(Cell cell) const { return grid_.state(cell); }
  State state(StateId id) const { return grid_.state(id); }
  StateId id(const State& state) const { return grid_.id(state); }
  State parent(const State& state, Move move) const { return grid_.parent(state, move); }
  StateId ahead(const State& from, const State& to) const { return grid_.ahead(from, to); }

  template <class Sink>
  void for_each_successor(const State& state, Move arrival, Sink&& sink) const {
    grid_.for_each_successor(state, arrival, [&](const State& next, Move move, auto) {
      const double mean = (multipliers_[state.number] + multipliers_[next.number]) / 2;
      sink(next, move, (move & 1U) != 0 ? std::numbers::sqrt2 * mean : mean);
    });
  }

 private:
  ExactGrid grid_;
  std::vector<double> multipliers_;
};

/// g alone; no cell is a goal.
struct Everywhere {
  using Key = RealKey<double>;

  Key key(const GridState& /*state*/, double g) const { return {g, g}; }
  bool is_goal(const GridState& /*state*/) const { return false; }
  bool near_overflow(const Key& /*key*/) const { return false; }
};

/// Writes down the cost of every cell as it is expanded.
struct CostWriter {
  Grid<double>& costs;

  void on_expand(const GridState& state, Move, double g) const { costs[state.cell] = g; }
  void on_generate(const GridState&, Move, double) const {}
  void on_relax(const GridState&, Move, double) const {}
};

}  // namespace

std::unique_ptr<GridEngine> real_cost_engine(const FreeSpace& space) {
  using Engine = GridEngineOf<RealGrid, HeapFrontier<RealKey<double>>, RealEstimate<RealGrid>,
                              DuplicateRule::keep_cheaper>;
  return std::make_unique<Engine>(RealGrid(space),
                                  RealEstimate<RealGrid>(HeuristicKind::octile, 0, 1, 1));
}

Grid<double> real_costs_to_go(const FreeSpace& space, Cell goal) {
  using Search = ForwardSearch<RealGrid, HeapFrontier<RealKey<double>>, Everywhere,
                               DuplicateRule::keep_cheaper>;
  Grid<double> costs(space.width(), space.height(), std::numeric_limits<double>::infinity());
  Search search(RealGrid(space), {});
  CostWriter writer{costs};
  const Limits limits;
  search.begin(std::vector{search.space().state(goal)}, limits, writer);
  search.run(writer);
  return costs;
}

}  // namespace wend::bench
