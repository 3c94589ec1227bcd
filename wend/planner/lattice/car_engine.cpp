#include "wend/planner/lattice/car_engine.hpp"

#include <algorithm>

#include "wend/planner/lattice/car_priority.hpp"
#include "wend/planner/widening_engine.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {
namespace {

struct CarNames {
  static CornerPose place(const CarState& state) { return state.place; }

  static void tell_place(SearchEvent& event, const auto& space, const CornerPose& place) {
    event.cell = corner_in_cells(space, place);
    event.heading = place.heading;
  }
  static void tell_parent(SearchEvent& event, const auto& space, const CornerPose& place) {
    event.parent = corner_in_cells(space, place);
    event.parent_heading = place.heading;
  }
  static void append(Path& path, const auto& space, const CornerPose& place) {
    path.drive_to(space.lattice().to_grid(place));
  }

 private:
  static Cell corner_in_cells(const auto& space, const CornerPose& place) {
    const int unit = space.lattice().unit();
    return {unit * place.corner.x, unit * place.corner.y};
  }
};

template <class Costs>
std::unique_ptr<CarEngine> make(const CarLattice& lattice, CarHeuristic heuristic, double weight) {
  using Cost = typename Costs::Cost;
  using Engine = SearchEngineOf<CarEngine, CarNames, CarSpace<Costs>, CarFrontier<Cost>,
                                CarPriority<Costs>, DuplicateRule::keep_cheaper>;
  CarSpace<Costs> space(lattice);
  CarPriority<Costs> priority(space, heuristic, weight);
  return std::make_unique<Engine>(std::move(space), std::move(priority));
}

/// Is the lattice so large that even the estimates outgrow 32 bits?
bool too_far(const CarLattice& lattice) {
  constexpr int kFarthest = UINT32_MAX / CarUnits::kTurn / 4;
  return std::max(lattice.columns(), lattice.rows()) > kFarthest;
}

}  // namespace

std::unique_ptr<CarEngine> make_car_engine(const CarLattice& lattice, CarHeuristic heuristic,
                                           double weight) {
  if (weight == 0) heuristic = CarHeuristic::zero;
  const bool whole = has_whole_costs(lattice) && (weight == 1 || weight == 0);
  if (!whole) return make<RealCarCosts>(lattice, heuristic, weight);
  const auto exact = [=] { return make<ExactCarCosts>(lattice, heuristic, weight); };
  if (too_far(lattice)) return exact();
  return std::make_unique<WideningEngine<CarEngine>>(
      [=] { return make<CompactCarCosts>(lattice, heuristic, weight); }, exact);
}

}  // namespace wend
