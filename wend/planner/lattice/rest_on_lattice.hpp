#pragma once

// What is left of a path of a lattice's steps from a place on it: its poses, its cost as it is now, and the names of
// its moves. The robot may be in the middle of a step. Nothing if a step does not fit any more, or if the path is not
// one of the lattice.

#include <optional>
#include <span>

#include "wend/planner/plan.hpp"
#include "wend/planner/rest_of_path.hpp"
#include "wend/space/lattice/car_lattice.hpp"
#include "wend/space/lattice/motion_lattice.hpp"

namespace wend {

std::optional<Plan> rest_on(const CarLattice& lattice, std::span<const Pose> poses,
                            const PlaceOnDrive& from);
std::optional<Plan> rest_on(const MotionLattice& lattice, std::span<const Pose> poses,
                            const PlaceOnDrive& from);

}  // namespace wend
