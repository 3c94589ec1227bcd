// The text picture of a scene whose places are corners: the corners that a car stands on and the cells between
// them.

#include <algorithm>
#include <cmath>

#include "wend/render/picture/layout.hpp"
#include "wend/render/style.hpp"
#include "wend/render/terminal/glyphs.hpp"

namespace wend {
namespace {

constexpr int kRowsACell = 2;
constexpr int kMostColumnsACell = 4;  // twice the rows: as wide as high
constexpr int kFewestColumnsACell = 2;
constexpr double kSamplesAUnit = 32;  // of an arc
constexpr double kMostSamples = 4096;

// By the quarters that are filled: 1 the upper left one, 2 the upper right, 4 and 8 those below.
constexpr std::array<std::string_view, 16> kQuarters{" ", "▘", "▝", "▀", "▖", "▌", "▞", "▛",
                                                     "▗", "▚", "▐", "▜", "▄", "▙", "▟", "█"};

int digits(int number) { return static_cast<int>(std::to_string(number).size()); }

/// How many cells of the lattice there are across and down. What is left over at the map's far edges
/// belongs to none.
Cell lattice_size(const Scene& scene) {
  const int unit = scene.places.spacing;
  return {scene.space.width() / unit, scene.space.height() / unit};
}

Glyph shade(double multiplier) {
  if (multiplier == 1) return {" ", Meaning::blank};
  const double rough = roughness(multiplier);
  return {rough < 1.0 / 3 ? "░" : rough < 2.0 / 3 ? "▒" : "▓", Meaning::rough_road};
}

/// A cell of the lattice, unit x unit cells of the map: an obstacle if any of them is, else what has a
/// role, else unknown if any is, too close if more than half of them are; else rough by their mean
/// terrain. In ASCII that has its digit.
Glyph block_glyph(const Scene& scene, Cell block, bool ascii) {
  const FreeSpace& space = scene.space;
  const int unit = scene.places.spacing;
  std::optional<CellRole> role;
  bool unknown = false;
  int too_close = 0;
  double terrain = 0;
  for (int y = unit * block.y; y < unit * (block.y + 1); ++y) {
    for (int x = unit * block.x; x < unit * (block.x + 1); ++x) {
      const CellState state = space.map().state({x, y});
      if (state == CellState::occupied) return {"#", Meaning::yard_obstacle};
      if (const auto of_cell = role_of(scene, {x, y})) role = of_cell;
      unknown = unknown || state == CellState::unknown;
      too_close += space.passable()[{x, y}] ? 0 : 1;
      terrain += space.map().terrain({x, y});
    }
  }
  const int cells = unit * unit;
  if (role) return glyph_of(*role, terrain != cells);
  if (unknown) return glyph_of(Meaning::unknown);
  if (2 * too_close > cells) return glyph_of(Meaning::too_close);
  const double mean = terrain / cells;
  if (ascii && mean != 1) return {glyph_of_terrain(mean).text, Meaning::rough_road};
  return shade(mean);
}

Grid<Glyph> lattice_cells(const Scene& scene, bool ascii) {
  const Cell size = lattice_size(scene);
  Grid<Glyph> cells(size.x, size.y);
  for (const Cell cell : every_cell(cells)) cells[cell] = block_glyph(scene, cell, ascii);
  return cells;
}

/// Which way a place's heading is drawn.
std::optional<Direction> drawn_heading(const ScenePlace& place, const RowOrder& order) {
  if (!place.heading) return std::nullopt;
  return order.direction(*place.heading);
}

class LatticePicture {
 public:
  LatticePicture(const Scene& scene, int columns_a_cell, bool ascii)
      : scene_(scene),
        unit_(scene.places.spacing),
        cells_(lattice_cells(scene, ascii)),
        columns_a_cell_(columns_a_cell),
        ascii_(ascii),
        order_{cells_.height(), row_order(scene.space).y_up},
        columns_(cells_.width() * columns_a_cell + 1),
        rows_(cells_.height() * kRowsACell + 1),
        margins_(margins()),
        glyphs_(columns_ + margins_.across(), rows_ + margins_.down(), {" ", Meaning::blank}) {
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
    return {nearest(columns_a_cell_ * x, columns_), nearest(kRowsACell * order_.down(y), rows_)};
  }

  bool on_lattice(Cell character) const {
    return character.x >= 0 && character.y >= 0 && character.x < columns_ && character.y < rows_;
  }

