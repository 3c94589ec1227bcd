// A plugin with one planner of a new name, and one whose name is taken.

#include "wend/plugin/planner_plugin.hpp"

namespace {

wend::PlannerResult make_none(const wend::FreeSpace&, const wend::OptionValues&) {
  return wend::failure(wend::Status::unsupported_map, "it plans nowhere");
}

wend::PlannerInfo fresh() { return {.name = "fresh", .make = make_none}; }
wend::PlannerInfo taken() { return {.name = "astar", .make = make_none}; }

}  // namespace

WEND_PLANNER_PLUGIN(fresh, taken)
