#pragma once

// Flags with strict values: numbers in a range, choices, files. A wrong value ends parsing with an
// error that names the flag.

#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
void add_format(CLI::App& app, Format& format);

/// What tables come in.
enum class TableFormat { text, json, csv };

/// --format text|json|csv
void add_table_format(CLI::App& app, TableFormat& format);

/// A finite number in a range.
CLI::Option* add_number(CLI::App& app, const std::string& flags, double& value, OptionRange range,
                        const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& flags, std::optional<double>& value,
                        OptionRange range, const std::string& help);

/// A whole number from 0 on.
CLI::Option* add_count(CLI::App& app, const std::string& flags, std::uint64_t& value,
                       const std::string& help);

/// Throws InputError for a number outside of a range, ends included.
void check_range(const std::string& flag, std::uint64_t value, std::uint64_t least,
                 std::uint64_t most);

/// Texts, each after a flag of its own: `-o a.png -o b.csv`.
CLI::Option* add_texts(CLI::App& app, const std::string& flags, std::vector<std::string>& values,
                       const std::string& help);

/// The help of a flag, broken into lines.
std::string wrapped(std::string_view text);

/// "one, two or three"
std::string or_list(const std::vector<std::string>& names);

/// Throws what CLI11 throws for a wrong value.
[[noreturn]] void refuse_value(const std::string& flags, const std::string& what);

template <class Value>
using NamedValues = std::vector<std::pair<std::string, Value>>;

/// One of a few words.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& flags, Value& value,
                        const NamedValues<Value>& choices, const std::string& help) {
  std::vector<std::string> names;
  std::string type;
  for (const auto& [name, choice] : choices) {
    type += (type.empty() ? "" : "|") + name;
    names.push_back(name);
  }
  const auto assign = [flags, choices, names, &value](const std::string& text) {
    for (const auto& [name, choice] : choices) {
      if (name != text) continue;
      value = choice;
      return;
    }
    refuse_value(flags, option_text::unknown_choice(text, names));
  };
  return app.add_option_function<std::string>(flags, assign, wrapped(help))->type_name(type);
}

}  // namespace wend::cli
