// Explains why there is no path, and which changes would open one.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto map = wend::parse_map("..#...\n.....#\n..#...\n..#...\n", "map.txt");
  if (!map) return std::puts(map.error().message.c_str()), 2;
  wend::Session session(map->map, {.footprint = wend::Footprint::disc(0.8)});
  const auto answer = session.plan({{0.5, 0.5, 0}, {{{4.5, 3.5}}}});
  if (!answer) std::puts(answer.error().message.c_str());
  const auto why = session.why_no_path({0.5, 0.5}, {4.5, 3.5});
  for (const wend::Way& way : why->ways) {
    std::printf("%s%s%sa robot with a radius of %.2f cells passes\n",
                way.unknown_free ? "unknown cells free: " : "",
                way.squeeze ? "between corners: " : "", way.smaller_robot ? "smaller: " : "",
                way.widest.radius);
  }
}
