#include "wend/render/terminal/ascii_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "wend/map/grid.hpp"
#include "wend/render/terminal/text_glyphs.hpp"

namespace wend {
namespace {

/// How many cells of a block are what.
struct Block {
  int cells = 0;
  int obstacles = 0;
  int unknown = 0;
  int too_close = 0;
  int rough = 0;

  char character(double columns_of_cells) const {
    // A thin wall through half of the block shows; a speck in a large block does not.
    if (obstacles > 0 && obstacles >= columns_of_cells / 2) return '#';
    if (2 * unknown > cells) return '?';
    if (2 * too_close > cells) return ':';
    return 2 * rough > cells ? '~' : '.';
  }
};

struct Mean {
  double sum = 0;
  int count = 0;

  void add(double share) {
    sum += share;
    ++count;
  }
  char digit() const {
    return static_cast<char>('0' + std::min(9, static_cast<int>(10 * sum / count)));
  }
};

/// A character covers `size` columns and 2 `size` rows of cells.
class AsciiCanvas {
 public:
  AsciiCanvas(const FreeSpace& space, double size)
      : space_(space),
        size_(size),
        columns_(blocks(space.width(), size)),
        rows_(blocks(space.height(), 2 * size)),
        characters_(columns_, rows_, '.') {}

  void draw_map() {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        characters_[{column, row}] = block(column, row).character(size_);
      }
    }
  }

  /// Digits for the mean heat of a block: 0 the least, 9 the greatest. Walls stay.
  void draw_heat(const Heatmap& heatmap) {
    const auto range = range_of(heatmap);
    if (!range) return;
    Grid<Mean> means(columns_, rows_);
    for (int y = 0; y < space_.height(); ++y) {
      for (int x = 0; x < space_.width(); ++x) {
        const double value = heatmap.values[{x, y}];
        if (!std::isfinite(value)) continue;
        if (const auto block = block_at(centre_of(Cell{x, y})))
          means[*block].add(range->share(value));
      }
    }
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        char& character = characters_[{column, row}];
        const Mean& mean = means[{column, row}];
        if (mean.count > 0 && character != '#') character = mean.digit();
      }
    }
  }

  /// A role shows wherever a cell of the block has it, but walls stay.
  void draw_roles(const Scene& scene) {
    for (const MarkedCells& marked : scene.marked) {
      const char character = glyph_of(marked.role).text.front();
      for (int y = 0; y < space_.height(); ++y) {
        for (int x = 0; x < space_.width(); ++x) {
          if (marked.cells[{x, y}]) put_unless_wall(centre_of(Cell{x, y}), character);
        }
      }
    }
  }

  void put(Point grid, char character) {
    if (const auto block = block_at(grid)) characters_[*block] = character;
  }

  /// `point_at(share)` gives the points of the line, from 0 to 1.
  template <class PointAt>
  void draw_line(double length, const PointAt& point_at, char character) {
    const auto pieces = 1 + static_cast<std::int64_t>(2 * length / size_);
    for (std::int64_t i = 0; i <= pieces; ++i) {
      put(point_at(static_cast<double>(i) / static_cast<double>(pieces)), character);
    }
  }

  void draw_path(const Path& path) {
    for (const Arc& arc : path.arcs()) {
      const auto point_at = [&](double share) { return pose_on(arc, share * arc.length).point(); };
      draw_line(std::abs(arc.length), point_at, arc.length < 0 ? '=' : 'o');
    }
  }

  void draw_points(const std::vector<Point>& points, char character) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point from = points[i - 1];
      const Point to = points[i];
      const auto point_at = [&](double share) {
        return Point{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
      };
      draw_line(distance(from, to), point_at, character);
    }
  }

  std::string text() const {
    std::string text;
    for (int row = 0; row < rows_; ++row) {
      const auto characters = characters_.row(row);
      text.append(characters.begin(), characters.end());
      text += '\n';
    }
    return text;
  }

 private:
  static int blocks(int cells, double size) {
    return std::max(1, static_cast<int>(std::ceil(cells / size - 1e-9)));
  }

  /// Corners on the far edges of the map belong to its last blocks.
  std::optional<Cell> block_at(Point grid) const {
    const double y = space_.map().frame().y_up ? space_.height() - grid.y : grid.y;
    if (!(grid.x >= 0 && y >= 0 && grid.x <= space_.width() && y <= space_.height())) {
      return std::nullopt;
    }
    return Cell{std::min(static_cast<int>(grid.x / size_), columns_ - 1),
                std::min(static_cast<int>(y / (2 * size_)), rows_ - 1)};
  }

  void put_unless_wall(Point grid, char character) {
    const auto block = block_at(grid);
    if (block && characters_[*block] != '#') characters_[*block] = character;
  }

  /// Blocks of fewer than one cell have one all the same.
  Block block(int column, int row) const {
    Block block;
    const int left = static_cast<int>(column * size_);
    const int right = std::clamp(static_cast<int>((column + 1) * size_), left + 1, space_.width());
    const int top = static_cast<int>(row * 2 * size_);
    const int bottom =
        std::clamp(static_cast<int>((row + 1) * 2 * size_), top + 1, space_.height());
    for (int drawn_y = top; drawn_y < bottom; ++drawn_y) {
      const int y = space_.map().frame().y_up ? space_.height() - 1 - drawn_y : drawn_y;
      for (int x = left; x < right; ++x) count({x, y}, block);
    }
    return block;
  }

  void count(Cell cell, Block& block) const {
    const CellState state = space_.map().state(cell);
    ++block.cells;
    block.obstacles += state == CellState::occupied;
    block.unknown += state == CellState::unknown;
    block.too_close += state == CellState::free && !space_.passable()[cell];
    block.rough += space_.map().terrain(cell) != 1;
  }

  const FreeSpace& space_;
  double size_;
  int columns_;
  int rows_;
  Grid<char> characters_;
};

}  // namespace

std::string ascii_picture(const Scene& scene, int columns, int rows) {
  const FreeSpace& space = scene.space;
  const double size = std::max({0.5, static_cast<double>(space.width()) / std::max(1, columns),
                                static_cast<double>(space.height()) / std::max(1, rows) / 2});
  AsciiCanvas canvas(space, size);
  canvas.draw_map();
  if (scene.heatmap) canvas.draw_heat(*scene.heatmap);
  canvas.draw_roles(scene);
  canvas.draw_path(scene.path);
  for (const SceneLine& line : scene.lines) {
    canvas.draw_points(line.points, ascii_of(glyph_of(line.role).text).front());
  }
  for (const ScenePlace& goal : scene.goals) canvas.put(goal.point, 'G');
  for (const Cell cell : scene.nearest_free) canvas.put(centre_of(cell), 'N');
  if (scene.start) canvas.put(scene.start->point, 'S');
  if (scene.robot) canvas.put(scene.robot->point(), 'R');
  if (scene.narrowest) canvas.put(*scene.narrowest, '!');
  if (scene.collision) canvas.put(*scene.collision, 'X');
  return canvas.text();
}

}  // namespace wend
