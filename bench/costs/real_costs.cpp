#include "bench/costs/real_costs.hpp"

#include <numbers>
#include <utility>
#include <vector>

#include "wend/planner/grid/grid_priorities.hpp"
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

}  // namespace

std::unique_ptr<GridEngine> real_cost_engine(const FreeSpace& space) {
  using Engine = GridEngineOf<RealGrid, HeapFrontier<RealKey<double>>, RealEstimate<RealGrid>,
                              DuplicateRule::keep_cheaper>;
  return std::make_unique<Engine>(RealGrid(space),
                                  RealEstimate<RealGrid>(HeuristicKind::octile, 0, 1, 1));
}

}  // namespace wend::bench
