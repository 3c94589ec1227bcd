#include "wend/jump/jump_sources.hpp"

#include <algorithm>

namespace wend {
namespace {

bool is_along_x(Direction straight) {
  return kDirectionSteps[static_cast<std::size_t>(straight)].y == 0;
}

int distance_back_to_stop(const JumpBoards& boards, Direction ahead, Cell from) {
  const auto [line, at] = line_place(ahead, from, boards.height());
  const BitLines& stops = boards.stops(ahead);
  return leads_ahead(ahead) ? stops.distance_back(line, at) : stops.distance_ahead(line, at);
}

}  // namespace

Cell JumpSources::Stretches::end(std::size_t line) const {
  using enum Direction;
  const int i = static_cast<int>(line);
  switch (ahead) {
    case plus_x:
      return {box.end.x - 1, box.begin.y + i};
    case minus_x:
      return {box.begin.x, box.begin.y + i};
    case plus_y:
      return {box.begin.x + i, box.end.y - 1};
    default:
      return {box.begin.x + i, box.begin.y};
  }
}

bool JumpSources::Stretches::contains(Cell cell) const {
  const int line = is_along_x(ahead) ? cell.y - box.begin.y : cell.x - box.begin.x;
  if (line < 0 || line >= static_cast<int>(lengths.size())) return false;
  const Cell last = end(static_cast<std::size_t>(line));
  const Cell way = kDirectionSteps[static_cast<std::size_t>(ahead)];
  const int before = (last.x - cell.x) * way.x + (last.y - cell.y) * way.y;
  return before >= 0 && before < lengths[static_cast<std::size_t>(line)];
}

/// Adds the jumps of a jump point from which a search goes on in a direction.
void JumpSources::add(Cell cell, Direction towards) {
  if (!graph_->is_jump_point(cell)) return;
  const std::uint32_t number = graph_->number_of(cell);
  for (unsigned arrival = 0; arrival < kArrivals; ++arrival) {
    const Jump jump(number, arrival);
    if ((graph_->directions(jump) & set_of(towards)) != 0) jumps_.push_back(jump);
  }
}

void JumpSources::add_all(const CellBox& around) {
  for (int y = around.begin.y; y < around.end.y; ++y) {
    for (int x = around.begin.x; x < around.end.x; ++x) {
      if (!graph_->is_jump_point({x, y})) continue;
      const std::uint32_t number = graph_->number_of({x, y});
      for (unsigned arrival = 0; arrival < kArrivals; ++arrival) {
        jumps_.emplace_back(number, arrival);
      }
    }
  }
}

/// The cells from which straight runs reach the box, from the last stop before it on.
JumpSources::Stretches JumpSources::stretches(Direction ahead, const CellBox& around) const {
  const bool along_x = is_along_x(ahead);
  Stretches found{ahead, around, {}};
  const int lines = along_x ? around.height() : around.width();
  const int across = along_x ? around.width() : around.height();
  for (int line = 0; line < lines; ++line) {
    const Cell first = step(found.end(static_cast<std::size_t>(line)), ahead, 1 - across);
    int before = distance_back_to_stop(graph_->boards(), ahead, first);
    if (!CellBox::of(graph_->boards()).contains(step(first, ahead, -before))) --before;
    found.lengths.push_back(across + before);
  }
  return found;
}

bool JumpSources::take_steps(std::size_t steps) {
  if (steps > steps_left_) return false;
  steps_left_ -= steps;
  return true;
}

/// Goes back along a diagonal from each cell of the stretches. False if the steps run out.
bool JumpSources::go_back(const Stretches& stretches, Direction diagonal) {
  const JumpBoards& boards = graph_->boards();
  const CellBox map = CellBox::of(boards);
  const auto steps_to = [&](Cell cell) {
    return map.contains(cell) &&
           (stretches.box.contains(cell) || (boards.moves(cell) & set_of(diagonal)) != 0);
  };
  for (std::size_t line = 0; line < stretches.lengths.size(); ++line) {
    const Cell end = stretches.end(line);
    for (int i = 0; i < stretches.lengths[line]; ++i) {
      Cell at = step(end, stretches.ahead, -i);
      // The way back from the neighbour passes here.
      if (stretches.contains(step(at, diagonal, 1)) && steps_to(at)) continue;
      std::size_t steps = 1;
      for (at = step(at, diagonal, -1); steps_to(at); at = step(at, diagonal, -1)) {
        add(at, diagonal);
        ++steps;
      }
      if (!take_steps(steps)) return false;
    }
  }
  return true;
}

/// Adds the jumps that run into a box in a direction, at once or after a diagonal.
bool JumpSources::add_before(Direction ahead, const CellBox& around) {
  const Stretches found = stretches(ahead, around);
  for (std::size_t line = 0; line < found.lengths.size(); ++line) {
    for (int i = 0; i < found.lengths[line]; ++i) add(step(found.end(line), ahead, -i), ahead);
  }
  const auto [one, other] = beside(ahead);
  return go_back(found, one) && go_back(found, other);
}

bool JumpSources::find(std::span<const CellBox> boxes) {
  jumps_.clear();
  for (const CellBox& box : boxes) {
    const CellBox around = box.grown_by(1).clipped_to(graph_->boards());
    add_all(around);
    for (const Direction ahead : kStraightDirections) {
      if (!add_before(ahead, around)) return false;
    }
  }
  remove_repeated();
  return true;
}

bool JumpSources::find_before(Jump jump) {
  jumps_.clear();
  const Cell cell = graph_->cell(jump.number());
  if (!add_before(static_cast<Direction>(2 * jump.arrival()), {cell, {cell.x + 1, cell.y + 1}})) {
    return false;
  }
  remove_repeated();
  return true;
}

void JumpSources::remove_repeated() {
  std::ranges::sort(jumps_, {}, &Jump::code);
  const auto repeated = std::ranges::unique(jumps_);
  jumps_.erase(repeated.begin(), repeated.end());
}

}  // namespace wend
