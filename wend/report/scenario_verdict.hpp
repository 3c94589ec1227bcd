#pragma once

// Whether a planner's answer to a query of a MovingAI scenario is right.

#include <string>

#include "wend/base/status.hpp"
#include "wend/io/scenario.hpp"
#include "wend/map/free_space.hpp"
#include "wend/planner/plan.hpp"

namespace wend {

/// What is wrong with an answer, empty if nothing is: none where the file gives a length, one where
/// it says that there is none, or a path of another length.
std::string wrong_answer(const ScenarioQuery& query, Status status, const Plan& plan);

/// What is wrong with a path cell by cell, empty if nothing is: it does not join start and goal, or
/// it is not one for 8 neighbours without corner cutting. O(length).
std::string wrong_path(const FreeSpace& space, const ScenarioQuery& query, const Path& path);

}  // namespace wend
