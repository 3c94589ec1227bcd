#pragma once

// LatticeEngine: a search on a kind of lattice, and how its states are told to observers and written into paths.
// For each kind there are three functions: which engine, what a drive costs, and why there is none.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "wend/planner/failure_causes.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/lattice/lattice_options.hpp"
#include "wend/planner/leaving_motion.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/search_engine.hpp"
#include "wend/search/rounds.hpp"
#include "wend/space/lattice/car_lattice.hpp"
#include "wend/space/lattice/motion_lattice.hpp"

namespace wend {

/// Where a path may end.
template <class PlaceType>
struct LatticeGoal {
  using Place = PlaceType;

  GoalRegion vertices;
  HeadingSet headings;       // those accepted
  bool any_heading = false;  // are these all?

  bool contains(const Place& place) const {
    return headings[static_cast<std::size_t>(place.heading)] && vertices.contains(place.vertex);
  }
};

/// Places and goals are in lattice coordinates.
template <class Lattice>
using LatticeEngine = SearchEngine<typename Lattice::Place, LatticeGoal<typename Lattice::Place>>;

struct LatticeNames {
  static auto place(const auto& state) { return state.place; }

  static void tell_place(SearchEvent& event, const auto& space, const auto& place) {
    event.cell = space.lattice().cell_of(place.vertex);
    event.heading = space.lattice().to_grid(place).heading;
  }
  static void tell_parent(SearchEvent& event, const auto& space, const auto& place) {
    event.parent = space.lattice().cell_of(place.vertex);
    event.parent_heading = space.lattice().to_grid(place).heading;
  }
  static void append(Path& path, const auto& space, const auto& place) {
    path.drive_to(space.lattice().to_grid(place));
  }
};

/// Without memory for its nodes it is not allocated().
std::unique_ptr<LatticeEngine<CarLattice>> make_engine(const CarLattice& lattice,
                                                       CarHeuristic heuristic, double weight);
std::unique_ptr<LatticeEngine<MotionLattice>> make_engine(const MotionLattice& lattice,
                                                          LatticeHeuristic heuristic,
                                                          double weight);

/// The weights of CarOptions or LatticeOptions with anytime().
template <class Options>
AnytimeWeights anytime_weights(const Options& options) {
  return {options.initial_weight, options.weight_step, options.bound()};
}

/// The same for an anytime search.
std::unique_ptr<LatticeEngine<CarLattice>> make_anytime_engine(const CarLattice& lattice,
                                                               CarHeuristic heuristic,
                                                               AnytimeWeights weights);
std::unique_ptr<LatticeEngine<MotionLattice>> make_anytime_engine(const MotionLattice& lattice,
                                                                  LatticeHeuristic heuristic,
                                                                  AnytimeWeights weights);

/// The motions that leave a place and stay on the lattice, whether the robot fits along them or not.
std::vector<LeavingMotion> leaving_motions(const CarLattice& lattice, const CornerPose& place);
std::vector<LeavingMotion> leaving_motions(const MotionLattice& lattice, const LatticePose& place);

/// Sets the cost of a path through these places and the names of its moves. The path has a pose for each place,
/// and may get more between them.
void write_drive(const CarLattice& lattice, std::span<const CornerPose> places, Plan& out);
void write_drive(const MotionLattice& lattice, std::span<const LatticePose> places, Plan& out);

/// Why the robot cannot stand at a place; nothing if it can.
std::optional<FailureCause> why_blocked(const CarLattice& lattice, EndIndex end,
                                        const CornerPose& place);
std::optional<FailureCause> why_blocked(const MotionLattice& lattice, EndIndex end,
                                        const LatticePose& place);

/// Does any motion lead from a place, or to one?
bool can_leave(const CarLattice& lattice, const CornerPose& place);
bool can_leave(const MotionLattice& lattice, const LatticePose& place);
bool can_arrive(const CarLattice& lattice, const CornerPose& place);
bool can_arrive(const MotionLattice& lattice, const LatticePose& place);

}  // namespace wend
