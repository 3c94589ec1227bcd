// Makes a map from an occupancy buffer, row by row from the top, and plans on it.
#include <array>
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const std::array<const char*, 4> buffer{"........", "..####..", "..#..#..", "........"};
  wend::GridMapBuilder rows(8);
  for (const char* line : buffer) {
    std::array<wend::CellState, 8> row{};
    for (std::size_t x = 0; x < row.size(); ++x) {
      row[x] = line[x] == '#' ? wend::CellState::occupied : wend::CellState::free;
    }
    rows.append(row);
  }
  const auto map = std::move(rows).finish();
  if (!map) return std::puts(map.error().message.c_str()), 2;
  const auto space = wend::make_free_space(*map).value();
  const auto plan =
      wend::make_planner("astar", space).value()->plan(wend::Query::between({3, 2}, {3, 0}));
  if (!plan) return std::puts(plan.error().message.c_str()), 1;
  for (const wend::Cell cell : plan->path.cells()) std::printf("%d %d\n", cell.x, cell.y);
}
