#pragma once

// Indexes on the command line: one that is given with --index, and one that is built now.

#include <string>

#include "wend/base/workers.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/file/index_header.hpp"
#include "wend/io/files.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend::cli {

/// An index that need not be built.
struct GivenIndex {
  std::string file;
  IndexHeader header;
  IndexBytes bytes;
};

/// Throws InputError for a file that cannot be read. What is wrong with one that is no index, or a
/// damaged one, is the error.
Expected<GivenIndex, std::string> read_given_index(const std::string& file);

/// Builds with a progress bar.
Expected<IndexBytes, PlannerError> build_index(const PlannerInfo& planner, const FreeSpace& space,
                                               Workers& workers);

/// "hub_labels or corner_hierarchy": the planners that can plan on an index.
std::string planners_with_index();

}  // namespace wend::cli
