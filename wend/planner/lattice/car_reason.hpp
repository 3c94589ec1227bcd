#pragma once

// Where and why a car's query fails, in words.

#include <optional>
#include <string>

#include "wend/base/status.hpp"
#include "wend/planner/plan.hpp"
#include "wend/space/lattice/car_lattice.hpp"

namespace wend {

/// The pose of the lattice that a query's pose stands for: the nearest one, of those on the map.
/// Nothing for a pose outside the map; its heading is finite.
std::optional<CornerPose> place_on(const CarLattice& lattice, const Pose& pose);

/// Why a query ends so; empty where there is no more to say than what the status does.
std::string car_reason(const CarLattice& lattice, const Query& query, Status status);

}  // namespace wend
