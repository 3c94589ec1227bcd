#pragma once

// visit_fields: what front ends tell of a planner, each fact once: a new one is a member of PlannerInfo and a line here.
//
//   wend::visit_fields(planner, [&](std::string_view name, const auto& value) { entry[name] = value; });

#include "wend/base/option_fields.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/planner/planners.hpp"

namespace wend {

/// Calls visit(name, value) for each fact of a planner, in the order in which people read them. Names are lower case with
/// underscores; values are texts and flags, and at the end its options, a std::vector<OptionInfo>.
template <class Visit>
void visit_fields(const PlannerInfo& planner, Visit&& visit) {
  const Capabilities& can = planner.capabilities;
  visit("name", planner.name);
  visit("summary", planner.summary);
  visit("idea", planner.idea);
  visit("guarantee_text", planner.guarantee_text);
  visit("guarantee", choice_name(planner.guarantee));
  visit("time", planner.time);
  visit("memory", planner.memory);
  visit("when", planner.when);
  visit("motion", planner.motion);
  visit("mover", planner.mover);
  visit("terrain", can.terrain);
  visit("on_terrain", terrain_in_words(planner));
  visit("directions", can.directions);
  visit("any_angle", can.any_angle);
  visit("headings", can.headings);
  visit("on_vertices", can.vertices != Vertices::centres);
  visit("preprocessing", choice_name(planner.preprocessing));
  visit("needs_index", planner.index_support != nullptr);
  visit("can_step", can.can_step);
  visit("resumes", can.resumes);
  visit("citation", planner.citation);
  visit("options", planner.options);
}

}  // namespace wend
