#pragma once

// A trial of the conformance suite with what a planner answers, as JSON: for interfaces in other languages, which
// have to answer the same.

#include <cstdint>
#include <string>

#include "wend/planner/planner_info.hpp"

namespace wend::test {

/// The trial of this seed for a planner, on one line. Everything is in metres of the map's frame; numbers are
/// written so that they are read back exactly, infinite ones as null.
std::string trial_json(const PlannerInfo& info, std::uint64_t seed);

}  // namespace wend::test
