#pragma once

// Steering: which motions a robot can make, what they cost, and the cheapest ways to drive from one pose to another
// where nothing is in the way.

#include <array>
#include <limits>
#include <span>

#include "wend/geometry/curve.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/space/se2/drive_kind.hpp"
#include "wend/space/se2/motion.hpp"

namespace wend {

/// What driving costs besides its length.
struct DriveCosts {
  double reverse = 2;      // factor on lengths in reverse
  double turn = 1.2;       // factor on the lengths of arcs
  double gear_change = 0;  // cells, for each change between ahead and reverse
  double spin = 1;         // cells a radian, of a turn in place
};

/// Motions that lead from one pose to another.
struct Connection {
  std::array<Motion, 5> motions;
  int count = 0;
  double cost = std::numeric_limits<double>::infinity();  // where every cell costs 1

  std::span<const Motion> all() const { return {motions.data(), static_cast<std::size_t>(count)}; }
};

class Steering {
 public:
  /// The turning radius, in cells, is above 0 for cars.
  Steering(DriveKind model, double radius, const DriveCosts& costs);

  DriveKind model() const { return model_; }
  double radius() const { return radius_; }
  const DriveCosts& costs() const { return costs_; }

  /// The motions of a search, `step` cells long.
  std::span<const Motion> primitives() const { return {primitives_.data(), primitive_count_}; }
  /// A primitive that goes `step` cells far, but turns by a quarter turn at most.
  Motion scaled(const Motion& primitive, double step) const;

  /// The cost of a motion whose way costs `way`, without changes of gear. O(1).
  double cost(const Motion& motion, double way) const;

  /// The cheapest connections that cost less than `bound`, sorted by cost; returns how many. `gear` is that of the
  /// motion before. A robot that turns in place drives lines between its turns; if more than two connections are asked
  /// for, also arcs of every radius before or behind a turn, and curves of arcs and lines without one.
  int connect(const Pose& from, const Pose& to, int gear, double bound,
              std::span<Connection> connections) const;
  /// The same, but for cars only a line between two arcs, all ahead or all in reverse: cheaper to compute.
  int connect_simply(const Pose& from, const Pose& to, int gear, double bound,
                     std::span<Connection> connections) const;

  /// Headings with which the robot may arrive at a point from a pose without turning more than it has to; returns
  /// how many.
  int arrivals(const Pose& from, Point to, std::span<double> headings) const;

 private:
  /// That of the arcs in the search, of a robot that could drive narrower ones.
  double arc_radius() const;
  int take(std::span<const Curve> curves, int gear, int count,
           std::span<Connection> connections) const;
  int turn_and_drive(const Pose& from, const Pose& to, int gear, double bound,
                     std::span<Connection> connections) const;
  int slide(const Pose& from, const Pose& to, int gear, double bound,
            std::span<Connection> connections) const;
  void add_primitive(const Motion& motion) { primitives_[primitive_count_++] = motion; }

  DriveKind model_;
  double radius_;
  DriveCosts costs_;
  std::array<Motion, 10> primitives_;
  std::size_t primitive_count_ = 0;
};

}  // namespace wend