  /// Numbers of rows at the left, of columns beside row 0; and room for headings at the edges.
  Margins margins() const {
    const int numbers = digits(scene_.space.height());
    Margins margins{.left = numbers + 1, .right = 1 + digits(scene_.space.width()) / 2};
    (order_.y_up ? margins.bottom : margins.top) = 1;
    const auto make_room = [&](const ScenePlace& marked) {
      const auto heading = drawn_heading(marked, order_);
      const Cell at = character_at(marked.point);
      if (!heading || !on_lattice(at)) return;
      const int row = step(at, *heading).y;
      if (row < 0) margins.top = order_.y_up ? 1 : 2;
      if (row >= rows_) margins.bottom = order_.y_up ? 2 : 1;
    };
    if (scene_.start) make_room(*scene_.start);
    std::ranges::for_each(scene_.goals, make_room);
    return margins;
  }

  void put(Cell character, const Glyph& glyph) {
    glyphs_[{margins_.left + character.x, margins_.top + character.y}] = glyph;
  }

  void put_at(Point grid, const Glyph& glyph) {
    if (const Cell at = character_at(grid); on_lattice(at)) put(at, glyph);
  }

  void draw_cells() {
    for (const Cell cell : every_cell(cells_)) fill_cell(cell);
    for (const Cell at : CellRange(columns_, rows_)) {
      const unsigned quarters = blocked_quarters(at);
      if (quarters != 0) {
        put(at, {ascii_ ? "#" : kQuarters[quarters], Meaning::yard_obstacle});
      } else if (at.x % columns_a_cell_ == 0 && at.y % kRowsACell == 0) {
        put(at, glyph_of(Meaning::corner));
      }
    }
  }

  /// The characters between a cell's edges.
  void fill_cell(Cell cell) {
    const Cell corner{cell.x * columns_a_cell_, order_.row(cell.y) * kRowsACell};
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
      const Cell cell{x / (2 * columns_a_cell_), order_.row(y / (2 * kRowsACell))};
      if (!cells_.contains(cell) || cells_[cell].meaning != Meaning::yard_obstacle) continue;
      blocked |= 1U << quarter;
    }
    return blocked;
  }

  void draw_path() {
    GlyphLines lines(columns_, rows_, ascii_);
    for (const Arc& arc : scene_.path.arcs()) lines.add(way_of(arc), arc.length < 0);
    for (const Cell at : CellRange(columns_, rows_)) {
      if (const auto glyph = lines[at]) put(at, *glyph);
    }
    for (const Pose& pose : scene_.path.poses()) {
      put_at(pose.point(), arrow(order_.direction(pose.heading), Meaning::pose));
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
    if (scene_.narrowest) put_at(*scene_.narrowest, glyph_of(Meaning::narrowest));
    for (const ScenePlace& goal : scene_.goals) draw_mark(goal, glyph_of(Meaning::goal));
    if (scene_.start) draw_mark(*scene_.start, glyph_of(Meaning::start));
  }

  /// Its heading is an arrow beside it.
  void draw_mark(const ScenePlace& place, const Glyph& glyph) {
    put_at(place.point, glyph);
    const Cell at = character_at(place.point);
    const auto heading = drawn_heading(place, order_);
    if (heading && on_lattice(at)) put(step(at, *heading), arrow(*heading, glyph.meaning));
  }

  void draw_axes() {
    const int width = digits(scene_.space.width());
    const int step = round_step((width + 1.0) / columns_a_cell_);
    const int row = order_.y_up ? glyphs_.height() - 1 : 0;
    for (int x = 0; x <= cells_.width(); x += step) {
      const std::string number = std::to_string(x * unit_);
      const int centre = margins_.left + x * columns_a_cell_;
      write({centre - (static_cast<int>(number.size()) - 1) / 2, row}, number);
    }
    for (int y = 0; y <= cells_.height(); y += step) {
      const std::string number = std::to_string(y * unit_);
      const int first = margins_.left - 1 - static_cast<int>(number.size());
      write({first, margins_.top + kRowsACell * static_cast<int>(order_.down(y))}, number);
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
  RowOrder order_;  // of the lattice
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

}  // namespace

Grid<Glyph> lattice_glyphs(const Scene& scene, const TextStyle& style) {
  return LatticePicture(scene, columns_a_cell(scene, style.columns), style.ascii).glyphs();
}

bool lattice_fits(const Scene& scene, int columns, int rows) {
  return width_of(scene, kFewestColumnsACell) <= columns &&
         lattice_size(scene).y * kRowsACell + 2 <= rows;
}

}  // namespace wend
