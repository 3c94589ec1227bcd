#pragma once

// Choice: a value of an enum and its name. An enum that is an option, or is shown, has a function
// `choice_names(Enum)` that returns an array of them; options.hpp finds it by its argument.

#include <array>
#include <string_view>

namespace wend {

template <class Enum>
struct Choice {
  std::string_view name;
  Enum value;
};

/// The closed range of a number.
struct OptionRange {
  double least;
  double greatest;
};

}  // namespace wend
