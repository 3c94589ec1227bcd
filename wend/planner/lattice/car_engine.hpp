#pragma once

// CarEngine: a search on the poses of a car. Places and goals are in lattice coordinates.

#include <memory>

#include "wend/planner/search_engine.hpp"
#include "wend/space/lattice/car_heuristic.hpp"
#include "wend/space/lattice/car_lattice.hpp"

namespace wend {

using CarEngine = SearchEngine<CornerPose, CarGoal>;

/// Without memory for its nodes it is not allocated().
std::unique_ptr<CarEngine> make_car_engine(const CarLattice& lattice, CarHeuristic heuristic,
                                           double weight);

}  // namespace wend
