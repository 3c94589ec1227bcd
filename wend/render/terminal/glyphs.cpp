#include "wend/render/terminal/glyphs.hpp"

#include <algorithm>
#include <bitset>
#include <cstdlib>
#include <ranges>

namespace wend {
namespace {

constexpr std::array<std::string_view, kDirections> kArrows{"↓", "↘", "→", "↗", "↑", "↖", "←", "↙"};

/// How a meaning looks, and what the legend calls it.
struct MeaningText {
  Meaning meaning;
  std::string_view colour{};  // parameters of an ANSI sequence
  std::string_view character{};
  std::string_view label{};
};

// In colours of the terminal's own palette, so that they suit light and dark ones: 31 red, 32 green,
// 33 yellow, 35 purple, 36 cyan, 90 grey, 94 bright blue; 1 is bold. Plain blue cannot be read on black: a path is
// white (97) on it (44).
constexpr std::array<MeaningText, kMeanings> kMeaningTexts{{
    {Meaning::start, "1;32", "S", "start"},
    {Meaning::goal, "1;31", "G", "goal"},
    {Meaning::path, "1;97;44", "→", "path"},
    {Meaning::pose, "1;94", "→", "pose"},
    {Meaning::ahead, "1;94", "─", "driven ahead"},
    {Meaning::reverse, "1", "═", "in reverse"},
    {Meaning::planned_line, "31", "○", "planned"},
    {Meaning::smoothed_line, "1;32", "●", "smoothed"},
    {Meaning::driven_line, "1;94", "◆", "driven"},
    {Meaning::possible_line, "1;94", "◇", "possible path"},
    {Meaning::robot, "1;94", "R", "robot"},
    {Meaning::collision, "1;35", "✗", "collision"},
    {Meaning::narrowest, "1;35", "!", "narrowest"},
    {Meaning::nearest_free, "1;35", "N", "nearest free cell"},
    {Meaning::current, "1;35", "@", "being expanded"},
    {Meaning::frontier, "94", "+", "frontier"},
    {Meaning::expanded, "36", "*", "expanded"},
    {Meaning::expanded_rough, "36", "%", "expanded, rough"},
    {Meaning::start_component, "32", "s", "start's component"},
    {Meaning::goal_component, "31", "g", "goal's component"},
    {Meaning::move, "", "→", "way to move"},
    {Meaning::obstacle, "", "#", "obstacle"},
    {Meaning::yard_obstacle, "31", "█", "obstacle"},
    {Meaning::rough_road, "33", "░▒▓", "rough road"},
    {Meaning::too_close, "35", ":", "too close for the robot"},
    {Meaning::unknown, "90", "?", "unknown"},
    {Meaning::rough, "33", "~ 3-9", "rough"},
    {Meaning::free, "90", ".", "free"},
    {Meaning::corner, "90", "·", "corner"},
    {Meaning::axis, "90"},
    {Meaning::blank, "90"},
}};
static_assert(std::ranges::is_sorted(kMeaningTexts, {}, &MeaningText::meaning));

const MeaningText& look_of(Meaning meaning) {
  return kMeaningTexts[static_cast<std::size_t>(meaning)];
}

/// A line may have a label of its own.
std::string_view label_of(Meaning meaning, const Scene& scene) {
  for (const SceneLine& line : scene.lines | std::views::reverse) {
    if (glyph_of(line.role).meaning == meaning && !line.label.empty()) return line.label;
  }
  return look_of(meaning).label;
}

constexpr unsigned bit(Direction direction) { return 1U << static_cast<unsigned>(direction); }

/// The straight directions alone, as a number from 0 to 15: 1 down, 2 right, 4 up, 8 left.
constexpr std::size_t straight(unsigned joins) {
  return (joins & 1U) | (joins >> 1U & 2U) | (joins >> 2U & 4U) | (joins >> 3U & 8U);
}

// By the straight directions.
constexpr std::array<std::string_view, 16> kLight{" ", "│", "─", "╭", "│", "│", "╰", "├",
                                                  "─", "╮", "─", "┬", "╯", "┤", "┴", "┼"};
constexpr std::array<std::string_view, 16> kDouble{" ", "║", "═", "╔", "║", "║", "╚", "╠",
                                                   "═", "╗", "═", "╦", "╝", "╣", "╩", "╬"};

std::string_view ascii_line(unsigned joins) {
  const bool across = (joins & (bit(Direction::plus_x) | bit(Direction::minus_x))) != 0;
  const bool down = (joins & (bit(Direction::plus_y) | bit(Direction::minus_y))) != 0;
  if (across && down) return "+";
  if (across) return "-";
  if (down) return "|";
  const bool falls =
      (joins & (bit(Direction::plus_x_plus_y) | bit(Direction::minus_x_minus_y))) != 0;
  const bool rises =
      (joins & (bit(Direction::plus_x_minus_y) | bit(Direction::minus_x_plus_y))) != 0;
  if (falls && rises) return "X";
  return falls ? "\\" : "/";
}

/// Every step to one of the four neighbours.
std::vector<Cell> connected(const std::vector<Cell>& way) {
  const auto next = [](int from, int to) { return from + (from < to ? 1 : -1); };
  std::vector<Cell> steps;
  for (const Cell to : way) {
    if (steps.empty()) steps.push_back(to);
    while (steps.back() != to) {
      const auto [x, y] = steps.back();
      steps.push_back(x != to.x ? Cell{next(x, to.x), y} : Cell{x, next(y, to.y)});
    }
  }
  return steps;
}

/// Two steps around a corner become one across.
std::vector<Cell> thinned(const std::vector<Cell>& steps) {
  std::vector<Cell> thin;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool ends = thin.empty() || i + 1 == steps.size();
    const bool turns = !ends && std::abs(steps[i + 1].x - thin.back().x) == 1 &&
                       std::abs(steps[i + 1].y - thin.back().y) == 1;
    if (!turns) thin.push_back(steps[i]);
  }
  return thin;
}

std::span<const Glyph> without_trailing_blanks(std::span<const Glyph> row) {
  while (!row.empty() && row.back().text == " ") row = row.first(row.size() - 1);
  return row;
}

void append_row(std::string& text, std::span<const Glyph> row, const TextStyle& style) {
  std::string_view colour;
  for (const Glyph& glyph : row) {
    const std::string_view wanted = style.colours ? look_of(glyph.meaning).colour : "";
    if (wanted != colour) {
      if (!colour.empty()) text += kAnsiReset;
      if (!wanted.empty()) text.append("\x1b[").append(wanted).append("m");
      colour = wanted;
    }
    text += style.ascii ? ascii_of(glyph.text) : glyph.text;
  }
  if (!colour.empty()) text += kAnsiReset;
  text += '\n';
}

std::string text_legend(const Grid<Glyph>& glyphs, const Scene& scene, const TextStyle& style) {
  std::bitset<kMeanings> seen;
  for (const Glyph& glyph : glyphs.values()) seen.set(static_cast<std::size_t>(glyph.meaning));
  std::vector<std::string> entries;
  for (const auto& [meaning, colour, character, label] : kMeaningTexts) {
    if (!seen.test(static_cast<std::size_t>(meaning)) || label.empty()) continue;
    const bool coloured = style.colours && !colour.empty();
    std::string& entry = entries.emplace_back();
    if (coloured) entry.append("\x1b[").append(colour).append("m");
    entry += style.ascii ? ascii_of(character) : character;
    entry.append(" ").append(label_of(meaning, scene));
    if (coloured) entry += kAnsiReset;
  }
  return in_lines(entries, style.columns) + '\n';
}

}  // namespace

