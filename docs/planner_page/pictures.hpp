#pragma once

// What every planner expands on one and the same map.

#include <cstddef>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/render/scene.hpp"

namespace wend::planner_page {

struct Picture {
  std::string planner;
  std::string png;      // the bytes
  std::string caption;  // what it shows, in a sentence
};

/// One a planner, in the registry's order, with default options.
Expected<std::vector<Picture>, Error> pictures_of_planners();

/// What map the pictures show.
std::string about_pictures();

}  // namespace wend::planner_page
