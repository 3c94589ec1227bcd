#pragma once

// Tables: aligned columns for a terminal, and fields of CSV.
//
//   wend::TextTable table({{"planner"}, {"mean us", wend::Align::right}});
//   table.add({"astar", "12.5"});
//   print(table.text());

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wend {

enum class Align { left, right };

class TextTable {
 public:
  struct Column {
    std::string title;  // may have several lines
    Align align = Align::left;
    /// Longer fields are broken after commas; their further lines are indented, and may extend below
    /// the next columns. 0: never.
    std::size_t longest = 0;
  };

  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Adds as many fields as there are columns, as visible() shows them; UTF-8, one terminal column for each character. Beside a
  /// field of several lines, the other fields stand in the first line.
  void add(std::vector<std::string> row);

  /// The width of the longest line.
  std::size_t width() const;

  /// The titles, then the rows, each with its line end.
  std::string text() const;

  /// The same in at most that many columns where one field fits beside the first one: columns for which there is no room
  /// follow in tables below, again behind the first column.
  std::string text(std::size_t width) const;

 private:
  TextTable with_columns(const std::vector<std::size_t>& columns) const;
  std::vector<std::vector<std::string>> lines() const;
  std::vector<std::size_t> widths(const std::vector<std::vector<std::string>>& lines) const;
  std::string line(const std::vector<std::string>& fields,
                   const std::vector<std::size_t>& widths) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> further_;  // rows that are further lines of one above
};

/// Which of the values are the best. None if fewer than two are not NaN, or if all of these are equal up
/// to rounding.
std::vector<bool> best_of(std::span<const double> values, bool more_is_better);

/// A field of CSV, in quotes where it needs them (RFC 4180), and as visible() shows it.
std::string csv_field(const std::string& text);

}  // namespace wend
