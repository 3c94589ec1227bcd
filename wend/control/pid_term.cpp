#include "wend/control/pid_term.hpp"

#include <cmath>

namespace wend {

void PidTerm::reset() {
  integral_ = 0;
  slope_ = 0;
  is_first_ = true;
}

double PidTerm::output(double error, double change, double seconds, double limit) {
  if (!is_first_) slope_ += (change / seconds - slope_) * seconds / (filter_time_ + seconds);
  is_first_ = false;
  const double other = gains_.proportional * error + gains_.derivative * slope_;
  const double summed = integral_ + error * seconds;
  const double wanted = other + gains_.integral * summed;
  const bool winds_up = std::abs(wanted) > limit && wanted * error > 0;
  if (winds_up) return other + gains_.integral * integral_;
  integral_ = summed;
  return wanted;
}

}  // namespace wend
