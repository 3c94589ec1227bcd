// A perfect maze: exactly one path between any two passages.

#include "wend/generate/chambers.hpp"
#include "wend/generate/generator_info.hpp"

namespace wend {
namespace {

struct MazeOptions {
  std::int64_t corridor_width = 1;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"corridor_width",
           "width of a corridor in cells; where the map's size does not fit, some corridors are "
           "wider"},
          self.corridor_width, {1, 1000});
  }

  MapSize least_size() const {
    const int side = static_cast<int>(corridor_width) + 2;
    return {side, side};
  }
};

GridMap generate(MapSize size, const MazeOptions& options, Random& random) {
  Chambers maze(size.width, size.height, static_cast<int>(options.corridor_width));
  for (const auto& [a, b] : random_spanning_tree(maze.columns(), maze.rows(), random)) {
    fill(maze.cells(), maze.wall_between(a, b), CellState::free);
  }
  return *make_grid_map(maze.cells());
}

}  // namespace

GeneratorInfo maze_generator() {
  return generator_info<MazeOptions>(
      "maze", "a perfect maze: exactly one path between any two places", generate);
}

}  // namespace wend
