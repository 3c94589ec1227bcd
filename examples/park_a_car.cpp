// Plans for a car: a shape, a least turning radius and a reverse gear. Prints the way from each change of gear to the
// next.
#include <cmath>
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return std::puts(loaded.error().message.c_str()), 2;
  const auto shape = wend::parse_footprint("0.5,0.2; 0.5,-0.2; -0.1,-0.2; -0.1,0.2");
  if (!shape) return std::puts(shape.error().message.c_str()), 2;
  wend::Session session(loaded->map, {.footprint = *shape});
  wend::PlanRequest request{{1, 1, 0}, {{{15, 9}, wend::kPi}}};
  request.planner = wend::planner_spec(wend::HybridAStarOptions{.turning_radius = 0.6});
  const auto answer = session.plan(request);
  if (!answer) return std::puts(answer.error().message.c_str()), 1;
  double leg = 0;
  const auto print = [&leg] {
    std::printf("%.1f m %s\n", std::abs(leg), leg < 0 ? "in reverse" : "ahead");
  };
  for (const wend::Segment& segment : answer->path().segments()) {
    if (leg * segment.length < 0) print(), leg = 0;
    leg += segment.length * loaded->map.frame().resolution;
  }
  print();
}
