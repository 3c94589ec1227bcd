#pragma once

// Scene: what a picture shows: a map as one robot sees it, and what lies on it. Every kind of
// picture (text, terminal, PNG, SVG) is made from a Scene.
//
//   wend::Scene scene{.space = space};
//   scene.path = plan->path;
//   scene.start = wend::centre_of({1, 1});
//   scene.goals = {wend::centre_of({8, 5})};
//   std::cout << wend::text_picture(scene);
//
// A plain value. Copies share the map. Whatever lies outside the map is not drawn.

#include <optional>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/free_space.hpp"
#include "wend/path/path.hpp"

namespace wend {

struct Scene {
  FreeSpace space;
  Path path{};                   // empty: none is drawn
  std::optional<Point> start{};  // grid coordinates
  std::vector<Point> goals{};    // grid coordinates
  std::vector<Cell> visited{};   // cells to mark, in any order
};

}  // namespace wend
