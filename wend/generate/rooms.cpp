// Square rooms in rows and columns, with doors one cell wide.

#include "wend/generate/chambers.hpp"
#include "wend/generate/generator_info.hpp"

namespace wend {
namespace {

struct RoomsOptions {
  std::int64_t room_size = 8;
  double loops = 0.4;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"room_size",
           "size of a room in cells; where the map's size does not fit, some rooms are larger"},
          self.room_size, {1, 1000});
    field({"loops",
           "proportion of walls with a redundant door: with 0 there is exactly one way between any "
           "two rooms"},
          self.loops, {0, 1});
  }

  MapSize least_size() const { return {3, 3}; }
};

/// Makes a door at a random place in a wall that has none.
void open_door(Grid<CellState>& cells, const Block& wall, Random& random) {
  const int x = random.between(wall.x, wall.x_end() - 1);
  const int y = random.between(wall.y, wall.y_end() - 1);
  if (all_equal(cells, wall, CellState::occupied)) cells[{x, y}] = CellState::free;
}

GridMap generate(MapSize size, const RoomsOptions& options, Random& random) {
  Chambers rooms(size.width, size.height, static_cast<int>(options.room_size));
  for (const auto& [a, b] : random_spanning_tree(rooms.columns(), rooms.rows(), random)) {
    open_door(rooms.cells(), rooms.wall_between(a, b), random);
  }
  for (const Cell room : CellRange(rooms.columns(), rooms.rows())) {
    for (const Cell next : {Cell{room.x + 1, room.y}, Cell{room.x, room.y + 1}}) {
      if (next.x == rooms.columns() || next.y == rooms.rows()) continue;
      if (random.chance(options.loops)) {
        open_door(rooms.cells(), rooms.wall_between(room, next), random);
      }
    }
  }
  return *make_grid_map(rooms.cells());
}

}  // namespace

GeneratorInfo rooms_generator() {
  return generator_info<RoomsOptions>(
      "rooms", "rooms in rows and columns with doors in their walls", generate);
}

}  // namespace wend
