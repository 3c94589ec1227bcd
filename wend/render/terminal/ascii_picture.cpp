// A map of any size in few characters of ASCII: see ascii_picture() in terminal_picture.hpp.

#include <algorithm>
#include <cmath>

#include "wend/geometry/line.hpp"
#include "wend/render/heatmap.hpp"
#include "wend/render/terminal/glyphs.hpp"
#include "wend/render/terminal/terminal_picture.hpp"

namespace wend {
namespace {

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

int blocks(int cells, double size) {
  return std::max(1, static_cast<int>(std::ceil(cells / size - 1e-9)));
}

/// A character covers `size` columns and 2 `size` rows of cells.
class AsciiCanvas {
 public:
  AsciiCanvas(const FreeSpace& space, double size)
      : space_(space),
        size_(size),
        order_(row_order(space)),
        characters_(blocks(space.width(), size), blocks(space.height(), 2 * size)) {
    for (const Cell block : every_cell(characters_)) characters_[block] = map_character(block);
  }

  /// Digits for the mean heat of a block: 0 the least, 9 the greatest. Walls stay.
  void draw_heat(const Heatmap& heatmap) {
    const auto range = range_of(heatmap);
    if (!range) return;
    Grid<Mean> means(characters_.width(), characters_.height());
    for (const Cell cell : every_cell(space_)) {
      const double value = heatmap.values[cell];
      const auto block = block_at(centre_of(cell));
      if (block && std::isfinite(value)) means[*block].add(range->share(value));
    }
    for (const Cell block : every_cell(means)) {
      if (means[block].count > 0) put_unless_wall(block, means[block].digit());
    }
  }

  /// A role shows wherever a cell of the block has it, but walls stay.
  void draw_roles(const Scene& scene) {
    for (const MarkedCells& marked : scene.marked) {
      const char character = glyph_of(marked.role).text.front();
      for (const Cell cell : every_cell(space_)) {
        if (!marked.cells[cell]) continue;
        if (const auto block = block_at(centre_of(cell))) put_unless_wall(*block, character);
      }
    }
  }

  void put(Point grid, char character) {
    if (const auto block = block_at(grid)) characters_[*block] = character;
  }

  void draw_path(const Path& path) {
    for (const Arc& arc : path.arcs()) {
      const auto point_at = [&](double share) { return point_on(arc, share * arc.length); };
      draw_line(std::abs(arc.length), point_at, arc.length < 0 ? '=' : 'o');
    }
  }

  void draw_points(const std::vector<Point>& points, char character) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Line line{points[i - 1], points[i]};
      draw_line(line.length(), [&](double share) { return line.at(share); }, character);
    }
  }

  std::string text() const {
    std::string text;
    for (int row = 0; row < characters_.height(); ++row) {
      const auto characters = characters_.row(row);
      text.append(characters.begin(), characters.end()).push_back('\n');
    }
    return text;
  }

 private:
  /// Corners on the far edges of the map belong to its last blocks.
  std::optional<Cell> block_at(Point grid) const {
    const double y = order_.down(grid.y);
    if (!(grid.x >= 0 && y >= 0 && grid.x <= space_.width() && y <= space_.height())) {
      return std::nullopt;
    }
    return Cell{std::min(static_cast<int>(grid.x / size_), characters_.width() - 1),
                std::min(static_cast<int>(y / (2 * size_)), characters_.height() - 1)};
  }

  void put_unless_wall(Cell block, char character) {
    if (characters_[block] != '#') characters_[block] = character;
  }

  /// `point_at(share)` gives the points of the line, from 0 to 1.
  template <class PointAt>
  void draw_line(double length, const PointAt& point_at, char character) {
    const auto pieces = 1 + static_cast<std::int64_t>(2 * length / size_);
    for (std::int64_t i = 0; i <= pieces; ++i) {
      put(point_at(static_cast<double>(i) / static_cast<double>(pieces)), character);
    }
  }

  /// What most of a block is. Blocks of fewer than one cell have one all the same.
  char map_character(Cell block) const {
    const int left = static_cast<int>(block.x * size_);
    const int right = std::clamp(static_cast<int>((block.x + 1) * size_), left + 1, space_.width());
    const int top = static_cast<int>(block.y * 2 * size_);
    const int bottom =
        std::clamp(static_cast<int>((block.y + 1) * 2 * size_), top + 1, space_.height());
    int obstacles = 0;
    int unknown = 0;
    int too_close = 0;
    int rough = 0;
    for (int n = top; n < bottom; ++n) {
      for (int x = left; x < right; ++x) {
        const Cell cell{x, order_.row(n)};
        const CellState state = space_.map().state(cell);
        obstacles += state == CellState::occupied;
        unknown += state == CellState::unknown;
        too_close += state == CellState::free && !space_.passable()[cell];
        rough += space_.map().terrain(cell) != 1;
      }
    }
    const int cells = (right - left) * (bottom - top);
    // A thin wall through half of the block shows; a speck in a large block does not.
    if (obstacles > 0 && obstacles >= size_ / 2) return '#';
    if (2 * unknown > cells) return '?';
    if (2 * too_close > cells) return ':';
    return 2 * rough > cells ? '~' : '.';
  }

  const FreeSpace& space_;
  double size_;
  RowOrder order_;
  Grid<char> characters_;
};

}  // namespace

std::string ascii_picture(const Scene& scene, int columns, int rows) {
  const FreeSpace& space = scene.space;
  const double size = std::max({0.5, static_cast<double>(space.width()) / std::max(1, columns),
                                static_cast<double>(space.height()) / std::max(1, rows) / 2});
  AsciiCanvas canvas(space, size);
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
