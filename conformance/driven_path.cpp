#include "conformance/driven_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "conformance/placed_shape.hpp"

namespace wend::test {
namespace {

constexpr double kStraight = 1e-9;  // a change of heading that is none
constexpr double kNoWay = 1e-9;     // a distance that is none, in cells
constexpr double kAside = 1e-5;     // a course, in radians, that is none: positions are rounded

double angle_between(double from, double to) {
  return std::remainder(to - from, 2 * std::numbers::pi);
}

/// How two poses are joined: an arc whose chord has the direction that the car has half-way.
struct Motion {
  Pose from;
  double turn;        // radians
  double length = 0;  // cells, negative in reverse
  double course = 0;  // radians, of the motion against the heading

  Motion(const Pose& begin, const Pose& end)
      : from(begin), turn(angle_between(begin.heading, end.heading)) {
    const double dx = end.x - begin.x;
    const double dy = end.y - begin.y;
    const double chord = std::sqrt(dx * dx + dy * dy);
    if (chord < kNoWay) return;
    const double half = std::abs(turn) / 2;
    length = half < kStraight ? chord : chord * half / std::sin(half);
    course = angle_between(begin.heading + turn / 2, std::atan2(dy, dx));
    if (std::abs(course) <= std::numbers::pi / 2) return;
    length = -length;
    course = angle_between(std::numbers::pi, course);
  }

  double radius() const { return std::abs(length / turn); }
  bool is_arc() const { return std::abs(turn) >= kStraight; }

  Pose at(double share) const {
    const double heading = from.heading + turn * share;
    const double begin = from.heading + course;
    const double way = length * share;
    if (!is_arc() || length == 0) {
      return {from.x + way * std::cos(begin), from.y + way * std::sin(begin), heading};
    }
    const double signed_radius = length / turn;
    const double end = begin + turn * share;
    return {from.x + signed_radius * (std::sin(end) - std::sin(begin)),
            from.y - signed_radius * (std::cos(end) - std::cos(begin)), heading};
  }
};

std::string text_of(const Pose& pose) {
  return fmt::format("({:.4f},{:.4f},{:.4f})", pose.x, pose.y, pose.heading);
}

/// What a motion does that it may not; empty if nothing.
std::string broken_rule(const Motion& motion, const DriveRules& rules) {
  if (motion.length == 0) {
    return !motion.is_arc() || rules.turns_in_place
               ? ""
               : fmt::format("turns in place by {:.4f} rad", motion.turn);
  }
  if (std::abs(motion.course) > kAside && !rules.moves_aside) {
    return fmt::format("moves {:.4f} rad aside of its heading", motion.course);
  }
  if (motion.length < 0 && !rules.reverses) return "drives in reverse";
  // The length that the turn takes at least. Of a very short arc, rounded coordinates change the radius.
  const double least_length = std::abs(motion.turn) * rules.turning_radius;
  constexpr double kRelative = 1e-6;
  constexpr double kRounding = 1e-11;  // cells
  if (motion.is_arc() && std::abs(motion.length) < least_length * (1 - kRelative) - kRounding) {
    return fmt::format("turns by {:.3g} rad with a radius of {:.9g}, less than {:.9g}", motion.turn,
                       motion.radius(), rules.turning_radius);
  }
  return "";
}

/// Where the shape overlaps something along a motion; empty if nowhere.
std::string collision_along(const Motion& motion, PlacedShape& shape, double step) {
  // The farthest corner of a robot moves by more than its base point; a turn in place counts as 10 cells a rad.
  const double way =
      std::abs(motion.length) + (motion.length == 0 ? 10 * std::abs(motion.turn) : 0);
  const int steps = std::max(1, static_cast<int>(std::ceil(way / step)));
  for (int i = 0; i <= steps; ++i) {
    const Pose pose = motion.at(static_cast<double>(i) / steps);
    if (const auto cell = shape.overlapped_at(pose)) {
      return fmt::format("at {} overlaps the cell ({},{})", text_of(pose), cell->x, cell->y);
    }
  }
  return "";
}

std::string fault_of_ends(const Pose& first, const Pose& last, const Query& query,
                          double tolerance) {
  const auto is_near = [&](const Pose& pose, Point point, std::optional<double> heading,
                           double away, double turned) {
    return std::hypot(pose.x - point.x, pose.y - point.y) <= away + tolerance &&
           (!heading || std::abs(angle_between(*heading, pose.heading)) <= turned + tolerance);
  };
  if (!is_near(first, query.start.point(), query.start.heading, 0, 0)) {
    return fmt::format("begins at {} and not at {}", text_of(first), text_of(query.start));
  }
  const bool arrives = std::ranges::any_of(query.goals, [&](const Goal& goal) {
    return is_near(last, goal.point, goal.heading, goal.tolerance, goal.heading_tolerance);
  });
  return arrives ? "" : fmt::format("ends at {}, which is not a goal", text_of(last));
}

void note(const Motion& motion, double& gear, DriveReport& report) {
  report.length += std::abs(motion.length);
  if (motion.length == 0) return;
  if (motion.length < 0) report.reversed -= motion.length;
  if (motion.length * gear < 0) ++report.gear_changes;
  gear = motion.length;
  if (motion.is_arc()) report.least_radius = std::min(report.least_radius, motion.radius());
}

}  // namespace

DriveReport checked_drive(const FreeSpace& space, const Path& path, const Query& query,
                          const DriveRules& rules) {
  DriveReport report;
  report.least_radius = std::numeric_limits<double>::infinity();
  const auto poses = path.driven_poses();
  if (poses.empty()) {
    report.fault = "has no poses";
    return report;
  }
  report.fault = fault_of_ends(poses.front(), poses.back(), query, rules.end_tolerance);
  PlacedShape shape(space, rules.depth);
  double gear = 0;
  for (std::size_t i = 0; i + 1 < poses.size() || i == 0; ++i) {
    const Motion motion(poses[i], poses[std::min(i + 1, poses.size() - 1)]);
    note(motion, gear, report);
    if (!report.fault.empty()) continue;
    std::string fault = broken_rule(motion, rules);
    if (fault.empty()) fault = collision_along(motion, shape, rules.step);
    if (!fault.empty()) report.fault = fmt::format("motion {} {}", i, fault);
  }
  return report;
}

}  // namespace wend::test
