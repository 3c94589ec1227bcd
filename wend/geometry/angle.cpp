#include "wend/geometry/angle.hpp"

#include <cmath>

namespace wend {

double normalized_angle(double radians) {
  const double wrapped = std::remainder(radians, 2 * kPi);  // in [-pi, pi]
  return wrapped == -kPi ? kPi : wrapped;
}

}  // namespace wend
