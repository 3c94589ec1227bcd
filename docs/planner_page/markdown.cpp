#include "docs/planner_page/markdown.hpp"

#include <fmt/format.h>

#include <cmath>

namespace wend::planner_page {
namespace {

std::string line(const std::vector<std::string>& fields) {
  std::string text = "|";
  for (const std::string& field : fields) {
    text += ' ';
    for (const char letter : field)
      text += letter == '|' ? std::string("\\|") : std::string(1, letter);
    text += " |";
  }
  return text + '\n';
}

}  // namespace

void MarkdownTable::add(const std::vector<std::string>& row) { rows_ += line(row); }

std::string MarkdownTable::text() const {
  std::vector<std::string> titles;
  std::string rule = "|";
  for (const TextTable::Column& column : columns_) {
    titles.push_back(column.title);
    rule += column.align == Align::right ? "---:|" : "---|";
  }
  return line(titles) + rule + '\n' + rows_;
}

std::string code(std::string_view text) { return fmt::format("`{}`", text); }

std::string link_to(std::string_view title) {
  std::string anchor;
  for (const char letter : title) {
    if (letter == ',') continue;
    const bool upper = letter >= 'A' && letter <= 'Z';
    anchor += letter == ' ' ? '-' : upper ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return fmt::format("[{}](#{})", title, anchor);
}

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool last = i + 1 == items.size();
    text += i == 0 ? "" : last ? " and " : ", ";
    text += items[i];
  }
  return text;
}

std::string number(double value, int decimals, bool best) {
  if (!std::isfinite(value)) return "-";
  return fmt::format(fmt::runtime(best ? "**{:.{}f}**" : "{:.{}f}"), value, decimals);
}

std::string factor(double value) {
  constexpr double kFewDigits = 10;
  constexpr double kOneDigit = 2;
  return fmt::format("{:.{}f}", value, value >= kFewDigits ? 0 : value >= kOneDigit ? 1 : 2);
}

std::string percent(double share) {
  constexpr double kSmall = 0.02;
  return fmt::format("{:.{}f} %", 100 * share, share < kSmall ? 1 : 0);
}

}  // namespace wend::planner_page
