#pragma once

// ExplorationFilm: what a robot believed while it drove over a map that it did not know, picture by picture.
//
// A frame keeps the map as it was, which the robot's next discovery copies. So a film of a long drive has few
// frames: when there are too many, it drops every second one.

#include <cstddef>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/explore/explorer.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {

/// The map as the robot believes it to be now, what it has driven, and where it is going.
Scene scene_now(const Explorer& explorer);

class ExplorationFilm {
 public:
  /// Takes a picture after a step, if it is time for one.
  void take(const Explorer& explorer);

  /// All of it as a GIF, which ends with this scene.
  Expected<std::string, Error> gif(const std::string& planner, const Scene& last,
                                   const Style& style) const;

 private:
  std::vector<Scene> frames_;
  std::size_t steps_ = 0;
  std::size_t stride_ = 1;  // steps between frames
};

}  // namespace wend::cli
