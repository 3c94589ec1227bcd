#include "wend/space/se2/steering.hpp"

#include <algorithm>
#include <cmath>

namespace wend {
namespace {

constexpr std::size_t kMostCurves = 8;
constexpr std::size_t kTurnsAndDrives =
    2;                             // connections without arcs of a robot that turns in place
constexpr double kNothing = 1e-9;  // cells or radians that need no motion

/// Appends a motion to a connection that has room for it.
void append(Connection& connection, const Motion& motion) {
  if (std::abs(motion.length) < kNothing && std::abs(motion.turn) < kNothing) return;
  connection.motions[static_cast<std::size_t>(connection.count++)] = motion;
}

/// Inserts a connection into the first `count` of a list sorted by cost; returns how many there are then.
int insert(const Connection& connection, int count, std::span<Connection> list) {
  auto place = static_cast<std::size_t>(count);
  if (place == list.size()) {
    if (connection.cost >= list[place - 1].cost) return count;
    --place;
  }
  for (; place > 0 && connection.cost < list[place - 1].cost; --place)
    list[place] = list[place - 1];
  list[place] = connection;
  return std::min(count + 1, static_cast<int>(list.size()));
}

/// Turns to a heading, drives a line or an arc from there to the point of `to`, and turns to its heading. `ahead`: in
/// the direction of 1 ahead or -1 in reverse.
Connection by_way_of(const Pose& from, const Pose& to, int ahead, double heading) {
  const double length = straight_distance(from.point(), to.point());
  const double towards = arc_tangent(ahead * (to.y - from.y), ahead * (to.x - from.x));
  const double turn = 2 * wrapped_angle(towards - heading);
  Connection connection;
  append(connection, {0, wrapped_angle(heading - from.heading), 0});
  append(connection, {ahead * length / chord_share(turn), std::abs(turn) < kNothing ? 0 : turn, 0});
  append(connection, {0, wrapped_angle(to.heading - heading - turn), 0});
  return connection;
}

/// Is a motion more than a half circle?
bool is_detour(const Motion& motion) { return std::abs(motion.turn) > kPi && motion.length != 0; }

}  // namespace

Steering::Steering(DriveKind model, double radius, const DriveCosts& costs)
    : model_(model), radius_(radius), costs_(costs) {
  const double turn = radius > 0 ? 1 / radius : 0;
  switch (model) {
    case DriveKind::reeds_shepp:
    case DriveKind::dubins:
      for (const int side : {0, 1, -1}) add_primitive({1, side * turn, 0});
      if (model == DriveKind::dubins) break;
      for (const int side : {0, 1, -1}) add_primitive({-1, -side * turn, 0});
      break;
    case DriveKind::differential:
      for (const int length : {1, -1}) {
        for (const int side : {0, 1, -1}) add_primitive({1.0 * length, side / arc_radius(), 0});
      }
      break;
    case DriveKind::omni:
      for (const int length : {1, -1}) {
        for (const int eighth : {-1, 0, 1, 2}) add_primitive({1.0 * length, 0, eighth * kPi / 4});
      }
      break;
  }
  if (model == DriveKind::differential || model == DriveKind::omni) {
    constexpr double kSpin = kPi / 12;
    add_primitive({0, kSpin, 0});
    add_primitive({0, -kSpin, 0});
  }
}

Motion Steering::scaled(const Motion& primitive, double step) const {
  if (primitive.length == 0) return primitive;
  constexpr double kMostTurn = kPi / 2;
  const double turn = std::abs(primitive.turn) * step;
  const double share = turn > kMostTurn ? kMostTurn / turn : 1;
  return {primitive.length * step * share, primitive.turn * step * share, primitive.course};
}

double Steering::cost(const Motion& motion, double way) const {
  if (model_ == DriveKind::omni || motion.length == 0) {
    return way + std::abs(motion.turn) * costs_.spin;
  }
  double factor = motion.turn != 0 ? costs_.turn : 1;
  if (motion.length < 0) factor *= costs_.reverse;
  // An arc of a robot that turns in place costs no less than the turn.
  const double turning =
      model_ == DriveKind::differential ? std::abs(motion.turn) * costs_.spin : 0;
  return std::max(way * factor, turning);
}

double Steering::arc_radius() const {
  constexpr double kOfArcs = 4;  // cells, where nothing else is known
  return radius_ > 0 ? radius_ : kOfArcs;
}

int Steering::take(std::span<const Curve> curves, int gear, int count,
                   std::span<Connection> connections) const {
  for (const Curve& curve : curves) {
    Connection connection;
    for (int i = 0; i < curve.count; ++i) {
      const CurvePiece& piece = curve.pieces[static_cast<std::size_t>(i)];
      append(connection,
             {piece.length, static_cast<int>(piece.turn) * piece.length / arc_radius(), 0});
    }
    connection.cost = 0;
    int before = gear;
    for (const Motion& motion : connection.all()) {
      connection.cost += cost(motion, std::abs(motion.length));
      if (before * gear_of(motion) < 0) connection.cost += costs_.gear_change;
      before = gear_of(motion);
    }
    count = insert(connection, count, connections);
  }
  return count;
}

int Steering::connect(const Pose& from, const Pose& to, int gear, double bound,
                      std::span<Connection> connections) const {
  int count = 0;
  if (model_ == DriveKind::differential) {
    count = turn_and_drive(from, to, gear, bound, connections);
    if (connections.size() <= kTurnsAndDrives) return count;
  }
  if (model_ == DriveKind::omni) return slide(from, to, gear, bound, connections);
  std::array<Curve, kMostCurves> curves;
  const std::span<Curve> wanted(curves.data(), std::min(connections.size(), kMostCurves));
  const CurveCosts costs{costs_.reverse, costs_.turn, costs_.gear_change};
  const int words = model_ == DriveKind::dubins
                        ? dubins_words(from, to, radius_, costs, bound, wanted)
                        : reeds_shepp_words(from, to, arc_radius(), costs, bound, wanted);
  return take(wanted.first(static_cast<std::size_t>(words)), gear, count, connections);
}

int Steering::connect_simply(const Pose& from, const Pose& to, int gear, double bound,
                             std::span<Connection> connections) const {
  if (model_ != DriveKind::reeds_shepp) return connect(from, to, gear, bound, connections);
  std::array<Curve, kMostCurves> curves;
  const std::span<Curve> wanted(curves.data(), std::min(connections.size(), kMostCurves));
  const CurveCosts costs{costs_.reverse, costs_.turn, costs_.gear_change};
  const int words = simple_words(from, to, radius_, costs, bound, wanted);
  return take(wanted.first(static_cast<std::size_t>(words)), gear, 0, connections);
}

/// Drives to the point in a line between two turns in place, or in an arc before or behind one: ahead and in reverse.
int Steering::turn_and_drive(const Pose& from, const Pose& to, int gear, double bound,
                             std::span<Connection> connections) const {
  int count = 0;
  const auto offer = [&](Connection connection) {
    connection.cost = 0;
    for (const Motion& motion : connection.all()) {
      connection.cost += cost(motion, std::abs(motion.length));
      if (gear * gear_of(motion) < 0) connection.cost += costs_.gear_change;
      if (is_detour(motion)) return;
    }
    if (connection.cost < bound) count = insert(connection, count, connections);
  };
  if (straight_distance(from.point(), to.point()) < kNothing) {
    Connection turn;
    append(turn, {0, wrapped_angle(to.heading - from.heading), 0});
    offer(turn);
    return count;
  }
  for (const int ahead : {1, -1}) {
    const double towards = arc_tangent(ahead * (to.y - from.y), ahead * (to.x - from.x));
    offer(by_way_of(from, to, ahead, towards));
    if (connections.size() <= kTurnsAndDrives) continue;
    offer(by_way_of(from, to, ahead, from.heading));
    offer(by_way_of(from, to, ahead, wrapped_angle(2 * towards - to.heading)));
  }
  return count;
}

/// Moves in a line and turns meanwhile, or before, or behind.
int Steering::slide(const Pose& from, const Pose& to, int gear, double bound,
                    std::span<Connection> connections) const {
  const double turn = wrapped_angle(to.heading - from.heading);
  const double length = straight_distance(from.point(), to.point());
  const double direction =
      length < kNothing ? from.heading : arc_tangent(to.y - from.y, to.x - from.x);
  int count = 0;
  for (const double first : {0.0, turn}) {
    Connection connection;
    append(connection, {0, first, 0});
    double course = wrapped_angle(direction - from.heading - first);
    double way = length;
    if (std::abs(course) > kPi / 2) {
      course = wrapped_angle(course - kPi);
      way = -way;
    }
    append(connection, {way, 0, course});
    append(connection, {0, turn - first, 0});
    connection.cost = length + std::abs(turn) * costs_.spin;
    if (length >= kNothing && gear * way < 0) connection.cost += costs_.gear_change;
    if (connection.cost < bound) count = insert(connection, count, connections);
    if (turn == 0) break;
  }
  return count;
}

int Steering::arrivals(const Pose& from, Point to, std::span<double> headings) const {
  std::size_t count = 0;
  const auto add = [&](double heading) {
    if (count < headings.size()) headings[count++] = heading;
  };
  const double length = straight_distance(from.point(), to);
  if (model_ == DriveKind::omni || length < kNothing) {
    add(from.heading);
    return static_cast<int>(count);
  }
  if (model_ == DriveKind::differential) {
    add(arc_tangent(to.y - from.y, to.x - from.x));
    add(arc_tangent(from.y - to.y, from.x - to.x));
    return static_cast<int>(count);
  }
  // An arc to the left or right, then the tangent to the point.
  const auto [sine, cosine] = sine_and_cosine(from.heading);
  for (const int gear : {1, -1}) {
    if (gear < 0 && model_ == DriveKind::dubins) break;
    for (const int side : {1, -1}) {
      const Point centre{from.x - side * radius_ * sine, from.y + side * radius_ * cosine};
      const double dx = to.x - centre.x;
      const double dy = to.y - centre.y;
      const double tangent = dx * dx + dy * dy - radius_ * radius_;
      if (tangent < 0) continue;
      // Seen from the tangent point, the centre is at the side of the robot.
      const double along = gear * std::sqrt(tangent);
      add(arc_tangent(dy * along + side * radius_ * dx, dx * along - side * radius_ * dy));
    }
  }
  return static_cast<int>(count);
}

}  // namespace wend
