#include "cli/arguments/moves_arguments.hpp"

#include "cli/arguments/flags.hpp"

namespace wend::cli {
namespace {

template <class Value>
NamedValues<Value> named_values() {
  NamedValues<Value> values;
  for (const auto& choice : choice_names(Value{})) values.emplace_back(choice.name, choice.value);
  return values;
}

}  // namespace

void MovesArguments::add_to(Parser& app) {
  add_choice<Connectivity>(app, "--connectivity", moves.connectivity, named_values<Connectivity>(),
                           "Move to 4 or 8 neighbours (default 8)");
  add_choice<CornerRule>(app, "--corner-rule", moves.corner_rule, named_values<CornerRule>(),
                         "How many corners a diagonal step may cut (default none)");
}

}  // namespace wend::cli
