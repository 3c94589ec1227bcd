#include "wend/render/terminal/lattice_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/render/picture/round_step.hpp"
#include "wend/render/terminal/lattice_cells.hpp"
#include "wend/render/terminal/lattice_lines.hpp"
#include "wend/render/terminal/text_rows.hpp"

namespace wend {
namespace {

constexpr int kRowsACell = 2;
constexpr int kMostColumnsACell = 4;  // twice the rows: as wide as high
constexpr int kFewestColumnsACell = 2;
constexpr double kSamplesAUnit = 32;  // of an arc
constexpr double kMostSamples = 4096;

// In the order of the legend, most interesting first.
constexpr std::array<TextLegendEntry, 17> kLatticeLegend{{
    {Meaning::start, "S start"},
    {Meaning::goal, "G goal"},
    {Meaning::pose, "→ pose", "> pose"},
    {Meaning::ahead, "─ driven ahead", "- driven ahead"},
    {Meaning::reverse, "═ in reverse", "= in reverse"},
    {Meaning::narrowest, "! narrowest"},
    {Meaning::current, "@ being expanded"},
    {Meaning::frontier, "+ frontier"},
    {Meaning::expanded, "* expanded"},
    {Meaning::expanded_rough, "% expanded, rough"},
    {Meaning::start_component, "s start's region"},
    {Meaning::goal_component, "g goal's region"},
    {Meaning::yard_obstacle, "█ obstacle", "# obstacle"},
    {Meaning::rough, "░▒▓ rough road", "~ 3-9 rough road"},
    {Meaning::too_close, ": too close for the robot"},
    {Meaning::unknown, "? unknown"},
    {Meaning::corner, "· corner", ". corner"},
}};

// By the quarters that are filled: 1 the upper left one, 2 the upper right, 4 and 8 those below.
constexpr std::array<std::string_view, 16> kQuarters{" ", "▘", "▝", "▀", "▖", "▌", "▞", "▛",
                                                     "▗", "▚", "▐", "▜", "▄", "▙", "▟", "█"};

int digits(int number) { return static_cast<int>(std::to_string(number).size()); }

/// Characters around the lattice.
struct Margins {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// Which way a place's heading is drawn.
std::optional<Cell> drawn_step(const ScenePlace& place, bool y_up) {
  if (!place.heading) return std::nullopt;
  return kDrawnSteps[static_cast<std::size_t>(nearest_direction(*place.heading, y_up))];
}

class LatticePicture {
 public:
  LatticePicture(const Scene& scene, int columns_a_cell, bool ascii)
      : scene_(scene),
        unit_(scene.unit.value_or(1)),
        cells_(lattice_cells(scene, ascii)),
        columns_a_cell_(columns_a_cell),
        ascii_(ascii),
        y_up_(scene.space.map().frame().y_up),
        columns_(cells_.width() * columns_a_cell + 1),
        rows_(cells_.height() * kRowsACell + 1),
        margins_(margins()),
        glyphs_(margins_.left + columns_ + margins_.right, margins_.top + rows_ + margins_.bottom,
                {" ", Meaning::free}) {
    draw_cells();
    draw_path();
    draw_marks();
    draw_axes();
  }

  const Grid<Glyph>& glyphs() const { return glyphs_; }

 private:
  /// The lattice's character nearest to a point. Those far outside are all as far outside.
  Cell character_at(Point grid) const {
    const double x = grid.x / unit_;
    const double y = grid.y / unit_;
    const auto nearest = [](double at, int most) {
      return static_cast<int>(std::lround(std::clamp<double>(at, -2, most + 2)));
    };
    return {nearest(columns_a_cell_ * x, columns_),
            nearest(kRowsACell * (y_up_ ? cells_.height() - y : y), rows_)};
  }

  bool on_lattice(Cell character) const {
    return character.x >= 0 && character.y >= 0 && character.x < columns_ && character.y < rows_;
  }

