#pragma once

// The fields of an option struct as text: the opposite of parse_options().
//
//   const wend::OptionValues values = wend::option_values(wend::AStarOptions{.weight = 2});
//   // {{"weight", "2"}}

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "wend/base/choice.hpp"
#include "wend/base/options.hpp"
#include "wend/base/parse.hpp"

namespace wend {

/// Collects the fields of an option struct as text.
class OptionWriter {
 public:
  /// Adds a field.
  template <class Value>
  void operator()(const OptionText& text, const Value& value, OptionRange /*range*/ = {}) {
    values_.emplace_back(std::string(text.name), text_of(value));
  }

  /// All fields, in the order in which they were added.
  const OptionValues& values() const { return values_; }

 private:
  static std::string text_of(bool value) { return option_text::format(value); }
  static std::string text_of(std::int64_t value) { return std::to_string(value); }
  static std::string text_of(double value) { return format_number(value); }

  /// A value without a name has an empty text, which parse_options() refuses.
  template <class Enum>
    requires std::is_enum_v<Enum>
  static std::string text_of(Enum value) {
    return std::string(choice_name(value));
  }

  OptionValues values_;
};

/// The fields that differ from their defaults. parse_options() makes the same struct of them, or refuses what
/// is out of range.
template <class Options>
OptionValues option_values(const Options& options) {
  const Options defaults;
  OptionWriter written;
  OptionWriter unset;
  Options::fields(options, written);
  Options::fields(defaults, unset);
  OptionValues values;
  for (std::size_t i = 0; i < written.values().size(); ++i) {
    if (written.values()[i] != unset.values()[i]) values.push_back(written.values()[i]);
  }
  return values;
}

}  // namespace wend
