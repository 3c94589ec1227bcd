#pragma once

// `wend plan --queries`: many queries on one map, by as many planners as there are threads.

#include "cli/commands/plan_run.hpp"
#include "cli/exit_code.hpp"

namespace wend::cli {

/// Throws InputError for flags that are about a single query.
void check_queries(const PlanArguments& arguments);

/// Answers every row of the file, and prints and writes the answers. Throws InputError if the file
/// cannot be read, but not for an invalid row.
ExitCode run_queries(const PlanArguments& arguments, Session& session, const PlannerSpec& planner,
                     const IndexArgument& index);

}  // namespace wend::cli
