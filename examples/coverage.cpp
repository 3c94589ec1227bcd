// Covers a room: a path on which a tool passes over every place that it can reach.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto map = wend::parse_map(
      "####################\n"
      "#..................#\n"
      "#..................#\n"
      "#......####........#\n"
      "#......####........#\n"
      "#..................#\n"
      "#..................#\n"
      "####################\n",
      "room.txt");
  if (!map) return std::puts(map.error().message.c_str()), 2;
  const auto space = wend::make_free_space(map->map, {.footprint = wend::Footprint::disc(0.5)});
  if (!space) return std::puts(space.error().message.c_str()), 2;
  const auto coverage =
      wend::plan_coverage(*space, {.tool_width = 2, .start = wend::Point{1.5, 1.5}});
  if (!coverage) return std::puts(coverage.error().message.c_str()), 1;
  std::printf("%.1f %% covered\n", 100 * coverage->covered_share);
  std::printf("%zu of %zu cells\n", coverage->covered.count(), coverage->wanted.count());
  for (const wend::MissedPlace& place : wend::missed_places(*space, *coverage, 1)) {
    std::printf("missed: %zu cells at (%d,%d)\n", place.cells, place.cell.x, place.cell.y);
  }
}
