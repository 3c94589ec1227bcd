#pragma once

// Drives what a planner found: by gear and steering wheel alone, step by step, looking at the ground
// under every step.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "tests/testing/car_reference.hpp"
#include "wend/planner/plan.hpp"

namespace wend::test {

class CarSimulator {
 public:
  explicit CarSimulator(const CarReference& reference) : reference_(reference) {}

  /// What is wrong with a plan; empty if nothing is. The car is never put back on a corner.
  std::string fault(const Plan& plan) {
    const std::vector<Pose> poses = plan.path.poses();
    if (poses.empty()) return "no poses";
    if (plan.moves.size() + 1 != poses.size()) return "moves are not one fewer than poses";
    car_ = poses.front();
    fuel_ = 0;
    expect_on_corner(poses.front(), 0);
    for (std::size_t i = 0; i < plan.moves.size() && what_.str().empty(); ++i) {
      drive(plan.moves[i]);
      expect_at(poses[i + 1], i + 1);
      expect_on_corner(poses[i + 1], i + 1);
    }
    if (!(std::abs(fuel_ - plan.cost) <= kRelative * std::max(1.0, plan.cost))) {
      what_ << "; it needs " << fuel_ << " fuel, not " << plan.cost;
    }
    return what_.str();
  }

 private:
  static constexpr double kRelative = 1e-9;
  static constexpr double kNear = 1e-5;  // cells, after a long drive

  void drive(std::string_view name) {
    const auto maneuver = std::find_if(kManeuvers.begin(), kManeuvers.end(),
                                       [&](const Maneuver& m) { return m.name == name; });
    if (maneuver == kManeuvers.end()) {
      what_ << "; there is no move " << name;
      return;
    }
    const SampledDrive way(car_, *maneuver, reference_.scale());
    for (const Pose& pose : way.poses) expect_room(pose);
    for (const Pose& pose : way.poses) {
      if (&pose == &way.poses.back()) break;
      const Pose middle = nudged(pose, way.step / 2, way.curvature);
      const double length = std::abs(way.step) / reference_.rules().unit;
      fuel_ += length * ground(middle, *maneuver) *
               (maneuver->gear < 0 ? reference_.rules().reverse_factor : 1);
    }
    car_ = way.poses.back();
  }

  /// The multiplier of the lattice cell that a turning car is in, or of the two beside it.
  double ground(const Pose& pose, const Maneuver& maneuver) {
    if (maneuver.wheel == 0) {
      return reference_.straight_multiplier(beside(pose, 1e-3), beside(pose, -1e-3));
    }
    const Cell cell = beside(pose, 0);
    if (reference_.blocked(cell)) what_ << "; it sweeps a blocked cell";
    return reference_.terrain(cell).value_or(kInfinite);
  }

  Cell beside(const Pose& pose, double by) const {
    const int unit = reference_.rules().unit;
    return {static_cast<int>(std::floor((pose.x - by * std::sin(pose.heading)) / unit)),
            static_cast<int>(std::floor((pose.y + by * std::cos(pose.heading)) / unit))};
  }

  void expect_room(const Pose& pose) {
    const GridMap& map = reference_.map();
    if (distance_to_interval(0, map.width(), pose.x) > kNear ||
        distance_to_interval(0, map.height(), pose.y) > kNear) {
      what_ << "; it leaves the map";
    }
    const Cell cell{static_cast<int>(std::floor(pose.x)), static_cast<int>(std::floor(pose.y))};
    const bool clear = reference_.kept_clear(
        cell, [&](Cell square) { return distance_to_square(pose.x, pose.y, square) + kNear; });
    if (!clear) what_ << "; it touches an obstacle at " << pose.x << "," << pose.y;
  }

  void expect_at(const Pose& pose, std::size_t i) {
    if (std::hypot(car_.x - pose.x, car_.y - pose.y) > kNear ||
        std::cos(car_.heading - pose.heading) < 1 - kNear) {
      what_ << "; after " << i << " moves it is at " << car_.x << "," << car_.y << ","
            << car_.heading << ", not " << pose.x << "," << pose.y << "," << pose.heading;
    }
  }

  /// Poses are exactly on passable corners of the lattice, headings exact quarters in (-pi, pi].
  void expect_on_corner(const Pose& pose, std::size_t i) {
    const auto stand = reference_.nearest(pose);
    constexpr double kPi = std::numbers::pi;
    const bool exact = stand && reference_.pose(*stand).point() == pose.point() &&
                       std::abs(std::remainder(pose.heading, kPi / 2)) < 1e-15 &&
                       pose.heading > -kPi && pose.heading <= kPi;
    if (!exact || !reference_.passable(stand->corner)) {
      what_ << "; pose " << i << " is on no passable corner";
    }
  }

  const CarReference& reference_;
  Pose car_;
  double fuel_ = 0;
  std::ostringstream what_;
};

inline std::string fault_of(const Plan& plan, const CarReference& reference) {
  return CarSimulator(reference).fault(plan);
}

}  // namespace wend::test
