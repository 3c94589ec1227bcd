#pragma once

// The registry of planners. A new one is one file and one line in planners.def, or comes from outside:
//
//   const auto added = wend::add_planners({swirl_planner()});
//   if (!added) return report(added.error().message);
//   const auto planner = wend::make_planner("swirl", space);
//
// wend/plugin/planner_plugin.hpp makes a shared object of such a planner, for programs to load.

#include <string>
#include <string_view>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/base/registry.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

class IndexBytes;  // wend/index/file/index_bytes.hpp

/// All planners. The reference stays valid and its entries stay the same for ever; a planner that is
/// added later is in the registry that later calls return.
WEND_API const Registry<PlannerInfo>& planners();

/// Adds planners for the whole program. Fails with invalid_option, and adds none, if a name is taken or is
/// not lower case letters, digits and underscores, or if `make` is missing. Any thread may call it at any
/// time.
WEND_API Expected<void, Error> add_planners(std::vector<PlannerInfo> added);

/// The names of the planners with that PlannerInfo::motion: "cells", "car" or "poses".
WEND_API std::vector<std::string> planner_names(std::string_view motion);

/// Makes a planner by name; an unknown name or option is Status::invalid_option.
WEND_API PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                                    const OptionValues& options = {});

/// The same before a deadline, with its preprocessing and the building of its index; else time_limit or cancelled. A
/// planner that was not ready leaves nothing behind.
WEND_API PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                                    const OptionValues& options, const Deadline& deadline);

/// The same on an existing index; index_mismatch if the index does not match this planner and map,
/// invalid_option if the planner does not use an index.
WEND_API PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                                    const OptionValues& options, IndexBytes index);

/// "costs count", "ignored" or "refused".
WEND_API std::string_view terrain_in_words(const PlannerInfo& planner);

/// A planner and its options in one word, as in lists on the command line:
///
///   astar,bfs:connectivity=4,astar:weight=2,heuristic=euclidean
using PlannerSpec = OptionSpec;

/// For searches that somebody watches: the same planner without leaps (AStarOptions::leaps), so that every
/// cell is seen, unless its options say otherwise.
WEND_API PlannerSpec without_leaps(PlannerSpec planner);

/// The planners of a list. Fails with invalid_option for an unknown planner, a word that is not
/// name=value, and an empty list; PlannerInfo::make checks the options.
WEND_API Expected<std::vector<PlannerSpec>, Error> parse_planner_specs(std::string_view list);

}  // namespace wend
