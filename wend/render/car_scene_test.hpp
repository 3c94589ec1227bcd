#pragma once

// Scenes with a car for tests.

#include <array>
#include <utility>
#include <vector>

#include "wend/geometry/compass.hpp"
#include "wend/render/scene.hpp"
#include "wend/robot/car_primitives.hpp"

namespace wend {

/// The poses after some moves.
inline Path driven(CornerPose from, const std::vector<CarMove>& moves, int unit = 1) {
  Path path;
  path.drive_to(pose_of(from));
  for (const CarMove move : moves) {
    from = moved(from, move, unit);
    path.drive_to(pose_of(from));
  }
  return path;
}

/// The move that looks so on a page: its other side where y is drawn upwards.
inline CarMove move_on_page(CarMove move, const Frame& frame) {
  using enum CarMove;
  if (!frame.y_up) return move;
  constexpr std::array kMirrored{fwd, fwd_minus, fwd_plus, rev, rev_minus, rev_plus};
  return kMirrored[static_cast<std::size_t>(move)];
}

inline Scene car_on(FreeSpace space, Path path) {
  Scene scene{.space = std::move(space)};
  scene.places = corners_of(scene.space);
  scene.path = std::move(path);
  return scene;
}

}  // namespace wend
