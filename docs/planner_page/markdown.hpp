#pragma once

// Text as GitHub's markdown has it.

#include <string>
#include <string_view>
#include <vector>

#include "wend/report/text_table.hpp"

namespace wend::planner_page {

class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<TextTable::Column> columns) : columns_(std::move(columns)) {}

  /// As many fields as there are columns; '|' is escaped.
  void add(const std::vector<std::string>& row);

  /// The columns' names and the rows, each line with its end.
  std::string text() const;

 private:
  std::vector<TextTable::Column> columns_;
  std::string rows_;
};

/// `text`, so that it reads as code.
std::string code(std::string_view text);

/// A link to the section of that title, of plain words and commas, on the same page.
std::string link_to(std::string_view title);

/// "a", "a and b", "a, b and c"
std::string listed(const std::vector<std::string>& items);

/// A number with that many decimals, "-" for one that is not finite; bold if it is the best.
std::string number(double value, int decimals, bool best = false);

/// A factor to read in a sentence: "0.31", "2.4", "37".
std::string factor(double value);

/// A share as a percentage: "31 %", "0.4 %".
std::string percent(double share);

}  // namespace wend::planner_page
