#include "wend/control/given_route.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/path/small_jump.hpp"

namespace wend {
namespace {

constexpr double kSameHeading = 1e-6;  // rad

bool same_heading(double a, double b) { return std::abs(normalized_angle(a - b)) <= kSameHeading; }

bool stands(const MapPose& from, const MapPose& to) {
  return distance(from.point(), to.point()) <= Route::kSamePlace;
}

double course_of(const MapPose& from, const MapPose& to) {
  return arc_tangent(to.y - from.y, to.x - from.x);
}

/// Does the robot's back lead from pose to pose? On an arc the chord has the mean heading.
bool leads_back(const MapPose& from, const MapPose& to) {
  const double course = course_of(from, to);
  const auto ahead = [&](double heading) { return sine_and_cosine(course - heading).cosine; };
  constexpr double kAside = 1e-6;  // a half turn on the way has no mean heading
  const double both = ahead(from.heading) + ahead(to.heading);
  return (std::abs(both) > kAside ? both : ahead(from.heading)) < 0;
}

/// Is it an arc, a line or a turn in place with these headings?
bool can_be_driven(const MapPose& from, const MapPose& to) {
  if (stands(from, to)) return true;
  const double mean = from.heading + normalized_angle(to.heading - from.heading) / 2;
  const double aside = std::abs(normalized_angle(course_of(from, to) - mean));
  return std::min(aside, kPi - aside) <= kSmallJump;
}

std::optional<Error> fault_of(std::span<const MapPose> poses) {
  if (poses.empty()) return Error{Status::unsupported_query, "the path has no poses", "path"};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const MapPose& pose = poses[i];
    if (Route::can_hold(pose.point()) && Route::can_hold(pose.heading)) continue;
    const std::string where = "pose " + std::to_string(i);
    return Error{Status::unsupported_query,
                 where +
                     " of the path has a number that is not finite, is farther than 1e8 m from "
                     "the origin, or has a heading beyond 1e6 rad",
                 where};
  }
  return std::nullopt;
}

/// Builds the legs pose by pose. Poses on top of each other are one place; what they turn there in all is a
/// turn in place.
class LegBuilder {
 public:
  LegBuilder(std::span<const MapPose> poses, bool faces) : faces_(faces), at_(poses.front()) {
    points_.push_back(at_.point());
    for (const MapPose& pose : poses.subspan(1)) {
      if (stands(at_, pose)) {
        turn_to(pose.heading);
      } else {
        drive_to(pose);
      }
    }
    end_leg(false);
  }

  std::vector<RouteLeg> take() { return std::move(legs_); }

 private:
  void turn_to(double heading) {
    turned_ = turned_ || (faces_ && !same_heading(heading, at_.heading));
    at_.heading = heading;
  }

  void drive_to(const MapPose& pose) {
    const bool reverse = faces_ && leads_back(at_, pose);
    const bool turns = turned_ || bends_back(pose.point(), reverse);
    if (turns || reverse != reverse_) end_leg(turns);
    reverse_ = reverse;
    turned_ = false;
    points_.push_back(pose.point());
    at_ = pose;
  }

  /// By more than a right angle, in one gear? A reversal is no bend.
  bool bends_back(MapPoint to, bool reverse) const {
    if (points_.size() < 2 || reverse != reverse_) return false;
    const MapPoint a = points_[points_.size() - 2];
    const MapPoint b = points_.back();
    return (b.x - a.x) * (to.x - b.x) + (b.y - a.y) * (to.y - b.y) < 0;
  }

  /// Without points but the first, only notes how the next leg begins.
  void end_leg(bool turns) {
    if (points_.size() > 1) {
      legs_.push_back({MapPolyline(points_), reverse_, turn_first_});
      points_.assign(1, points_.back());
    }
    turn_first_ = turns;
  }

  bool faces_;
  MapPose at_;
  std::vector<RouteLeg> legs_;
  std::vector<MapPoint> points_;  // of this leg
  bool reverse_ = false;
  bool turn_first_ = false;
  bool turned_ = false;  // at the last point
};

}  // namespace

bool headings_count(std::span<const MapPose> poses) {
  if (poses.size() < 2) return false;
  const auto inner = poses.subspan(1, poses.size() - 2);
  const bool changes = std::ranges::any_of(inner, [&](const MapPose& pose) {
    return !same_heading(pose.heading, inner.front().heading);
  });
  if (changes) return true;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    if (!can_be_driven(poses[i], poses[i + 1])) return false;
  }
  return true;
}

Expected<Route, Error> given_route(std::span<const MapPose> poses) {
  if (auto fault = fault_of(poses)) return Unexpected<Error>(*std::move(fault));
  std::vector<RouteLeg> legs = LegBuilder(poses, headings_count(poses)).take();
  if (legs.empty()) legs.push_back({MapPolyline({poses.back().point()})});
  return Route(std::move(legs), poses.back().heading);
}

}  // namespace wend
