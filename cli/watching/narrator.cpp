#include "cli/watching/narrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "wend/geometry/car_move.hpp"
#include "wend/report/plan_report.hpp"

namespace wend::cli {
namespace {

std::string place_text(Cell cell, std::optional<Heading> heading) {
  constexpr bool kYUp = false;  // there and back: letters do not depend on it
  return heading ? corner_pose_text(pose_of({cell, *heading}, kYUp), kYUp) : cell_text(cell);
}

std::string from_text(const SearchEvent& event) {
  return event.parent ? " from " + place_text(*event.parent, event.parent_heading) : "";
}

std::string reached_text(std::string_view how, const SearchEvent& event) {
  return fmt::format("  {} {}{} f={:.6g} g={:.6g} h={:.6g}\n", how,
                     place_text(event.cell, event.heading), from_text(event), event.f, event.g,
                     event.h);
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

Row row_of(std::size_t rank, const OpenEntry& entry) {
  const SearchEvent& state = entry.state;
  Row row{std::to_string(rank), std::to_string(state.cell.x), std::to_string(state.cell.y)};
  if (state.heading) row.emplace_back(to_string(*state.heading));
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

/// What the marks mean that occur among the first entries.
std::string explained(const OpenList& list, std::size_t shown) {
  static constexpr std::array<std::pair<OpenTie, std::string_view>, 2> kMeanings{
      {{OpenTie::g, "g: same f as above; the larger g comes first\n"},
       {OpenTie::newest, "new: tied with the entry above; the newest comes first\n"}}};
  std::string text;
  for (const auto& [tie, meaning] : kMeanings) {
    const auto has = [tie = tie](const OpenEntry& entry) { return entry.tie == tie; };
    const auto last = list.entries.begin() + static_cast<std::ptrdiff_t>(shown);
    if (std::any_of(list.entries.begin(), last, has)) text += meaning;
  }
  return text;
}

std::string table(const OpenList& list, std::size_t shown) {
  const bool headings = !list.entries.empty() && list.entries.front().state.heading.has_value();
  std::vector<Row> rows{titles_of(headings)};
  for (std::size_t i = 0; i < shown; ++i) rows.push_back(row_of(i + 1, list.entries[i]));
  std::string text = fmt::format("open list: {}, next entry first\n", list.count) + aligned(rows);
  if (list.count > shown) text += fmt::format("{} more\n", list.count - shown);
  return text + explained(list, shown);
}

int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

void tell(const std::string& lines) { std::fwrite(lines.data(), 1, lines.size(), stderr); }

void Narrator::on_generate(const SearchEvent& event) { tell(reached_text("generate", event)); }

void Narrator::on_expand(const SearchEvent& event) { tell("expand " + event_text(event) + "\n"); }

void Narrator::on_relax(const SearchEvent& event) { tell(reached_text("relax", event)); }

std::string event_text(const SearchEvent& event) {
  return fmt::format("{} f={:.6g} g={:.6g} h={:.6g}", place_text(event.cell, event.heading),
                     event.f, event.g, event.h);
}

std::string open_list_text(const OpenList& list, int rows) {
  if (list.count == 0) return "open list: empty\n";
  std::size_t shown = std::min<std::size_t>(list.entries.size(), kMostOpenEntries);
  std::string text = table(list, shown);
  while (shown > 1 && lines_of(text) > rows) text = table(list, --shown);
  return text;
}

std::string open_list_text(const OpenList& list) {
  return open_list_text(list, std::numeric_limits<int>::max());
}

}  // namespace wend::cli
