// A plugin with two planners, which plan as A* does.

#include "wend/plugin/planner_plugin.hpp"

namespace {

wend::PlannerInfo one() {
  wend::PlannerInfo info = *wend::planners().find("astar");
  info.name = "one";
  return info;
}

wend::PlannerInfo two() {
  wend::PlannerInfo info = one();
  info.name = "two";
  return info;
}

}  // namespace

WEND_PLANNER_PLUGIN(one, two)
