#include "cli/arguments/help_formatter.hpp"

#include <fmt/ranges.h>

#include <CLI/App.hpp>

namespace wend::cli {

std::vector<std::string> shown_names(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& letter : option.get_snames()) names.push_back("-" + letter);
  for (const std::string& name : option.get_lnames()) {
    if (name.find('_') == std::string::npos) names.push_back("--" + name);
  }
  return names;
}

std::string HelpFormatter::make_option_name(const CLI::Option* option, bool is_positional) const {
  if (is_positional) return option->get_name(true, false);
  return fmt::format("{}", fmt::join(shown_names(*option), ", "));
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  std::string type = option->get_type_name();
  if (type.empty()) return {};  // a flag
  const bool value_is_optional = option->get_items_expected_max() == 0;
  if (value_is_optional) return type.insert(1, 1, '=');
  type.insert(0, 1, ' ');
  if (option->get_expected_max() == CLI::detail::expected_max_vector_size) type += " ...";
  return type + (option->get_required() ? " (required)" : "");
}

}  // namespace wend::cli
