#include "cli/output/collision_text.hpp"

#include <fmt/format.h>

namespace wend::cli {

std::string collision_text(const PathCollision& collision, const Coordinates& coordinates) {
  std::string text = fmt::format("after {}, at {}, it {}", coordinates.length(collision.along),
                                 coordinates.text(collision.point), describe(collision.kind));
  if (collision.obstacle) {
    text += fmt::format(": the one at {}", coordinates.text(centre_of(*collision.obstacle)));
  }
  return text;
}

}  // namespace wend::cli
