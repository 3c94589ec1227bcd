#include "cli/arguments/flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/exit_code.hpp"
#include "wend/base/parse.hpp"
#include "wend/base/registry.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

constexpr std::size_t kHelpWidth = 46;  // beside the names, in 80 columns

template <class Value>
Argument add_number_to(Parser& app, const std::string& flags, Value& value,
                       const NumberRange& range, const std::string& help) {
  const auto assign = [flags, range, &value](const std::string& text) {
    double number = 0;
    const std::string wrong = parse_in_range(text, number, range.least, range.greatest, range.unit);
    if (!wrong.empty()) refuse_value(flags, wrong);
    value = number;
  };
  return app.add_option(flags, assign, wrapped(help)).type_name("NUMBER");
}

}  // namespace

void add_format(Parser& app, Format& format) {
  add_choice<Format>(app, "--format", format, {{"text", Format::text}, {"json", Format::json}},
                     "Format of the output (default text)");
}

void add_table_format(Parser& app, TableFormat& format) {
  add_choice<TableFormat>(
      app, "--format", format,
      {{"text", TableFormat::text}, {"json", TableFormat::json}, {"csv", TableFormat::csv}},
      "Format of the table (default text)");
}

Argument add_number(Parser& app, const std::string& flags, double& value, const NumberRange& range,
                    const std::string& help) {
  return add_number_to(app, flags, value, range, help);
}

Argument add_number(Parser& app, const std::string& flags, std::optional<double>& value,
                    const NumberRange& range, const std::string& help) {
  return add_number_to(app, flags, value, range, help);
}

Argument add_count(Parser& app, const std::string& flags, std::uint64_t& value,
                   const std::string& help) {
  const auto assign = [flags, &value](const std::string& text) {
    const auto number = parse_integer<std::uint64_t>(text);
    if (!number) refuse_value(flags, quote(text) + " is not a whole number of at least 0");
    value = *number;
  };
  return app.add_option(flags, assign, wrapped(help)).type_name("N");
}

void check_range(const std::string& flag, std::uint64_t value, std::uint64_t least,
                 std::uint64_t most) {
  if (value >= least && value <= most) return;
  throw InputError(fmt::format("{} {}: must be from {} to {}", flag, value, least, most));
}

void check_positive(const std::string& flag, std::uint64_t count) {
  if (count == 0) throw InputError(flag + " 0: must be at least 1");
}

Argument add_texts(Parser& app, const std::string& flags, std::vector<std::string>& values,
                   const std::string& help) {
  return app.add_option(flags, values, wrapped(help)).one_at_a_time();
}

Argument add_word(Parser& app, const std::string& flags, const std::vector<std::string>& words,
                  const std::function<void(std::size_t)>& assign, const std::string& help) {
  const auto find = [flags, words, assign](const std::string& text) {
    const auto word = std::ranges::find(words, text);
    if (word == words.end()) refuse_value(flags, option_text::unknown_choice(text, words));
    assign(static_cast<std::size_t>(word - words.begin()));
  };
  return app.add_option(flags, find, wrapped(help))
      .type_name(fmt::format("{}", fmt::join(words, "|")));
}

void refuse_idle(const Parser& command, const std::vector<std::string>& flags,
                 std::string_view why) {
  for (const std::string& flag : flags) {
    const std::string typed = command.typed(flag);
    if (!typed.empty()) throw InputError(fmt::format("{} changes nothing: {}", typed, why));
  }
}

std::string wrapped(std::string_view text) {
  std::string lines;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = text.find(' ');
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (column > 0) lines += column + 1 + word.size() > kHelpWidth ? '\n' : ' ';
    column = column > 0 && lines.back() == ' ' ? column + 1 + word.size() : word.size();
    lines += word;
  }
  return lines;
}

std::string unwrapped(std::string_view text) {
  std::string joined;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of(" \n");
    const std::string_view word = text.substr(0, end);
    joined += word;
    column += word.size();
    if (end == std::string_view::npos) break;
    const bool at_line_end = text[end] == '\n';
    text.remove_prefix(end + 1);
    const std::size_t next = text.substr(0, text.find_first_of(" \n")).size();
    const bool was_wrapped = at_line_end && column + 1 + next > kHelpWidth;
    joined += at_line_end && !was_wrapped ? '\n' : ' ';
    column = at_line_end ? 0 : column + 1;
  }
  return joined;
}

std::string or_list(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool last = i + 1 == names.size();
    list += (i == 0 ? "" : last ? " or " : ", ") + names[i];
  }
  return list;
}

}  // namespace wend::cli
