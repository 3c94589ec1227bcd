#pragma once

// MarkdownTable: a table as GitHub's markdown has it, for the pages that programs write.

#include <string>
#include <utility>
#include <vector>

#include "wend/report/text_table.hpp"

namespace wend {

class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<TextTable::Column> columns) : columns_(std::move(columns)) {}

  /// As many fields as there are columns; '|' is escaped.
  void add(const std::vector<std::string>& row);

  /// The columns' titles and the rows, each line with its end.
  std::string text() const;

 private:
  std::vector<TextTable::Column> columns_;
  std::string rows_;
};

}  // namespace wend
