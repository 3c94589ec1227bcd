#pragma once

// visit_fields: what front ends tell of a controller, each fact once (base/option_fields.hpp).

#include "wend/base/option_fields.hpp"
#include "wend/control/controller.hpp"

namespace wend {

/// Calls visit(name, value) for each fact of a controller: texts, a flag, and its options.
template <class Visit>
void visit_fields(const ControllerInfo& controller, Visit&& visit) {
  visit("name", controller.name);
  visit("summary", controller.summary);
  visit("idea", controller.idea);
  visit("citation", controller.citation);
  visit("turns_in_place", controller.turns_in_place);
  visit("options", controller.options);
}

}  // namespace wend
