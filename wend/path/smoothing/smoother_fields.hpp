#pragma once

// visit_fields: what front ends tell of a smoother, each fact once (base/option_fields.hpp).

#include "wend/base/option_fields.hpp"
#include "wend/path/smoothing/smoother.hpp"

namespace wend {

/// Calls visit(name, value) for each fact of a smoother: texts, a flag, and its options.
template <class Visit>
void visit_fields(const SmootherInfo& smoother, Visit&& visit) {
  visit("name", smoother.name);
  visit("summary", smoother.summary);
  visit("citation", smoother.citation);
  visit("drives", smoother.drives);
  visit("options", smoother.options);
}

}  // namespace wend
