#pragma once

// Flags with strict values: numbers in a range, choices, files. A wrong value ends parsing with an
// error that names the flag.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments/parser.hpp"
#include "wend/base/options.hpp"

namespace wend::cli {

/// What a flag takes, as help shows it and shell completion reads it. Choices read "text|json".
inline constexpr const char* kFileType = "FILE";
inline constexpr const char* kPlannerType = "PLANNER";
inline constexpr const char* kGeneratorType = "KIND";
inline constexpr const char* kSmootherType = "SMOOTHER";
inline constexpr const char* kControllerType = "CONTROLLER";
inline constexpr const char* kLayerType = "LAYER";
inline constexpr const char* kStyleType = "STYLE";

enum class Format { text, json };

/// --format text|json
void add_format(Parser& app, Format& format);

/// The formats of tables.
enum class TableFormat { text, json, csv };

/// --format text|json|csv
void add_table_format(Parser& app, TableFormat& format);

/// The closed range of a number, and the unit that messages name with it.
struct NumberRange {
  double least;
  double greatest;
  std::string_view unit = {};
};

/// The unit of lengths that are typed in the map's units.
inline constexpr std::string_view kMapUnit = "metres (cells on maps in cells and with --cells)";

/// A finite number in a range.
Argument add_number(Parser& app, const std::string& flags, double& value, const NumberRange& range,
                    const std::string& help);
Argument add_number(Parser& app, const std::string& flags, std::optional<double>& value,
                    const NumberRange& range, const std::string& help);

/// A whole number, 0 or more.
Argument add_count(Parser& app, const std::string& flags, std::uint64_t& value,
                   const std::string& help);

/// Throws InputError for a number outside of a range, ends included.
void check_range(const std::string& flag, std::uint64_t value, std::uint64_t least,
                 std::uint64_t most);

constexpr std::uint64_t kMostThreads = 1024;  // of --threads

/// Throws InputError for a count of 0.
void check_positive(const std::string& flag, std::uint64_t count);

/// Throws InputError if one of these flags was given: it would change nothing. `why` says what to do
/// instead.
void refuse_idle(const Parser& command, const std::vector<std::string>& flags,
                 std::string_view why);

/// Texts, each after a flag of its own: `-o a.png -o b.csv`.
Argument add_texts(Parser& app, const std::string& flags, std::vector<std::string>& values,
                   const std::string& help);

/// The help of a flag, broken into lines.
std::string wrapped(std::string_view text);

/// Undoes wrapped(): joins lines, except where the next word would have fitted.
std::string unwrapped(std::string_view text);

/// "one, two or three"
std::string or_list(const std::vector<std::string>& names);

template <class Value>
using NamedValues = std::vector<std::pair<std::string, Value>>;

/// The values of an enum with choice_names().
template <class Value>
NamedValues<Value> named_values() {
  NamedValues<Value> values;
  for (const auto& choice : choice_names(Value{})) values.emplace_back(choice.name, choice.value);
  return values;
}

/// One of a few words; `assign` is told which of them.
Argument add_word(Parser& app, const std::string& flags, const std::vector<std::string>& words,
                  const std::function<void(std::size_t)>& assign, const std::string& help);

/// One of a few named values.
template <class Value>
Argument add_choice(Parser& app, const std::string& flags, Value& value,
                    const NamedValues<Value>& choices, const std::string& help) {
  std::vector<std::string> words;
  for (const auto& [name, choice] : choices) words.push_back(name);
  const auto assign = [choices, &value](std::size_t which) { value = choices[which].second; };
  return add_word(app, flags, words, assign, help);
}

}  // namespace wend::cli