Glyph glyph_of_terrain(double multiplier) {
  static constexpr std::array<std::string_view, 7> kDigits{"3", "4", "5", "6", "7", "8", "9"};
  if (multiplier == 1) return glyph_of(Meaning::free);
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    if (multiplier == static_cast<double>(i + 3)) return {kDigits[i], Meaning::rough};
  }
  return {"~", Meaning::rough};
}

Glyph glyph_of(const FreeSpace& space, Cell cell) {
  const CellState state = space.map().state(cell);
  if (state == CellState::occupied) return glyph_of(Meaning::obstacle);
  if (state == CellState::unknown) return glyph_of(Meaning::unknown);
  if (!space.passable(cell)) return glyph_of(Meaning::too_close);
  return glyph_of_terrain(space.map().terrain(cell));
}

Glyph arrow(Direction direction, Meaning meaning) {
  return {kArrows[static_cast<std::size_t>(direction)], meaning};
}

std::string_view ascii_of(std::string_view character) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kAscii{
      {{"↓", "v"},
       {"↘", "\\"},
       {"→", ">"},
       {"↗", "/"},
       {"↑", "^"},
       {"↖", "\\"},
       {"←", "<"},
       {"↙", "/"},
       {"·", "."},
       {"○", "o"},
       {"●", "%"},
       {"◆", "&"},
       {"◇", "-"},
       {"✗", "X"},
       {"─", "-"},
       {"═", "="},
       {"█", "#"},
       {"░▒▓", "~ 3-9"}}};
  for (const auto& [text, ascii] : kAscii) {
    if (text == character) return ascii;
  }
  return character;
}

