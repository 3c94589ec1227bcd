#pragma once

// The planners there are. A new one is one file and one line in planners.def.

#include <string>
#include <string_view>
#include <vector>

#include "wend/base/options.hpp"
#include "wend/base/registry.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

class IndexBytes;  // wend/index/file/index_bytes.hpp

const Registry<PlannerInfo>& planners();

/// The names of those that move so.
std::vector<std::string> planner_names(Motion motion);

/// Makes a planner by name; an unknown name or option is Status::invalid_option.
PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options = {});

/// The same on an index that was built before; index_mismatch if it is no index for this planner on
/// this map, invalid_option if the planner needs none.
PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options, IndexBytes index);

}  // namespace wend