  /// Numbers of rows at the left, of columns beside row 0; and room for headings at the edges.
  Margins margins() const {
    const int numbers = digits(scene_.space.height());
    Margins margins{.left = numbers + 1, .right = 1 + digits(scene_.space.width()) / 2};
    (y_up_ ? margins.bottom : margins.top) = 1;
    const auto make_room = [&](const ScenePlace& marked) {
      const auto step = drawn_step(marked, y_up_);
      const Cell at = character_at(marked.point);
      if (!step || !on_lattice(at)) return;
      if (at.y + step->y < 0) margins.top = y_up_ ? 1 : 2;
      if (at.y + step->y >= rows_) margins.bottom = y_up_ ? 2 : 1;
    };
    if (scene_.start) make_room(*scene_.start);
    std::ranges::for_each(scene_.goals, make_room);
    return margins;
  }

  void put(Cell character, const Glyph& glyph) {
    glyphs_[{margins_.left + character.x, margins_.top + character.y}] = glyph;
  }

  Cell drawn_corner(Cell corner) const {
    return {corner.x * columns_a_cell_,
            (y_up_ ? cells_.height() - corner.y : corner.y) * kRowsACell};
  }

  void draw_cells() {
    for (int y = 0; y < cells_.height(); ++y) {
      for (int x = 0; x < cells_.width(); ++x) fill({x, y});
    }
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        const unsigned quarters = blocked_quarters({x, y});
        if (quarters != 0) {
          put({x, y}, {ascii_ ? "#" : kQuarters[quarters], Meaning::yard_obstacle});
        } else if (x % columns_a_cell_ == 0 && y % kRowsACell == 0) {
          put({x, y}, {"·", Meaning::corner});
        }
      }
    }
  }

  /// The characters between a cell's edges.
  void fill(Cell cell) {
    const Cell corner = drawn_corner({cell.x, y_up_ ? cell.y + 1 : cell.y});
    for (int y = 1; y < kRowsACell; ++y) {
      for (int x = 1; x < columns_a_cell_; ++x) {
        put({corner.x + x, corner.y + y}, cells_[cell]);
      }
    }
  }

  /// Corners and edges lie in the middle of their characters, so that each quarter of one lies in
  /// a cell: 1 for the upper left one, 2, 4 and 8 for the others, where that is an obstacle.
  unsigned blocked_quarters(Cell character) const {
    unsigned blocked = 0;
    for (unsigned quarter = 0; quarter < 4; ++quarter) {
      const int x = 2 * character.x + ((quarter & 1U) == 0 ? -1 : 1);
      const int y = 2 * character.y + ((quarter & 2U) == 0 ? -1 : 1);
      if (x < 0 || y < 0) continue;
      const int row = y / (2 * kRowsACell);
      const Cell cell{x / (2 * columns_a_cell_), y_up_ ? cells_.height() - 1 - row : row};
      if (!cells_.contains(cell) || cells_[cell].meaning != Meaning::yard_obstacle) continue;
      blocked |= 1U << quarter;
    }
    return blocked;
  }