Glyph glyph_of(Meaning meaning) { return {look_of(meaning).character, meaning}; }

Glyph glyph_of(CellRole role, bool on_rough_ground) {
  static constexpr std::array<Meaning, kCellRoles> kMeaning{
      Meaning::expanded, Meaning::frontier, Meaning::current, Meaning::start_component,
      Meaning::goal_component};
  if (on_rough_ground && role == CellRole::expanded) return glyph_of(Meaning::expanded_rough);
  return glyph_of(kMeaning[static_cast<std::size_t>(role)]);
}

Glyph glyph_of(LineRole role) {
  static constexpr std::array<Meaning, kLineRoles> kMeaning{
      Meaning::planned_line, Meaning::smoothed_line, Meaning::driven_line, Meaning::possible_line};
  return glyph_of(kMeaning[static_cast<std::size_t>(role)]);
}

Grid<Glyph> glyphs_of(const FreeSpace& space) {
  Grid<Glyph> glyphs(space.width(), space.height());
  for (const Cell cell : every_cell(glyphs)) glyphs[cell] = glyph_of(space, cell);
  return glyphs;
}

void put_arrows(const Scene& scene, Grid<Glyph>& glyphs) {
  if (!scene.arrows) return;
  for (const Cell cell : every_cell(glyphs)) {
    const auto direction = (*scene.arrows)[cell];
    if (!direction || glyphs[cell].meaning == Meaning::obstacle) continue;
    glyphs[cell] = arrow(row_order(scene.space).direction(*direction), Meaning::move);
  }
}

void put_marks(const Scene& scene, Grid<Glyph>& glyphs) {
  const auto put = [&](Point point, Meaning meaning) {
    if (const auto cell = cell_under(scene.space, point)) glyphs[*cell] = glyph_of(meaning);
  };
  if (scene.narrowest) put(*scene.narrowest, Meaning::narrowest);
  for (const Cell cell : scene.nearest_free) put(centre_of(cell), Meaning::nearest_free);
  if (scene.start) put(scene.start->point, Meaning::start);
  for (const ScenePlace& goal : scene.goals) put(goal.point, Meaning::goal);
  if (scene.robot) put(scene.robot->point(), Meaning::robot);
  if (scene.collision) put(*scene.collision, Meaning::collision);
}

void GlyphLines::add(const std::vector<Cell>& way, bool reverse) {
  std::vector<Cell> steps = connected(way);
  if (ascii_) steps = thinned(steps);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    join(steps[i - 1], steps[i], reverse);
    join(steps[i], steps[i - 1], reverse);
  }
}

void GlyphLines::join(Cell from, Cell to, bool reverse) {
  if (!joins_.contains(from) || !joins_.contains(to)) return;
  Joins& joins = joins_[from];
  std::uint8_t& way = reverse ? joins.reverse : joins.ahead;
  way = static_cast<std::uint8_t>(way | bit(nearest_direction(from, to)));
}

std::optional<Glyph> GlyphLines::operator[](Cell character) const {
  const Joins& joins = joins_[character];
  const unsigned all = joins.ahead | joins.reverse;
  if (all == 0) return std::nullopt;
  if (joins.reverse != 0) {  // the rarer one shows where both drive
    return Glyph{ascii_ ? "=" : kDouble[straight(all)], Meaning::reverse};
  }
  return Glyph{ascii_ ? ascii_line(all) : kLight[straight(all)], Meaning::ahead};
}

std::string as_text(const Grid<Glyph>& glyphs, const RowOrder& order, const Scene& scene,
                    const TextStyle& style) {
  std::string text;
  for (int n = 0; n < glyphs.height(); ++n) {
    append_row(text, without_trailing_blanks(glyphs.row(order.row(n))), style);
  }
  if (style.legend) text += text_legend(glyphs, scene, style);
  return text;
}

}  // namespace wend
