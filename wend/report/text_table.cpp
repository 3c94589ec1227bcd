#include "wend/report/text_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "wend/io/text.hpp"

namespace wend {
namespace {

/// The number of characters of a UTF-8 text.
std::size_t width_of(const std::string& text) {
  const auto is_first_byte = [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_first_byte));
}

/// The titles as rows; titles with fewer lines than others are aligned at the bottom.
std::vector<std::vector<std::string>> title_lines(const std::vector<TextTable::Column>& columns) {
  std::size_t height = 1;
  for (const TextTable::Column& column : columns) {
    const auto breaks = std::count(column.title.begin(), column.title.end(), '\n');
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

/// Breaks a field after commas into lines of at most `longest` characters, where possible.
std::vector<std::string> broken(const std::string& field, std::size_t longest) {
  constexpr std::string_view kIndent = "  ";
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < field.size();) {
    const std::size_t end = std::min(field.find(',', begin), field.size() - 1) + 1;
    const std::string part = field.substr(begin, end - begin);
    if (lines.back().size() > kIndent.size() && width_of(lines.back() + part) > longest) {
      lines.emplace_back(kIndent);
    }
    lines.back() += part;
    begin = end;
  }
  return lines;
}

/// Equal but for rounding: costs are sums.
bool equal(double a, double b) {
  if (std::isinf(a) || std::isinf(b)) return a == b;
  return std::abs(a - b) <= 1e-9 * std::abs(a);
}

}  // namespace

void TextTable::add(std::vector<std::string> row) {
  assert(row.size() == columns_.size());
  for (std::string& field : row) field = visible(field);
  std::vector<std::vector<std::string>> lines{std::move(row)};
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].longest == 0 || width_of(lines[0][i]) <= columns_[i].longest) continue;
    const std::vector<std::string> parts = broken(lines[0][i], columns_[i].longest);
    lines.resize(std::max(lines.size(), parts.size()), std::vector<std::string>(columns_.size()));
    for (std::size_t line = 0; line < parts.size(); ++line) lines[line][i] = parts[line];
  }
  for (std::size_t line = 1; line < lines.size(); ++line) further_.push_back(rows_.size() + line);
  rows_.insert(rows_.end(), lines.begin(), lines.end());
}

/// The width of each column. Continuation lines of a row are ignored: nothing stands beside them.
std::vector<std::size_t> TextTable::widths(
    const std::vector<std::vector<std::string>>& lines) const {
  std::vector<std::size_t> widths(columns_.size(), 0);
  const std::size_t titles = lines.size() - rows_.size();
  for (std::size_t line = 0; line < lines.size(); ++line) {
    if (line >= titles && std::ranges::binary_search(further_, line - titles)) continue;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      widths[i] = std::max(widths[i], width_of(lines[line][i]));
    }
  }
  return widths;
}

std::vector<std::vector<std::string>> TextTable::lines() const {
  std::vector<std::vector<std::string>> lines = title_lines(columns_);
  lines.insert(lines.end(), rows_.begin(), rows_.end());
  return lines;
}

std::size_t TextTable::width() const {
  const auto all = lines();
  const std::vector<std::size_t> widths = this->widths(all);
  std::size_t width = 0;
  for (const auto& fields : all) {
    width = std::max(width, width_of(line(fields, widths)) - 1);  // without its line end
  }
  return width;
}

std::string TextTable::text() const {
  const auto all = lines();
  const std::vector<std::size_t> widths = this->widths(all);
  std::string text;
  for (const auto& fields : all) text += line(fields, widths);
  return text;
}

TextTable TextTable::with_columns(const std::vector<std::size_t>& columns) const {
  TextTable part({});
  part.further_ = further_;
  for (const std::size_t column : columns) part.columns_.push_back(columns_[column]);
  for (const std::vector<std::string>& row : rows_) {
    std::vector<std::string>& fields = part.rows_.emplace_back();
    for (const std::size_t column : columns) fields.push_back(row[column]);
  }
  return part;
}

std::string TextTable::text(std::size_t width) const {
  std::string text;
  std::vector<std::size_t> beside{0};
  for (std::size_t column = 1; column < columns_.size(); ++column) {
    beside.push_back(column);
    if (beside.size() == 2 || with_columns(beside).width() <= width) continue;
    beside.pop_back();
    text += with_columns(beside).text() + "\n";
    beside = {0, column};
  }
  return text + with_columns(beside).text();
}

std::string TextTable::line(const std::vector<std::string>& fields,
                            const std::vector<std::size_t>& widths) const {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t width = width_of(fields[i]);
    const std::string padding(width < widths[i] ? widths[i] - width : 0, ' ');
    if (i > 0) line += "  ";
    line += columns_[i].align == Align::right ? padding + fields[i] : fields[i] + padding;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::vector<bool> best_of(std::span<const double> values, bool more_is_better) {
  std::vector<bool> marks(values.size(), false);
  double best = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (std::isnan(value)) continue;
    if (std::isnan(best) || (more_is_better ? value > best : value < best)) best = value;
  }
  const auto is_worse = [best](double value) { return !std::isnan(value) && !equal(best, value); };
  if (std::none_of(values.begin(), values.end(), is_worse)) return marks;
  std::transform(values.begin(), values.end(), marks.begin(),
                 [best](double value) { return equal(best, value); });
  return marks;
}

std::string csv_field(const std::string& text) {
  std::string field = visible(text);
  if (field.find_first_of(",\"\n") == std::string::npos) return field;
  for (std::size_t at = 0; (at = field.find('"', at)) != std::string::npos; at += 2) {
    field.insert(at, 1, '"');
  }
  return '"' + field + '"';
}

}  // namespace wend
