#include "wend/report/drive_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <string_view>
#include <vector>

#include "wend/geometry/car_move.hpp"
#include "wend/geometry/heading.hpp"

namespace wend {

std::string corner_pose_text(const Pose& pose, bool y_up) {
  return fmt::format("({},{},{})", pose.x, pose.y, to_string(nearest_heading(pose.heading, y_up)));
}

std::string drive_commands(const Plan& plan, bool y_up) {
  if (plan.path.empty()) return {};
  const std::vector<Pose> poses = plan.path.poses();
  assert(plan.path.driven() && plan.moves.size() + 1 == poses.size());
  std::string text = "Start " + corner_pose_text(poses.front(), y_up) + "\n";
  for (std::size_t i = 0; i < plan.moves.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "Go {} -> {}\n", plan.moves[i],
                   corner_pose_text(poses[i + 1], y_up));
  }
  return text;
}

std::size_t steps_in_reverse(const Plan& plan) {
  const auto count = std::ranges::count_if(plan.moves, [](std::string_view name) {
    const auto move = car_move_from_string(name);
    return move && is_reverse(*move);
  });
  return static_cast<std::size_t>(count);
}

}  // namespace wend
