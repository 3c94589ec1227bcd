#include "cli/output/plan_text.hpp"

#include <fmt/format.h>

#include <sys/resource.h>
#include <cmath>
#include <string_view>
#include <vector>

#include "wend/base/thread_time.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/session/shift_text.hpp"

namespace wend::cli {
namespace {

std::string named_line(std::string_view name, const std::string& what) {
  return fmt::format("{:<10}{}\n", name, what);
}

std::string length_text(double cells, const Frame& frame) {
  std::string text = fmt::format("{:.6g} cells", cells);
  if (frame.metric) text += fmt::format(", {:.6g} m", cells * frame.resolution);
  return text;
}

std::string bound_text(double bound) {
  if (bound == 1) return "optimal";
  if (std::isfinite(bound)) return fmt::format("at most {:g} times the optimum", bound);
  return "no guarantee: a cheaper path may exist";
}

std::string bound_text(const Plan& plan) { return bound_text(plan.bound); }

/// A line for each path of an anytime planner: when it came, its cost and bound.
std::string solution_lines(const PlanResult& result) {
  std::string text;
  for (const TimedSolution& solution : result.solutions) {
    text += named_line(
        text.empty() ? "paths" : "",
        fmt::format("after {:>9}, {:>8} expanded: cost {:.6g}, {}", time_text(solution.seconds),
                    solution.expanded, solution.cost, bound_text(solution.bound)));
  }
  return text;
}

std::string one_of(std::size_t goals) { return fmt::format("one of {} goals", goals); }

/// "18: 10 turns, 2 in reverse"; for a drive mostly in reverse, also how to get another.
std::string steps_text(const Plan& plan) {
  int turns = 0;
  for (const std::string_view name : plan.moves) {
    const bool aside = name.starts_with("SIDE");
    turns += !aside && (name.ends_with("_LEFT") || name.ends_with("_RIGHT")) ? 1 : 0;
  }
  const std::size_t reverse = steps_in_reverse(plan);
  const bool mostly = 2 * reverse > plan.moves.size();
  return fmt::format("{}: {} {}, {} in reverse{}", plan.moves.size(), turns,
                     turns == 1 ? "turn" : "turns", reverse,
                     mostly ? " (--reverse-factor makes these cost more)" : "");
}

/// "0.4 m, 8 cells"
std::string radius_text(int radius, const Coordinates& coordinates) {
  const std::string cells = fmt::format("{} {}", radius, radius == 1 ? "cell" : "cells");
  return coordinates.metric() ? fmt::format("{}, {}", coordinates.length(radius), cells) : cells;
}

/// Where a drive begins or ends, if the steps do not say everything about it.
std::string end_line(std::string_view name, const Pose& pose, const SnappingError& error,
                     std::size_t ends, const Coordinates& coordinates) {
  std::vector<std::string> remarks;
  if (ends > 1) remarks.push_back(one_of(ends));
  if (auto shifted = shift_text(error, coordinates); !shifted.empty()) {
    remarks.push_back(std::move(shifted));
  }
  if (remarks.empty()) return {};
  return named_line(name, fmt::format("{}, {}", pose_text(pose, coordinates.frame_of_texts()),
                                      fmt::join(remarks, ", ")));
}

/// "map 1.20 ms, free space 540.0 us, planner 3.2 us"
std::string preparation_text(const WorkTimes& times) {
  std::string text =
      fmt::format("map {}, free space {}", time_text(times.load), time_text(times.free_space));
  if (times.index) text += ", index " + time_text(*times.index);
  if (times.planner) text += ", planner " + time_text(*times.planner);
  return text;
}

/// The most physical memory that this process held at a time.
double most_megabytes() {
  constexpr double kKilobytes = 1024;  // what getrusage() counts in
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * kKilobytes / 1e6;
}

/// What was done where the robot cannot be; empty for most queries.
std::string eased_lines(const PlanResult& result, const Frame& frame) {
  std::string text;
  if (result.lead_out) {
    const std::string length = length_text(result.lead_out->length / frame.resolution, frame);
    text += named_line("lead out", length + ", before the first free place");
  }
  if (result.remaining) {
    text += named_line("remaining", *result.remaining == 0
                                        ? "0, a goal is reached"
                                        : length_text(*result.remaining / frame.resolution, frame) +
                                              " to the nearest goal, which no path reaches");
  }
  return text;
}

/// "(1,1)>(2,1)>(3,1)" and a line end
std::string path_line(const Path& path, const Frame& frame) {
  std::string text;
  const auto append = [&text](const std::string& joint) {
    if (!text.empty()) text += '>';
    text += joint;
  };
  if (path.leads_over_cells()) {
    for (const Cell cell : path.passed_cells()) append(cell_text(cell));
    return text + '\n';
  }
  for (const Point point : path.waypoints()) {
    const MapPoint at = frame.metric ? frame.to_metres(point) : MapPoint{point.x, point.y};
    append(fmt::format("{:.4g},{:.4g}", at.x, at.y));
  }
  return text + '\n';
}

/// Which of several goals was reached.
std::string goal_line(const std::string& goal, std::size_t goals) {
  return named_line("goal", fmt::format("{}, {}", goal, one_of(goals)));
}

/// How far the ends of a path of cells are from what was asked; empty if they are there.
std::string shift_line(const PlanResult& result, const Coordinates& coordinates) {
  // A goal that no path reaches has a line of its own.
  const SnappingError goal =
      result.remaining.value_or(0) > 0 ? SnappingError{} : result.plan.goal_snapping_error;
  const std::string shifts = shifts_text(result.plan.start_snapping_error, goal, coordinates);
  return shifts.empty() ? shifts : named_line("ends", "in the middles of cells: " + shifts);
}

/// That a planner without headings used the disc around the robot's polygon; empty for any other robot.
std::string robot_line(const PlanResult& result) {
  return result.planned_as_disc.empty() ? "" : named_line("robot", result.planned_as_disc);
}

std::string cells_summary(const PlanResult& result, const Frame& frame) {
  const Plan& plan = result.plan;
  return named_line("planner", result.planner) +
         named_line("cost", fmt::format("{:.6g}", plan.cost)) +
         named_line("length", length_text(plan.path.length(), frame)) + eased_lines(result, frame) +
         named_line("quality", bound_text(plan)) + solution_lines(result) + work_line(plan.metrics);
}

std::string drive_summary(const PlanResult& result, const Coordinates& coordinates,
                          std::size_t goals) {
  const Plan& plan = result.plan;
  const std::vector<Pose> poses = plan.path.poses();
  const Frame& frame = coordinates.frame();
  return end_line("start", poses.front(), plan.start_snapping_error, 1, coordinates) +
         end_line("goal", poses.back(), plan.goal_snapping_error, goals, coordinates) +
         named_line("planner", result.planner) + named_line("steps", steps_text(plan)) +
         (result.places.on_corners()
              ? named_line("turns in", radius_text(result.places.spacing, coordinates))
              : "") +
         named_line(result.cost_name, fmt::format("{:.6g}", plan.cost)) +
         named_line("length", length_text(plan.path.length(), frame)) + eased_lines(result, frame) +
         named_line("quality", bound_text(plan)) + solution_lines(result) +
         work_line(plan.metrics, fmt::format("of {} states", result.states));
}

}  // namespace

std::string time_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.1f} us", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.2f} ms", seconds * 1e3);
  return fmt::format("{:.2f} s", seconds);
}