  void draw_path() {
    LatticeLines lines(columns_, rows_, ascii_);
    for (const Arc& arc : scene_.path.arcs()) lines.add(way_of(arc), arc.length < 0);
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        if (const auto glyph = lines[{x, y}]) put({x, y}, *glyph);
      }
    }
    for (const Pose& pose : scene_.path.poses()) {
      const Cell at = character_at(pose.point());
      if (on_lattice(at)) put(at, arrow(nearest_direction(pose.heading, y_up_), Meaning::pose));
    }
  }

  std::vector<Cell> way_of(const Arc& arc) const {
    std::vector<Cell> way;
    const double wanted = std::ceil(kSamplesAUnit * std::abs(arc.length) / unit_);
    const auto pieces = static_cast<int>(std::clamp(wanted, 1.0, kMostSamples));
    for (int i = 0; i <= pieces; ++i) {
      const Cell at = character_at(pose_on(arc, arc.length * i / pieces).point());
      if (way.empty() || at != way.back()) way.push_back(at);
    }
    return way;
  }

  void draw_marks() {
    if (scene_.narrowest) {
      const Cell at = character_at(*scene_.narrowest);
      if (on_lattice(at)) put(at, {"!", Meaning::narrowest});
    }
    for (const ScenePlace& goal : scene_.goals) draw_mark(goal, {"G", Meaning::goal});
    if (scene_.start) draw_mark(*scene_.start, {"S", Meaning::start});
  }

  /// Its heading is an arrow beside it.
  void draw_mark(const ScenePlace& place, const Glyph& glyph) {
    const Cell at = character_at(place.point);
    if (!on_lattice(at)) return;
    put(at, glyph);
    const auto step = drawn_step(place, y_up_);
    if (step && place.heading) {
      put({at.x + step->x, at.y + step->y},
          arrow(nearest_direction(*place.heading, y_up_), glyph.meaning));
    }
  }

  void draw_axes() {
    const int width = digits(scene_.space.width());
    const int step = round_step((width + 1.0) / columns_a_cell_);
    const int row = y_up_ ? glyphs_.height() - 1 : 0;
    for (int x = 0; x <= cells_.width(); x += step) {
      const std::string number = std::to_string(x * unit_);
      const int centre = margins_.left + x * columns_a_cell_;
      write({centre - (static_cast<int>(number.size()) - 1) / 2, row}, number);
    }
    for (int y = 0; y <= cells_.height(); y += step) {
      const std::string number = std::to_string(y * unit_);
      write({margins_.left - 1 - static_cast<int>(number.size()),
             margins_.top + drawn_corner({0, y}).y},
            number);
    }
  }

  void write(Cell first, std::string_view number) {
    static constexpr std::string_view kDigits = "0123456789";
    for (const char digit : number) {
      glyphs_[first] = {kDigits.substr(static_cast<std::size_t>(digit - '0'), 1), Meaning::axis};
      ++first.x;
    }
  }

  const Scene& scene_;
  int unit_;
  Grid<Glyph> cells_;
  int columns_a_cell_;
  bool ascii_;
  bool y_up_;
  int columns_;
  int rows_;
  Margins margins_;
  Grid<Glyph> glyphs_;
};

/// Of the whole picture.
int width_of(const Scene& scene, int columns_a_cell) {
  return digits(scene.space.height()) + 1 + lattice_size(scene).x * columns_a_cell + 1 + 1 +
         digits(scene.space.width()) / 2;
}

/// As wide as fits.
int columns_a_cell(const Scene& scene, int columns) {
  for (int wide = kMostColumnsACell; wide > kFewestColumnsACell; --wide) {
    if (width_of(scene, wide) <= columns) return wide;
  }
  return kFewestColumnsACell;
}

std::span<const Glyph> without_trailing_blanks(std::span<const Glyph> row) {
  while (!row.empty() && row.back().text == " ") row = row.first(row.size() - 1);
  return row;
}

}  // namespace

std::string lattice_picture(const Scene& scene, const TextStyle& style) {
  const LatticePicture picture(scene, columns_a_cell(scene, style.columns), style.ascii);
  const Grid<Glyph>& glyphs = picture.glyphs();
  std::string text;
  for (int y = 0; y < glyphs.height(); ++y) {
    append_row(text, without_trailing_blanks(glyphs.row(y)), style);
  }
  if (style.legend) append_legend(text, glyphs, kLatticeLegend, style);
  return text;
}

bool lattice_fits(const Scene& scene, int columns, int rows) {
  return width_of(scene, kFewestColumnsACell) <= columns &&
         lattice_size(scene).y * kRowsACell + 2 <= rows;
}

}  // namespace wend
