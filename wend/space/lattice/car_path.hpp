#pragma once

// What a drive costs, recomputed from its poses alone, never from the sums of a search.

#include <optional>
#include <span>

#include "wend/space/lattice/car_lattice.hpp"

namespace wend {

/// The move between two poses of a lattice that follow one another; nothing if none joins them.
std::optional<CarMove> move_between(const CornerPose& from, const CornerPose& to);

/// The fuel of a drive in units: the sum over all moves of length times ground, times the factor for
/// reversing. The poses are in lattice coordinates and joined by moves. Equal kinds of moves are
/// counted, so that drives over whole multipliers cost the same to the last bit.
double car_path_cost(const CarLattice& lattice, std::span<const CornerPose> poses);

}  // namespace wend
