#pragma once

// How a car moves, by numbers alone: gear and steering wheel, integrated in small steps. It shares
// no code with the moves of wend, which tests check with it. Right and left are as drawn.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string_view>
#include <tuple>
#include <vector>

#include "conformance/reference.hpp"
#include "wend/geometry/pose.hpp"

namespace wend::test {

/// A unit straight on, or a quarter of a circle whose radius is one unit.
struct Maneuver {
  std::string_view name;
  int gear;   // 1 ahead, -1 in reverse
  int wheel;  // turned to the right: 1, to the left: -1, held straight: 0

  double length() const { return wheel == 0 ? 1 : std::numbers::pi / 2; }  // units
};

inline constexpr std::array<Maneuver, 6> kManeuvers{{{"FWD", 1, 0},
                                                     {"REV", -1, 0},
                                                     {"FWD_RIGHT", 1, 1},
                                                     {"FWD_LEFT", 1, -1},
                                                     {"REV_RIGHT", -1, 1},
                                                     {"REV_LEFT", -1, -1}}};

/// A lattice: how many map cells a unit has, and which way is up.
struct Scale {
  int unit = 1;
  bool y_up = false;

  friend auto operator<=>(const Scale&, const Scale&) = default;
};

/// After driving a little way, by Simpson's rule.
inline Pose nudged(const Pose& from, double length, double curvature) {
  const double middle = from.heading + curvature * length / 2;
  const double end = from.heading + curvature * length;
  const double x = (std::cos(from.heading) + 4 * std::cos(middle) + std::cos(end)) / 6;
  const double y = (std::sin(from.heading) + 4 * std::sin(middle) + std::sin(end)) / 6;
  return {from.x + length * x, from.y + length * y, end};
}

/// A maneuver in map cells: its poses, kSteps + 1 of them, in equal steps.
struct SampledDrive {
  static constexpr int kSteps = 32;

  SampledDrive(const Pose& from, const Maneuver& maneuver, const Scale& scale)
      : step(maneuver.gear * maneuver.length() * scale.unit / kSteps),
        curvature((scale.y_up ? -1.0 : 1.0) * maneuver.wheel / scale.unit),
        poses{from} {
    for (int i = 0; i < kSteps; ++i) poses.push_back(nudged(poses.back(), step, curvature));
  }

  double step;       // negative in reverse
  double curvature;  // positive where the heading turns from +x to +y while driving ahead
  std::vector<Pose> poses;
};

/// From the nearest point of a drive to a square: around the best of its poses by ternary search.
inline double distance_to_square(const SampledDrive& drive, Cell square) {
  const auto at = [&](double steps) {
    const auto before = std::min(static_cast<std::size_t>(steps), drive.poses.size() - 1);
    const double rest = (steps - static_cast<double>(before)) * drive.step;
    const Pose pose = nudged(drive.poses[before], rest, drive.curvature);
    return distance_to_square(pose.x, pose.y, square);
  };
  constexpr double kPrecision = 1e-6;  // steps: of distances, near their least, it is the square
  double least = kInfinite;
  for (int i = 0; i <= SampledDrive::kSteps; ++i) {
    double low = std::max(i - 1, 0);
    double high = std::min(i + 1, SampledDrive::kSteps);
    const double here = at(i);
    least = std::min(least, here);
    if (here > at(low) || here > at(high)) continue;
    while (high - low > kPrecision) {
      const double third = (high - low) / 3;
      if (at(low + third) <= at(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    least = std::min(least, at((low + high) / 2));
  }
  return least;
}

/// Where a car stands: a corner of its lattice, and how many quarter turns from +x towards +y it
/// faces, 0 to 3.
struct Stand {
  Cell corner;
  int quarter = 0;

  friend bool operator==(const Stand&, const Stand&) = default;
};

/// What a maneuver does from the origin, read off a drive. In lattice coordinates.
struct Effect {
  Cell by;
  int quarter;  // afterwards
  Cell right;   // the cell on the right of the way's middle; of a turn the swept one
  Cell left;    // the cell on the left of it; of a turn the swept one, too
};

inline int nearest_quarter(double heading) {
  return static_cast<int>(std::lround(heading / (std::numbers::pi / 2))) & 3;
}

inline Effect effect_of(int quarter, const Maneuver& maneuver, bool y_up) {
  const SampledDrive drive({0, 0, quarter * std::numbers::pi / 2}, maneuver, {1, y_up});
  const Pose& end = drive.poses.back();
  const Pose& middle = drive.poses[SampledDrive::kSteps / 2];
  const auto beside = [&](double by) {  // a hair to the right, or to the left
    const double side = middle.heading + (y_up ? -1 : 1) * std::numbers::pi / 2;
    return Cell{static_cast<int>(std::floor(middle.x + by * std::cos(side))),
                static_cast<int>(std::floor(middle.y + by * std::sin(side)))};
  };
  return {{static_cast<int>(std::lround(end.x)), static_cast<int>(std::lround(end.y))},
          nearest_quarter(end.heading),
          beside(1e-3),
          beside(-1e-3)};
}

/// From a maneuver that begins in the origin to a square of a map cell. Remembers its answers.
inline double distance_to_square(int quarter, const Maneuver& maneuver, const Scale& scale,
                                 Cell square) {
  static std::map<std::tuple<int, std::string_view, Scale, Cell>, double> known;
  const auto [entry, is_new] = known.try_emplace({quarter, maneuver.name, scale, square}, 0);
  if (is_new) {
    const SampledDrive drive({0, 0, quarter * std::numbers::pi / 2}, maneuver, scale);
    entry->second = distance_to_square(drive, square);
  }
  return entry->second;
}

}  // namespace wend::test
