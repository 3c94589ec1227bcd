#include "wend/geometry/heading.hpp"

#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend {

double radians_of(Heading heading, bool y_up) {
  const Cell step = ahead(heading, y_up);
  if (step.x != 0) return step.x > 0 ? 0 : kPi;
  return step.y * kPi / 2;
}

Heading nearest_heading(double radians, bool y_up) {
  constexpr std::array<Heading, kHeadings> kTowardsSouth{Heading::east, Heading::south,
                                                         Heading::west, Heading::north};
  const double drawn = normalized_angle(y_up ? -radians : radians);
  const auto quarters = static_cast<int>(std::round(drawn / (kPi / 2)));  // in -2..2
  return kTowardsSouth[static_cast<std::size_t>((quarters + kHeadings) % kHeadings)];
}

std::optional<Heading> exact_heading(double radians, bool y_up) {
  for (const Heading heading : kAllHeadings) {
    if (radians == radians_of(heading, y_up)) return heading;
  }
  return std::nullopt;
}

std::optional<Heading> parse_heading(std::string_view text) {
  if (text.size() != 1) return std::nullopt;
  for (const Heading heading : kAllHeadings) {
    const char capital = to_string(heading).front();
    const char small = static_cast<char>(capital - 'A' + 'a');
    const char number = static_cast<char>('0' + static_cast<int>(heading));
    if (text.front() == capital || text.front() == small || text.front() == number) return heading;
  }
  return std::nullopt;
}

}  // namespace wend
