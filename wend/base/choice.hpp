#pragma once

// Choice: a value of an enum and its name. An enum that is an option, or that users see, has a
// function `choice_names(Enum)` that returns an array of Choices.

#include <array>
#include <string_view>
#include <type_traits>

namespace wend {

template <class Enum>
struct Choice {
  std::string_view name;  // as in options and reports
  Enum value;             // what it stands for
};

/// The name of a value in a table.
template <class Enum, class Names>
constexpr std::string_view choice_name(Enum value, const Names& names) {
  for (const Choice<Enum>& choice : names) {
    if (choice.value == value) return choice.name;
  }
  return {};
}

/// The name of a value.
template <class Enum>
  requires std::is_enum_v<Enum>
std::string_view choice_name(Enum value) {
  return choice_name(value, choice_names(value));
}

/// The closed range of a number.
struct OptionRange {
  double least;     // the smallest valid value
  double greatest;  // the largest valid value
};

}  // namespace wend
