#pragma once

// Which jumps of the direction of travel a robot drives over. Primitives from files end on whole cells,
// so their directions are only nearly those of their headings.

#include "wend/geometry/angle.hpp"

namespace wend {

/// Smaller jumps need no stop, and a smaller course is no step to the side.
inline constexpr double kSmallJump = radians_from(10);

}  // namespace wend
