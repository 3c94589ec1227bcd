#include "cli/arguments/corner_rule.hpp"

#include "cli/arguments/flags.hpp"

namespace wend::cli {

void add_corner_rule(Parser& app, CornerRule& rule) {
  NamedValues<CornerRule> rules;
  for (const auto& choice : choice_names(CornerRule{})) {
    rules.emplace_back(choice.name, choice.value);
  }
  add_choice<CornerRule>(app, "--corner-rule", rule, rules,
                         "As the path was planned: with both, a robot without a radius may pass "
                         "between two obstacles that touch at a corner (default none)");
}

}  // namespace wend::cli