std::string plan_steps(const PlanResult& result, const Coordinates& coordinates, bool small) {
  constexpr std::size_t kMostCommands = 400;
  if (!result.capabilities.headings) {
    return small ? path_line(result.plan.path, coordinates.frame()) : "";
  }
  if (!result.places.on_corners() && result.plan.moves.size() > kMostCommands) return "";
  return drive_commands(result.plan, coordinates.frame_of_texts());
}

std::string plan_summary(const PlanResult& result, const Coordinates& coordinates,
                         std::size_t goals) {
  if (result.capabilities.headings) {
    return robot_line(result) + drive_summary(result, coordinates, goals);
  }
  const std::string end = coordinates.text(cell_at(result.plan.path.points().back()));
  return (goals > 1 ? goal_line(end, goals) : "") + shift_line(result, coordinates) +
         robot_line(result) + cells_summary(result, coordinates.frame());
}

std::string work_line(const SearchMetrics& metrics, const std::string& states) {
  return named_line("expanded",
                    fmt::format("{} {} ({} generated, frontier up to {})", metrics.expanded, states,
                                metrics.generated, metrics.max_frontier));
}

std::string times_lines(const WorkTimes& times) {
  return named_line("time", fmt::format("{} to search, {} in all ({})", time_text(times.search),
                                        time_text(times.preparation() + times.search),
                                        thread_time_name())) +
         named_line("before", preparation_text(times)) +
         named_line("memory", fmt::format("{:.1f} MB at most, of the process", most_megabytes()));
}

std::string collision_text(const PathCollision& collision, const Coordinates& coordinates) {
  std::string text = fmt::format("after {}, at {}, it {}", coordinates.length(collision.along),
                                 coordinates.text(collision.point), describe(collision.kind));
  if (collision.obstacle) {
    text += fmt::format(": the one at {}", coordinates.text(centre_of(*collision.obstacle)));
  }
  return text;
}

std::string not_free_text(const PathCollision& collision, const Coordinates& coordinates) {
  return "the path is not free: " + collision_text(collision, coordinates);
}

}  // namespace wend::cli
