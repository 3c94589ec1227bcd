#pragma once

// OptionSpec: a thing of a registry and its options in one word, as people type them in lists:
//
//   astar,bfs:connectivity=4,astar:weight=2,heuristic=euclidean

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/base/registry.hpp"

namespace wend {

struct OptionSpec {
  std::string text;  // as typed: "astar:weight=2"
  std::string name;
  OptionValues options{};
};

/// What is wrong with a name, empty if nothing is.
using NameCheck = std::function<std::string(std::string_view name)>;

/// The things of a list; `kind` is what they are called: "planner". Fails for a name that the check
/// refuses, a word that is not name=value, and an empty list; whether the options fit is not checked.
Expected<std::vector<OptionSpec>, std::string> parse_option_specs(std::string_view list,
                                                                  std::string_view kind,
                                                                  const NameCheck& check);

/// The same of the entries of a registry.
template <class T>
Expected<std::vector<OptionSpec>, std::string> parse_option_specs(std::string_view list,
                                                                  std::string_view kind,
                                                                  const Registry<T>& registry) {
  const NameCheck check = [&](std::string_view name) {
    return registry.find(name) == nullptr ? registry.unknown(kind, name) : std::string();
  };
  return parse_option_specs(list, kind, check);
}

}  // namespace wend
