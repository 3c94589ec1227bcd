// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/standing_watch.hpp"

#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend_nav2 {

double StandingWatch::standing_for(const wend::MapPose& pose, double seconds, double way,
                                   double turn) {
  const bool stands = place_ && distance(place_->point(), pose.point()) <= way &&
                      std::abs(wend::normalized_angle(place_->heading - pose.heading)) <= turn;
  if (!stands) place_ = pose;
  seconds_ = stands ? seconds_ + seconds : 0;
  return seconds_;
}

}  // namespace wend_nav2
