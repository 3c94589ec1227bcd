#include "bench/measure/markdown_table.hpp"

namespace wend {
namespace {

std::string markdown_row(const std::vector<std::string>& fields) {
  std::string text = "|";
  for (const std::string& field : fields) {
    text += ' ';
    for (const char letter : field) {
      if (letter == '|') text += '\\';
      text += letter;
    }
    text += " |";
  }
  return text + '\n';
}

}  // namespace

void MarkdownTable::add(const std::vector<std::string>& row) { rows_ += markdown_row(row); }

std::string MarkdownTable::text() const {
  std::vector<std::string> titles;
  std::string rule = "|";
  for (const TextTable::Column& column : columns_) {
    titles.push_back(column.title);
    rule += column.align == Align::right ? "---:|" : "---|";
  }
  return markdown_row(titles) + rule + '\n' + rows_;
}

}  // namespace wend
