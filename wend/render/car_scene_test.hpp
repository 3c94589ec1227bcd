#pragma once

// Scenes with a car for tests.

#include <utility>
#include <vector>

#include "wend/geometry/car_move.hpp"
#include "wend/render/scene.hpp"

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

inline Scene car_on(FreeSpace space, Path path) {
  Scene scene{.space = std::move(space)};
  scene.unit = 1;
  scene.path = std::move(path);
  return scene;
}

}  // namespace wend
