#pragma once

// What the measurements say, in words. Every sentence is chosen by the numbers: what was not
// measured is not claimed.

#include <span>
#include <string>

#include "docs/planner_page/page.hpp"

namespace wend::planner_page {

/// Paragraphs with a bold beginning each, with a blank line between them.
std::string findings(const Measurements& measurements);

}  // namespace wend::planner_page
