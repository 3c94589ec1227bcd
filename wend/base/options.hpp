#pragma once

// Options: a plain struct with defaults that lists its fields once. The list gives the schema
// (names, ranges, defaults, help, for flags and parameters) and the parser with its range checks.
//
//   struct WalkOptions {
//     std::int64_t max_steps = 100;
//     double boldness = 0.5;
//
//     template <class Self, class Field>
//     static void fields(Self& self, Field&& field) {
//       field({"max_steps", "limit on the number of steps"}, self.max_steps, {1, 1e9});
//       field({"boldness", "how far it strays"}, self.boldness, {0, 1});
//     }
//   };
//
//   const auto options = wend::parse_options<WalkOptions>({{"max_steps", "50"}});
//
// A field is a bool, an integer, a double, or an enum for which `choice_names(Enum)` returns an
// array of Choice<Enum>.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/parse.hpp"

namespace wend {

/// The names and the help text of one option.
struct OptionText {
  std::string_view name;                         // lower case, with underscores
  std::string_view help;                         // one line, with the unit
  std::array<std::string_view, 2> aliases = {};  // other names, as in the literature
  std::string_view former = {};                  // an old name: parsed, but not shown
};

/// The type of an option's value.
enum class OptionKind {
  flag,     // true or false
  integer,  // a whole number in a range
  number,   // a number in a range
  choice    // one of a list of names
};

/// The name in the enum: "flag", "integer", ...
WEND_API std::string_view to_string(OptionKind kind);

/// One option, as the front ends see it.
struct OptionInfo {
  std::string name;                  // as users type it
  std::vector<std::string> aliases;  // other names, as in the literature
  OptionKind kind;                   // the type of its value
  std::string default_value;         // as text
  std::vector<std::string> choices;  // for a choice
  double least = 0;                  // for an integer or a number
  double greatest = 0;               // the largest valid value
  std::string help;                  // one line, with the unit
  std::string former = {};           // an old name, or empty: parsed, but not shown
};

/// Options as text, by name: {"weight", "1.5"}.
using OptionValues = std::vector<std::pair<std::string, std::string>>;

/// Functions that check and convert the text of one option. Each returns an error text, empty on success.
namespace option_text {
/// Reads "true" or "false".
WEND_API std::string parse(std::string_view text, bool& value, OptionRange range = {});
/// Reads a whole number in a range.
WEND_API std::string parse(std::string_view text, std::int64_t& value, OptionRange range);
/// Reads a number in a range.
WEND_API std::string parse(std::string_view text, double& value, OptionRange range);
/// The error text for a value that is not among the choices.
WEND_API std::string unknown_choice(std::string_view text, const std::vector<std::string>& choices);
/// The error of an option with an invalid value: invalid_option, with the option as Error::where.
WEND_API Error option_error(const std::string& option, const std::string& what);
/// The error of an option that does not exist; suggests a similar name.
WEND_API Error unknown_option(std::string_view name, const std::vector<std::string>& known);
/// What is wrong with a text as the value of an option that is known by its schema; empty if nothing is.
WEND_API std::string fault_of(const OptionInfo& option, std::string_view text);
/// "true" or "false".
WEND_API std::string format(bool value);

/// Reads the name of a value of an enum.
template <class Enum>
  requires std::is_enum_v<Enum>
std::string parse(std::string_view text, Enum& value, OptionRange /*range*/) {
  std::vector<std::string> names;
  for (const auto& choice : choice_names(Enum{})) {
    if (choice.name == text) {
      value = choice.value;
      return {};
    }
    names.emplace_back(choice.name);
  }
  return unknown_choice(text, names);
}
}  // namespace option_text

/// Collects the schema of an option struct. The defaults come from a default-constructed struct.
class WEND_API SchemaBuilder {
 public:
  /// Adds a flag.
  void operator()(const OptionText& text, bool& value) {
    add(text, OptionKind::flag, option_text::format(value));
  }
  /// Adds a whole number.
  void operator()(const OptionText& text, std::int64_t& value, OptionRange range) {
    add(text, OptionKind::integer, std::to_string(value), range);
  }
  /// Adds a number.
  void operator()(const OptionText& text, double& value, OptionRange range) {
    add(text, OptionKind::number, format_number(value), range);
  }
  /// Adds a choice.
  template <class Enum>
    requires std::is_enum_v<Enum>
  void operator()(const OptionText& text, Enum& value) {
    OptionInfo& info = add(text, OptionKind::choice, {});
    for (const auto& choice : choice_names(Enum{})) {
      info.choices.emplace_back(choice.name);
      if (choice.value == value) info.default_value = choice.name;
    }
  }

  /// The options in the order in which they were added. Leaves the builder empty.
  std::vector<OptionInfo> take() { return std::move(schema_); }

 private:
  OptionInfo& add(const OptionText& text, OptionKind kind, std::string default_value,
                  OptionRange range = {0, 0});

  std::vector<OptionInfo> schema_;
};

/// Sets the fields of an option struct from text.
class WEND_API OptionParser {
 public:
  /// `values` must outlive the parser.
  explicit OptionParser(const OptionValues& values) : values_(values) {}

  /// The range applies only to numbers.
  template <class Value>
  void operator()(const OptionText& text, Value& value, OptionRange range = {}) {
    known_.emplace_back(text.name);
    for (const std::string_view alias : text.aliases) {
      if (!alias.empty()) known_.emplace_back(alias);
    }
    if (!text.former.empty()) former_.emplace_back(text.former);
    for (const auto& [name, given] : values_) {
      if (!is_name_of(text, name)) continue;
      const std::string wrong = option_text::parse(given, value, range);
      if (!wrong.empty() && !bad_value_) bad_value_ = option_text::option_error(name, wrong);
    }
  }

  /// The first error, if any: an unknown name, else a bad value.
  std::optional<Error> error() const;

 private:
  static bool is_name_of(const OptionText& text, std::string_view name) {
    return name == text.name ||
           (!name.empty() &&
            (name == text.former ||
             std::find(text.aliases.begin(), text.aliases.end(), name) != text.aliases.end()));
  }

  const OptionValues& values_;
  std::vector<std::string> known_;
  std::vector<std::string> former_;
  std::optional<Error> bad_value_;
};

/// The options of an option struct, in the order of its fields.
template <class Options>
std::vector<OptionInfo> option_schema() {
  Options defaults;
  SchemaBuilder builder;
  Options::fields(defaults, builder);
  return builder.take();
}

/// The defaults with `values` applied. Fails for an unknown name, an invalid value, or a number out of
/// range. If a name is given twice, the last value counts.
template <class Options>
Expected<Options, Error> parse_options(const OptionValues& values) {
  Options options;
  OptionParser parser(values);
  Options::fields(options, parser);
  if (auto error = parser.error()) return Unexpected<Error>(*std::move(error));
  return options;
}

/// An entry of a registry and its options in one word, as users type them in lists:
///
///   astar,bfs:connectivity=4,astar:weight=2,heuristic=euclidean
struct OptionSpec {
  std::string name;        // of the entry: "astar"
  OptionValues options{};  // in the order in which they were typed
  std::string text{};      // as typed: "astar:weight=2"; empty if nobody typed it
};

/// Parses a list of entries with these names. `kind` says what an entry is: "planner". Fails for an
/// unknown name, a word that is not name=value, and an empty list. Does not check whether the options
/// are valid.
WEND_API Expected<std::vector<OptionSpec>, Error> parse_option_specs(
    std::string_view list, std::string_view kind, const std::vector<std::string>& names);

}  // namespace wend
