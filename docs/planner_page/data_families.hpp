#pragma once

// Families on the MovingAI maps of a data folder, where there is one.

#include <filesystem>
#include <vector>

#include "docs/planner_page/family.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"

namespace wend::planner_page {

/// A sample of each scenario; an error says which file could not be read.
Expected<std::vector<Family>, IoError> data_families(const std::filesystem::path& folder);

}  // namespace wend::planner_page
