#pragma once

// What is behind a parsed path: a path file, with any bytes at all, is checked, measured, simplified, smoothed,
// resampled and timed. Whatever its numbers are, a function refuses it, or makes a path that is still one.

#include <array>
#include <string>
#include <string_view>

#include "checks.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/path/trajectory.hpp"

namespace wend::test {

/// A room with obstacles for a point, a disc and a polygon, closed or open at its edge.
inline const std::array<FreeSpace, 4>& rooms_of_fuzzed_paths() {
  static const auto room = [](const Footprint& footprint, OutsidePolicy outside) {
    return drawn_space("..........\n....#.....\n....#...#.\n..........\n.#........\n..........\n",
                       {.footprint = footprint, .outside = outside});
  };
  static const std::array<FreeSpace, 4> rooms{
      room({}, OutsidePolicy::blocked), room(Footprint::disc(0.4), OutsidePolicy::blocked),
      room(Footprint::disc(0.4), OutsidePolicy::free),
      room(*Footprint::polygon(*Polygon::make({{0.6, 0.3}, {0.6, -0.3}, {-0.4, 0}})),
           OutsidePolicy::blocked)};
  return rooms;
}

/// Calls check(path, space) for the path in a file, if there is one, in each room.
template <class Check>
std::string fuzz_path(std::string_view bytes, const Check& check) {
  const auto path = parse_path(bytes, kFuzzedFile, {}, PathStage::smoothed);
  if (!path) return check_error(path.error());
  if (fault_of(*path)) return "a path that was read has a fault";
  constexpr std::size_t kMostPoints = 40;  // for the speed of the fuzzer
  if (path->size() > kMostPoints) return {};
  for (const FreeSpace& room : rooms_of_fuzzed_paths()) {
    if (std::string wrong = check(*path, room); !wrong.empty()) return wrong;
  }
  return {};
}

/// A refusal says why; a path with a fault is refused.
template <class Answer>
std::string check_refusal(const Path& path, const FreeSpace& space, const Answer& answer) {
  if (!answer) return check_text(answer.error().message);
  return fault_of(path, space) ? "an answer to a path with a fault" : "";
}

template <class Made>
std::string check_made_path(const Path& path, const FreeSpace& space, const Made& made,
                            const Path& result) {
  if (std::string wrong = check_refusal(path, space, made); !wrong.empty()) return wrong;
  return fault_of(result) ? "a result with a fault" : "";
}

inline std::string fuzz_check(std::string_view bytes) {
  return fuzz_path(bytes, [](const Path& path, const FreeSpace& space) -> std::string {
    const auto exit = first_exit(path, space);
    const auto collision = first_collision(path, space);
    if (exit && !collision) return "a free path that leaves the map";
    if (exit && collision->along > exit->along + 1e-5) return "a collision behind the exit";
    if (fault_of(path, space) && !exit) return "a path far off the map that does not leave it";
    if (!collision) return {};
    constexpr double kRounding = 1e-6;
    const Point at = collision->point;
    const bool near = at.x >= -kRounding && at.x <= space.width() + kRounding &&
                      at.y >= -kRounding && at.y <= space.height() + kRounding;
    return near || collision->along == 0 ? "" : "a collision off the map";
  });
}

inline std::string fuzz_measure(std::string_view bytes) {
  return fuzz_path(bytes, [](const Path& path, const FreeSpace& space) -> std::string {
    const auto metrics = measure(path, space);
    if (std::string wrong = check_refusal(path, space, metrics); !wrong.empty()) return wrong;
    if (!metrics) return {};
    const bool sound = metrics->length >= 0 && metrics->turning >= 0 &&
                       metrics->smallest_turning_radius >= 0 &&
                       metrics->rounded_turning_radius >= 0 && metrics->smallest_clearance >= 0 &&
                       metrics->mean_clearance >= 0;
    return sound ? "" : "metrics that are NaN or negative";
  });
}

/// Without collinear points, pulled taut, within a tolerance; resampled; with rounded corners.
inline std::string fuzz_simplify(std::string_view bytes) {
  return fuzz_path(bytes, [](const Path& path, const FreeSpace& space) -> std::string {
    const bool free = !first_collision(path, space);
    for (const SimplifyBy by : {SimplifyBy::collinear, SimplifyBy::tolerance, SimplifyBy::sight}) {
      const auto made = refined(path, space, {.simplify = Simplification{by, 0.5}});
      const std::string wrong = check_made_path(path, space, made, made ? made->path : path);
      if (!wrong.empty()) return wrong;
      if (made && free && first_collision(made->path, space)) return "a free path is free no more";
    }
    return {};
  });
}

inline std::string fuzz_resample(std::string_view bytes) {
  return fuzz_path(bytes, [](const Path& path, const FreeSpace& space) -> std::string {
    const bool free = !first_collision(path, space);
    const auto even = resampled(path, 0.7, space);
    std::string wrong = check_made_path(path, space, even, even ? *even : path);
    if (!wrong.empty()) return wrong;
    if (even && free && !path.driven() && first_collision(*even, space)) {
      return "a free path is free no more";
    }
    const auto rounded = rounded_corners(path, space, 0.3);
    return check_made_path(path, space, rounded, rounded ? *rounded : path);
  });
}

/// By each smoother, with few sweeps.
inline std::string fuzz_smooth(std::string_view bytes) {
  return fuzz_path(bytes, [](const Path& path, const FreeSpace& space) -> std::string {
    for (const char* name : {"gradient", "curvature", "drive"}) {
      const auto smoother = make_smoother(name, {{"max_sweeps", "8"}});
      const auto made = (*smoother)(path, space);
      const std::string wrong = check_made_path(path, space, made, made ? made->path : path);
      if (!wrong.empty()) return std::string(name) + ": " + wrong;
      if (made && first_collision(made->path, space)) return std::string(name) + ": not free";
    }
    return {};
  });
}

inline std::string fuzz_trajectory(std::string_view bytes) {
  return fuzz_path(bytes, [](const Path& path, const FreeSpace& space) -> std::string {
    const auto trajectory = Trajectory::along(path, space.map().frame());
    if (!trajectory) return check_text(trajectory.error().message);
    const auto states = trajectory->samples(trajectory->duration() / 5);
    for (const TrajectoryState& state : states) {
      const bool finite = std::isfinite(state.pose.x) && std::isfinite(state.pose.y) &&
                          std::isfinite(state.pose.heading) && std::isfinite(state.turn_rate);
      if (!finite || !(std::abs(state.speed) <= trajectory->limits().speed * (1 + 1e-9))) {
        return "a state that is not finite, or too fast";
      }
    }
    return {};
  });
}

}  // namespace wend::test
