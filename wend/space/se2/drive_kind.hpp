#pragma once

// DriveKind: how a robot moves, for planners over continuous poses.

#include <array>

#include "wend/base/choice.hpp"

namespace wend {

/// How a robot moves.
enum class DriveKind {
  reeds_shepp,   // a car: ahead and in reverse, with a least turning radius
  dubins,        // a car without reverse gear
  differential,  // ahead and in reverse, and turns in place
  omni,          // in every direction, and turns while it moves
};

constexpr std::array<Choice<DriveKind>, 4> choice_names(DriveKind) {
  return {{{"reeds_shepp", DriveKind::reeds_shepp},
           {"dubins", DriveKind::dubins},
           {"differential", DriveKind::differential},
           {"omni", DriveKind::omni}}};
}

}  // namespace wend
