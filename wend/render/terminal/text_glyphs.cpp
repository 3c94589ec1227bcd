#include "wend/render/terminal/text_glyphs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace wend {
namespace {

constexpr std::array<std::string_view, kDirections> kArrows{"↓", "↘", "→", "↗", "↑", "↖", "←", "↙"};
constexpr std::array<std::string_view, kDirections> kAsciiArrows{"v", "\\", ">", "/",
                                                                 "^", "\\", "<", "/"};

}  // namespace

Glyph glyph_of_terrain(double multiplier) {
  static constexpr std::array<std::string_view, 7> kDigits{"3", "4", "5", "6", "7", "8", "9"};
  if (multiplier == 1) return {".", Meaning::free};
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    if (multiplier == static_cast<double>(i + 3)) return {kDigits[i], Meaning::rough};
  }
  return {"~", Meaning::rough};
}

Glyph glyph_of(const FreeSpace& space, Cell cell) {
  switch (space.map().state(cell)) {
    case CellState::occupied:
      return {"#", Meaning::obstacle};
    case CellState::unknown:
      return {"?", Meaning::unknown};
    case CellState::free:
      break;
  }
  if (!space.passable(cell)) return {":", Meaning::too_close};
  return glyph_of_terrain(space.map().terrain(cell));
}

Glyph arrow(Direction direction, Meaning meaning) {
  return {kArrows[static_cast<std::size_t>(direction)], meaning};
}

std::string_view ascii_of(std::string_view character) {
  const auto* const found = std::ranges::find(kArrows, character);
  if (found != kArrows.end())
    return kAsciiArrows[static_cast<std::size_t>(found - kArrows.begin())];
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kOthers{
      {{"·", "."}, {"○", "o"}, {"●", "%"}, {"◆", "&"}, {"◇", "-"}, {"✗", "X"}}};
  for (const auto& [text, ascii] : kOthers) {
    if (text == character) return ascii;
  }
  return character;
}

Glyph glyph_of(CellRole role) {
  switch (role) {
    case CellRole::expanded:
      return {"*", Meaning::expanded};
    case CellRole::frontier:
      return {"+", Meaning::frontier};
    case CellRole::current:
      return {"@", Meaning::current};
    case CellRole::start_component:
      return {"s", Meaning::start_component};
    case CellRole::goal_component:
      return {"g", Meaning::goal_component};
  }
  return {};
}

Glyph glyph_on_rough_ground(CellRole role) {
  if (role == CellRole::expanded) return {"%", Meaning::expanded_rough};
  return glyph_of(role);
}

Glyph glyph_of(LineRole role) {
  switch (role) {
    case LineRole::planned:
      return {"○", Meaning::planned_line};
    case LineRole::smoothed:
      return {"●", Meaning::smoothed_line};
    case LineRole::driven:
      return {"◆", Meaning::driven_line};
    case LineRole::possible:
      return {"◇", Meaning::possible_line};
  }
  return {};
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

std::optional<Cell> cell_under(const FreeSpace& space, Point point) {
  // Written so that it also refuses numbers that are not finite.
  if (!(point.x >= 0 && point.y >= 0 && point.x < space.width() && point.y < space.height())) {
    return std::nullopt;
  }
  return Cell{static_cast<int>(point.x), static_cast<int>(point.y)};
}

void put_arrows(const Scene& scene, Grid<Glyph>& glyphs) {
  if (!scene.arrows) return;
  for (int y = 0; y < glyphs.height(); ++y) {
    for (int x = 0; x < glyphs.width(); ++x) {
      Glyph& glyph = glyphs[{x, y}];
      const auto direction = (*scene.arrows)[{x, y}];
      if (direction && glyph.meaning != Meaning::obstacle) glyph = arrow(*direction, Meaning::move);
    }
  }
}

void put_lines(const Scene& scene, Grid<Glyph>& glyphs) {
  constexpr double kSpacing = 0.25;  // cells
  for (const SceneLine& line : scene.lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Point from = line.points[i - 1];
      const Point to = line.points[i];
      const int pieces = std::max(1, static_cast<int>(std::ceil(distance(from, to) / kSpacing)));
      for (int k = 0; k <= pieces; ++k) {
        const double share = static_cast<double>(k) / pieces;
        const Point point{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
        if (const auto cell = cell_under(scene.space, point)) glyphs[*cell] = glyph_of(line.role);
      }
    }
  }
}

void put_marks(const Scene& scene, Grid<Glyph>& glyphs) {
  if (scene.narrowest) {
    if (const auto cell = cell_under(scene.space, *scene.narrowest)) {
      glyphs[*cell] = {"!", Meaning::narrowest};
    }
  }
  for (const Cell cell : scene.nearest_free) {
    if (glyphs.contains(cell)) glyphs[cell] = {"N", Meaning::nearest_free};
  }
  if (scene.start) {
    if (const auto cell = cell_under(scene.space, scene.start->point)) {
      glyphs[*cell] = {"S", Meaning::start};
    }
  }
  for (const ScenePlace& goal : scene.goals) {
    if (const auto cell = cell_under(scene.space, goal.point)) glyphs[*cell] = {"G", Meaning::goal};
  }
  if (scene.robot) {
    if (const auto cell = cell_under(scene.space, scene.robot->point())) {
      glyphs[*cell] = {"R", Meaning::robot};
    }
  }
  if (scene.collision) {
    if (const auto cell = cell_under(scene.space, *scene.collision)) {
      glyphs[*cell] = {"✗", Meaning::collision};
    }
  }
}

Grid<Glyph> glyphs_of(const FreeSpace& space) {
  Grid<Glyph> glyphs(space.width(), space.height());
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) glyphs[{x, y}] = glyph_of(space, {x, y});
  }
  return glyphs;
}

}  // namespace wend
