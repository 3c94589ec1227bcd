#pragma once

// What planners find out about failures: the causes that they share.

#include <optional>
#include <vector>

#include "wend/planner/failure.hpp"

namespace wend {

/// Why the robot does not fit in the middle of a cell at every heading, or at a pose; nothing if it does.
std::optional<FailureCause> why_blocked(const FreeSpace& space, EndIndex end, Cell cell);
/// The same at a pose.
std::optional<FailureCause> why_blocked(const FreeSpace& space, EndIndex end, const Pose& pose);

/// The causes of Failure of a planner on cells.
std::vector<FailureCause> causes_in_cells(const FreeSpace& space, const Query& query,
                                          Status status);

/// A query that is wrong for every planner.
std::optional<InvalidQuery> fault_of(const Query& query);

}  // namespace wend
