#include "cli/watching/narrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/report/plan_report.hpp"

namespace wend::cli {
namespace {

std::string place_text(Cell cell, std::optional<double> heading, const Frame& frame) {
  if (!heading) return cell_text(cell);
  return fmt::format("({},{},{})", cell.x, cell.y, heading_text(*heading, frame));
}

std::string reached_text(std::string_view how, const SearchEvent& event, const Frame& frame) {
  const std::string from =
      event.parent ? " from " + place_text(*event.parent, event.parent_heading, frame) : "";
  return fmt::format("  {} {}{} f={:.6g} g={:.6g} h={:.6g}\n", how,
                     place_text(event.cell, event.heading, frame), from, event.f, event.g, event.h);
}

using Row = std::vector<std::string>;

std::string_view mark_of(OpenTie tie) {
  switch (tie) {
    case OpenTie::none:
      break;
    case OpenTie::g:
      return "g";
    case OpenTie::newest:
      return "new";
    case OpenTie::chosen:
      return "ties";
  }
  return "";
}

std::string number(double value) { return fmt::format("{:.6g}", value); }

Row titles_of(bool headings) {
  Row row{"", "x", "y"};
  if (headings) row.emplace_back("heading");
  row.insert(row.end(), {"g", "h", "f", "tie"});
  return row;
}

Row row_of(std::size_t rank, const OpenEntry& entry, const Frame& frame) {
  const SearchEvent& state = entry.state;
  Row row{std::to_string(rank), std::to_string(state.cell.x), std::to_string(state.cell.y)};
  if (state.heading) row.push_back(heading_text(*state.heading, frame));
  row.insert(row.end(),
             {number(state.g), number(state.h), number(state.f), std::string(mark_of(entry.tie))});
  return row;
}

/// Right-aligned but for the last column.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      line += fmt::format("{}{:>{}}", i == 0 ? " " : "  ", row[i], widths[i]);
    }
    text += line + (row.back().empty() ? "" : "  " + row.back()) + "\n";
  }
  return text;
}

/// Explains the marks that occur among the first entries.
std::string explained(const OpenList& list, std::size_t shown) {
  static constexpr std::array<std::pair<OpenTie, std::string_view>, 3> kMeanings{
      {{OpenTie::g, "g: same f as above; the larger g comes first\n"},
       {OpenTie::newest, "new: tied with the entry above; the newest comes first\n"},
       {OpenTie::chosen, "ties: same f as above; ordered as the planner's options say\n"}}};
  std::string text;
  for (const auto& [tie, meaning] : kMeanings) {
    const auto has = [tie = tie](const OpenEntry& entry) { return entry.tie == tie; };
    const auto last = list.entries.begin() + static_cast<std::ptrdiff_t>(shown);
    if (std::any_of(list.entries.begin(), last, has)) text += meaning;
  }
  return text;
}

std::string table(const OpenList& list, std::size_t shown, const Frame& frame) {
  const bool headings = !list.entries.empty() && list.entries.front().state.heading.has_value();
  std::vector<Row> rows{titles_of(headings)};
  for (std::size_t i = 0; i < shown; ++i) {
    rows.push_back(row_of(i + 1, list.entries[i], frame));
  }
  std::string text = fmt::format("open list: {}, next entry first\n", list.count) + aligned(rows);
  if (list.count > shown) text += fmt::format("{} more\n", list.count - shown);
  return text + explained(list, shown);
}

int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

void tell(const std::string& lines) { std::fwrite(lines.data(), 1, lines.size(), stderr); }

void Narrator::on_generate(const SearchEvent& event) {
  tell(reached_text("generate", event, frame_));
}

void Narrator::on_expand(const SearchEvent& event) {
  tell("expand " + event_text(event, frame_) + "\n");
}

void Narrator::on_relax(const SearchEvent& event) { tell(reached_text("relax", event, frame_)); }

std::string event_text(const SearchEvent& event, const Frame& frame) {
  return fmt::format("{} f={:.6g} g={:.6g} h={:.6g}", place_text(event.cell, event.heading, frame),
                     event.f, event.g, event.h);
}

std::string open_list_text(const OpenList& list, const Frame& frame, int rows) {
  if (list.count == 0) return "open list: empty\n";
  std::size_t shown = std::min<std::size_t>(list.entries.size(), kMostOpenEntries);
  std::string text = table(list, shown, frame);
  while (shown > 1 && lines_of(text) > rows) text = table(list, --shown, frame);
  return text;
}

}  // namespace wend::cli
