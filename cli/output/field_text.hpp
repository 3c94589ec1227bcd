#pragma once

// A cost-to-go field as text: costs and moves on a small map, and a summary.

#include <string>

#include "cli/output/terminal.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/report/analysis_report.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

std::string field_text(const CostToGo& field, const FreeSpace& space, const FieldReport& report,
                       const Screen& screen);

}  // namespace wend::cli
