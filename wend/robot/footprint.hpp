#pragma once

// Footprint: the shape of a robot on the ground: a point, a disc or a polygon. In metres, in the
// robot's own coordinates: the origin is the base point, which paths and poses speak of, +x is ahead
// and +y is where the heading grows to (left, where a page shows the map with y up).
//
//   const auto robot = wend::parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25");
//   if (!robot) return report(robot.error().message);
//   const double radius = robot->circumscribed_radius();  // 0.47 m
//
// A value; copies share the polygon, also between threads.

#include <memory>
#include <string>
#include <string_view>

#include "wend/base/error.hpp"
#include "wend/geometry/polygon.hpp"

namespace wend {

class Footprint {
 public:
  static constexpr double kLargestRadius = 1e9;  // metres

  /// A point.
  Footprint() = default;

  /// Around the base point. A radius of 0 is a point.
  static Footprint disc(double radius) { return {radius, radius}; }

  /// Refused unless the polygon contains the base point, inside or on its outline.
  static Expected<Footprint, Error> polygon(Polygon outline);

  bool is_point() const { return !polygon_ && circumscribed_ == 0; }

  /// The outline, or null of a point and a disc.
  const Polygon* outline() const { return polygon_.get(); }

  /// Of the largest disc around the base point that the shape covers: where it does not fit, the
  /// robot fits with no heading.
  double inscribed_radius() const { return inscribed_; }

  /// Of the smallest disc around the base point that covers the shape: where it fits, the robot
  /// fits with every heading.
  double circumscribed_radius() const { return circumscribed_; }

  /// The radius of a disc is finite, from 0 to kLargestRadius.
  bool valid() const { return circumscribed_ >= 0 && circumscribed_ <= kLargestRadius; }

  /// All lengths times a finite factor greater than 0.
  Footprint scaled(double factor) const;

  friend bool operator==(const Footprint& a, const Footprint& b) {
    const bool polygons = a.polygon_ && b.polygon_;
    return polygons ? *a.polygon_ == *b.polygon_
                    : !a.polygon_ && !b.polygon_ && a.circumscribed_ == b.circumscribed_;
  }

 private:
  Footprint(double inscribed, double circumscribed)
      : inscribed_(inscribed), circumscribed_(circumscribed) {}

  double inscribed_ = 0;
  double circumscribed_ = 0;
  std::shared_ptr<const Polygon> polygon_;
};

/// Reads "point", "disc:0.2" or the corners of a polygon in either of two spellings, "0.4,0.25;
/// 0.4,-0.25; -0.3,0" and that of ROS costmaps, "[[0.4, 0.25], [0.4, -0.25], [-0.3, 0]]". Blanks
/// between numbers and signs do not matter.
Expected<Footprint, Error> parse_footprint(std::string_view typed);

/// The first spelling of these; parse_footprint() reads it back as the same footprint.
std::string text_of(const Footprint& footprint);

}  // namespace wend
