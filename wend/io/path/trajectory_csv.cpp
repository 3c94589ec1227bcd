#include "wend/io/path/trajectory_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "wend/base/parse.hpp"
#include "wend/io/path/path_csv.hpp"

namespace wend {
namespace {

constexpr std::string_view kTrajectoryHeader = "t,x,y,heading,v,w";

}  // namespace

std::string trajectory_csv(const Trajectory& trajectory, double period) {
  std::string text = fmt::format("{}\n", kTrajectoryHeader);
  for (const TrajectoryState& state : trajectory.samples(period)) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", format_number(state.time),
                   format_number(state.pose.x), format_number(state.pose.y),
                   format_number(state.pose.heading), format_number(state.speed),
                   format_number(state.turn_rate));
  }
  return text;
}

std::string no_trajectory_csv(const FailedPlan& plan) {
  return no_path_csv(plan, kTrajectoryHeader);
}

}  // namespace wend
