#pragma once

// Random arcs for tests: from a line to a full circle, ahead or in reverse, also nearly straight and
// of no length; many of them as a car on corners drives.

#include <array>
#include <sstream>
#include <string>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc.hpp"

namespace wend::test {

inline double number_between(Random& random, double least, double greatest) {
  return least + (greatest - least) * random.uniform();
}

/// An arc from a corner of a grid of `width` x `height` cells, along its lines and around its
/// corners.
inline Arc random_lattice_arc(Random& random, int width, int height) {
  const Pose from{static_cast<double>(random.between(0, width)),
                  static_cast<double>(random.between(0, height)), random.between(-1, 2) * kPi / 2};
  const int gear = random.chance(0.5) ? 1 : -1;
  const int side = random.between(-1, 1);
  const int radius = random.between(1, 2);
  const int quarters = random.chance(0.7) ? 1 : random.between(1, 4);
  const double length = gear * quarters * radius * (side == 0 ? 1 : kPi / 2);
  return {from, length, static_cast<double>(side) / radius};
}

/// An arc that begins on a grid of `width` x `height` cells or a little outside of it.
inline Arc random_arc(Random& random, int width, int height) {
  constexpr std::array kNearlyNothing{0.0, 1e-12, 1e-9, 1e-5, 1e-2};
  constexpr double kLongest = 8;
  if (random.chance(0.3)) return random_lattice_arc(random, width, height);
  const Pose from{number_between(random, -1, width + 1), number_between(random, -1, height + 1),
                  number_between(random, -7, 7)};
  const double gear = random.chance(0.5) ? 1 : -1;
  const double side = random.chance(0.5) ? 1 : -1;
  if (random.chance(0.05)) return {from, 0, side * random.uniform()};
  const double length = number_between(random, 0.001, kLongest);
  const double turn = random.chance(0.3) ? kNearlyNothing[random.below(kNearlyNothing.size())]
                                         : number_between(random, 0, 2 * kPi);
  return {from, gear * length, side * turn / length};
}

inline std::string text_of(const Arc& arc) {
  std::ostringstream text;
  text.precision(17);
  text << "from (" << arc.from.x << "," << arc.from.y << ") heading " << arc.from.heading
       << ", length " << arc.length << ", curvature " << arc.curvature;
  return text.str();
}

}  // namespace wend::test
