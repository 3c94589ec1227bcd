// Smooths a path and simulates a robot that follows it. The path is planned for a larger robot, because no
// controller follows it exactly.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return std::puts(loaded.error().message.c_str()), 2;
  const auto space =
      wend::make_free_space(loaded->map, {.footprint = wend::Footprint::disc(0.2)}).value();
  const auto wide =
      wend::make_free_space(space.obstacles(), {.footprint = wend::Footprint::disc(0.3)}).value();
  const wend::Frame& frame = loaded->map.frame();
  const auto plan = wend::make_planner("astar", wide)
                        .value()
                        ->plan({frame.to_grid({1, 1, 0}), {frame.to_grid({15, 9, 0})}});
  if (!plan) return std::puts(plan.error().message.c_str()), 1;
  const auto smooth = wend::refined(plan->path, wide, {.smoother = wend::SmootherChoice{}});
  if (!smooth) return std::puts(smooth.error().message.c_str()), 1;
  const auto controller = wend::make_controller("pure_pursuit").value();
  const wend::Drive drive = wend::simulate(space, smooth->path, *controller);
  std::printf("%s after %.0f s and %.0f m\n", describe(drive.outcome).data(), drive.time,
              drive.distance);
}
