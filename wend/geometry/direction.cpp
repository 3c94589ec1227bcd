#include "wend/geometry/direction.hpp"

namespace wend {

double radians_of(Heading heading) {
  const Cell step = ahead(heading);
  if (step.x != 0) return step.x > 0 ? 0 : kPi;
  return step.y * kPi / 2;
}

Heading nearest_heading(double radians) {
  constexpr std::array<Heading, kHeadings> kByQuarter{Heading::plus_x, Heading::plus_y,
                                                      Heading::minus_x, Heading::minus_y};
  const auto quarters = static_cast<int>(std::round(normalized_angle(radians) / (kPi / 2)));
  return kByQuarter[static_cast<std::size_t>((quarters + kHeadings) % kHeadings)];  // from -2..2
}

std::optional<Heading> exact_heading(double radians) {
  for (const Heading heading : kAllHeadings) {
    if (radians == radians_of(heading)) return heading;
  }
  return std::nullopt;
}

}  // namespace wend
