#pragma once

// Footprint: the shape of a robot on the ground: a point, a disc or a polygon. In metres, in the
// robot's own coordinates: the origin is the base point, which paths and poses refer to, +x is ahead,
// and headings grow towards +y (left, if the map is drawn with y up). A polygon need not contain the base
// point, as that of a forklift whose base point lies between its rear wheels, behind the body: the polygon alone decides
// where the robot fits, and its base point may be above an obstacle.
//
//   const auto robot = wend::parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25");
//   if (!robot) return report(robot.error().message);
//   const double radius = robot->circumscribed_radius();  // 0.47 m
//   const auto car = wend::Footprint::rectangle(4.2, 1.8, 1.35);  // base point between the rear wheels
//
// A value type; copies share the polygon, also between threads.

#include <memory>
#include <string>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/polygon.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// A disc that a shape covers, in the shape's coordinates.
struct InnerDisc {
  Point centre = {};  // metres
  double radius = 0;  // metres; 0: a point

  friend bool operator==(const InnerDisc&, const InnerDisc&) = default;
};

class WEND_API Footprint {
 public:
  static constexpr double kLargestRadius = 1e9;  // metres

  /// A point.
  Footprint() = default;

  /// A disc around the base point. A radius of 0 is a point.
  static Footprint disc(double radius) { return {radius, radius}; }

  /// Any polygon; the base point may lie inside, on its outline or outside. Never fails. O(corners), times some
  /// hundred if the base point lies outside.
  static Expected<Footprint, Error> polygon(Polygon outline);

  /// A rectangle along the axes. Its centre lies `ahead` metres ahead of the base point (behind it if negative): of a
  /// car whose base point is between its rear wheels, half the wheelbase if it reaches as far beyond the front wheels as
  /// beyond the rear ones. Fails if a length is not above 0, or not finite, or too large for a polygon.
  static Expected<Footprint, Error> rectangle(double length, double width, double ahead = 0);

  /// Is it a point, or a disc of radius 0?
  bool is_point() const { return !polygon_ && circumscribed_ == 0; }

  /// The outline; null for a point or a disc.
  const Polygon* outline() const { return polygon_.get(); }

  /// Does the shape cover the base point, inside or on its outline?
  bool covers_base_point() const { return covers_base_; }

  /// The radius of the largest disc around the base point that the shape covers: where this disc does
  /// not fit, the robot fits with no heading. 0 if the base point lies on the outline of a polygon or outside.
  double inscribed_radius() const { return covers_base_ ? inner_.radius : 0; }

  /// A disc that the shape covers: the largest one around the base point, or a large one near it if the shape
  /// does not cover the base point. Where it does not fit, the robot does not fit.
  const InnerDisc& inner_disc() const { return inner_; }

  /// The radius of the smallest disc around the base point that covers the shape: where this disc
  /// fits, the robot fits with every heading.
  double circumscribed_radius() const { return circumscribed_; }

  /// Is the radius finite, from 0 to kLargestRadius?
  bool valid() const { return circumscribed_ >= 0 && circumscribed_ <= kLargestRadius; }

  /// Multiplies all lengths by a finite factor greater than 0.
  Footprint scaled(double factor) const;

  /// Covers everything within `margin` (>= 0) of the shape. A disc gets a larger radius; a polygon becomes
  /// convex, with an octagon around each corner, so that corners are farther away by up to 8 % of the margin.
  /// A polygon with too many corners for that becomes the disc around it. O(corners^2).
  Footprint grown(double margin) const;

  /// Compares the shapes: the corners of polygons, else the radii.
  friend bool operator==(const Footprint& a, const Footprint& b) {
    const bool polygons = a.polygon_ && b.polygon_;
    return polygons ? *a.polygon_ == *b.polygon_
                    : !a.polygon_ && !b.polygon_ && a.circumscribed_ == b.circumscribed_;
  }

 private:
  Footprint(double inscribed, double circumscribed)
      : inner_{{}, inscribed}, circumscribed_(circumscribed) {}

  InnerDisc inner_;
  double circumscribed_ = 0;
  bool covers_base_ = true;
  std::shared_ptr<const Polygon> polygon_;
};

/// Reads "point", "disc:0.2", "rect:LENGTHxWIDTH", "rect:LENGTHxWIDTH,AHEAD" (as Footprint::rectangle()) or the
/// corners of a polygon, written as "0.4,0.25; 0.4,-0.25; -0.3,0" or like ROS costmaps as
/// "[[0.4, 0.25], [0.4, -0.25], [-0.3, 0]]". Blanks between numbers and punctuation do not matter.
WEND_API Expected<Footprint, Error> parse_footprint(std::string_view typed);

/// Writes a point, a disc, or the corners of a polygon in the first of these notations; parse_footprint() reads it
/// back as the same footprint.
WEND_API std::string text_of(const Footprint& footprint);

}  // namespace wend
