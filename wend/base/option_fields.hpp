#pragma once

// visit_fields: what front ends tell of an option, each fact once. Registries of planners and others have such a list;
// a front end writes each value under its name, in its own language.
//
//   wend::visit_fields(option, [&](std::string_view name, const auto& value) { entry[name] = value; });

#include "wend/base/options.hpp"

namespace wend {

/// Calls visit(name, value) for each fact of an option, in the order in which people read them. Names are lower case with
/// underscores; values are texts, lists of texts and numbers. `choices` is empty but for a choice; `least` and `greatest` are 0
/// but for an integer or a number.
template <class Visit>
void visit_fields(const OptionInfo& option, Visit&& visit) {
  visit("name", option.name);
  visit("aliases", option.aliases);
  visit("kind", to_string(option.kind));
  visit("default", option.default_value);
  visit("choices", option.choices);
  visit("least", option.least);
  visit("greatest", option.greatest);
  visit("help", option.help);
}

}  // namespace wend
