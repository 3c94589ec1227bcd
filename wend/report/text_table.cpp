#include "wend/report/text_table.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace wend {
namespace {

/// Characters of a UTF-8 text.
std::size_t width_of(const std::string& text) {
  const auto is_first_byte = [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_first_byte));
}

/// The titles as rows; those of fewer lines than others stand at the bottom.
std::vector<std::vector<std::string>> title_lines(const std::vector<TextTable::Column>& columns) {
  std::size_t height = 1;
  for (const auto& [title, align] : columns) {
    const auto breaks = std::count(title.begin(), title.end(), '\n');
    height = std::max(height, static_cast<std::size_t>(breaks) + 1);
  }
  std::vector<std::vector<std::string>> lines(height, std::vector<std::string>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::string rest = columns[i].title;
    for (std::size_t row = height; row-- > 0 && !rest.empty();) {
      const std::size_t line_break = rest.rfind('\n');
      lines[row][i] = rest.substr(line_break == std::string::npos ? 0 : line_break + 1);
      rest.erase(line_break == std::string::npos ? 0 : line_break);
    }
  }
  return lines;
}

/// Of each column.
std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& fields : lines) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      widths[i] = std::max(widths[i], width_of(fields[i]));
    }
  }
  return widths;
}

}  // namespace

void TextTable::add(std::vector<std::string> row) {
  assert(row.size() == columns_.size());
  rows_.push_back(std::move(row));
}

std::vector<std::vector<std::string>> TextTable::lines() const {
  std::vector<std::vector<std::string>> lines = title_lines(columns_);
  lines.insert(lines.end(), rows_.begin(), rows_.end());
  return lines;
}

std::size_t TextTable::width() const {
  const auto all = lines();
  const std::vector<std::size_t> widths = widths_of(all);
  std::size_t width = 0;
  for (const auto& fields : all) {
    width = std::max(width, width_of(line(fields, widths)) - 1);  // without its line end
  }
  return width;
}

std::string TextTable::text() const {
  const auto all = lines();
  const std::vector<std::size_t> widths = widths_of(all);
  std::string text;
  for (const auto& fields : all) text += line(fields, widths);
  return text;
}

std::string TextTable::line(const std::vector<std::string>& fields,
                            const std::vector<std::size_t>& widths) const {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string padding(widths[i] - width_of(fields[i]), ' ');
    if (i > 0) line += "  ";
    line += columns_[i].align == Align::right ? padding + fields[i] : fields[i] + padding;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace wend
