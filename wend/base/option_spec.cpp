#include "wend/base/option_spec.hpp"

#include <utility>

namespace wend {
namespace {

Unexpected<std::string> refused(std::string what) {
  return Unexpected<std::string>(std::move(what));
}

/// Cuts off and returns the text before the first separator, or all of it.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return taken;
}

/// Adds "name=value" to the options; false if it is not of that form.
bool add_option(std::string_view word, OptionSpec& spec) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos || equals == 0) return false;
  spec.options.emplace_back(word.substr(0, equals), word.substr(equals + 1));
  return true;
}

}  // namespace

Expected<std::vector<OptionSpec>, std::string> parse_option_specs(std::string_view list,
                                                                  std::string_view kind,
                                                                  const NameCheck& check) {
  if (list.empty()) return refused("no " + std::string(kind) + " is named");
  std::vector<OptionSpec> specs;
  bool more = true;
  while (more) {
    more = list.find(',') != std::string_view::npos;
    const std::string_view word = take_until(list, ',');
    std::string_view rest = word;
    const std::string_view name = take_until(rest, ':');
    const bool continues = !specs.empty() && name.find('=') != std::string_view::npos;
    if (continues) {
      specs.back().text.append(",").append(word);
      if (!add_option(word, specs.back()))
        return refused('\'' + std::string(word) + "' is no option");
      continue;
    }
    if (std::string wrong = check(name); !wrong.empty()) return refused(std::move(wrong));
    specs.push_back({std::string(word), std::string(name), {}});
    if (word.size() > name.size() && !add_option(rest, specs.back())) {
      return refused('\'' + std::string(rest) + "' in '" + std::string(word) +
                     "' is not of the form option=value");
    }
  }
  return specs;
}

}  // namespace wend
