// Loads a map, plans in metres for a disc, and prints the path.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return std::puts(loaded.error().message.c_str()), 2;
  wend::Session session(loaded->map, {.footprint = wend::Footprint::disc(0.2)});
  const auto answer = session.plan({{1, 1, 0}, {{{15, 6.8}}}});
  if (!answer) return std::puts(answer.error().message.c_str()), 1;
  for (const wend::MapPose& pose : answer->poses()) std::printf("%.2f %.2f\n", pose.x, pose.y);
}
