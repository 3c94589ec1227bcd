// PID on heading and distance. K. J. Åström and R. M. Murray, "Feedback Systems", 2008, chapter 10.

#include "wend/control/pid.hpp"

#include <cmath>

#include "wend/control/controller.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

struct PidOptions {
  PidGains heading{.proportional = 3, .integral = 0.2, .derivative = 0.1};
  PidGains distance{.proportional = 1, .integral = 0.05, .derivative = 0};
  double filter_time = 0.1;
  double standing_angle = 0.8;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"heading_gain", "turn rate per radian of heading error, 1/s"}, self.heading.proportional,
          {0, 1e3});
    field({"heading_integral", "turn rate per integral of the heading error, 1/s^2"},
          self.heading.integral, {0, 1e3});
    field({"heading_derivative", "turn rate per rate of change of the heading error"},
          self.heading.derivative, {0, 1e3});
    field({"distance_gain", "speed per metre of remaining distance, 1/s"},
          self.distance.proportional, {0, 1e3});
    field({"distance_integral", "speed per integral of the remaining distance, 1/s^2"},
          self.distance.integral, {0, 1e3});
    field({"distance_derivative", "speed per rate of change of the remaining distance"},
          self.distance.derivative, {0, 1e3});
    field({"filter_time", "time constant of the filter on the error derivatives, s"},
          self.filter_time, {0, 1e3});
    field({"standing_angle",
           "heading error from which the robot only turns, rad; below it the speed falls with the "
           "error"},
          self.standing_angle, {1e-3, 1e3});
  }
};

class PidController final : public Controller {
 public:
  explicit PidController(const PidOptions& options)
      : standing_angle_(options.standing_angle),
        heading_(options.heading, options.filter_time),
        distance_(options.distance, options.filter_time) {}

  void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override {
    heading_.reset();
    distance_.reset();
  }

  Velocity command(const ControllerInput& input) override {
    const TrackingError error = tracking_error_of(input);
    const VelocityLimits& limits = input.limits;
    const double linear = distance_.output(error.distance, error.distance - last_.distance,
                                           input.seconds, limits.speed);
    const double angular =
        heading_.output(error.heading, normalized_angle(error.heading - last_.heading),
                        input.seconds, limits.turn_rate);
    last_ = error;
    return while_turning(linear, angular, error, standing_angle_, limits);
  }

 private:
  double standing_angle_;
  PidTerm heading_;
  PidTerm distance_;
  TrackingError last_;
};

}  // namespace

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

ControllerInfo pid_controller() {
  return {.name = "pid",
          .summary = "PID: controls heading and distance; same as p_moving if I and D are 0",
          .idea =
              "p_moving with two more terms: the integral of the errors, which removes a constant "
              "error, and their derivative, which damps. While the speed or turn rate is at its "
              "limit, errors that would push it further are not integrated.",
          .citation = "Åström, Murray 2008",
          .turns_in_place = true,
          .options = option_schema<PidOptions>(),
          .make = controller_from<PidController, PidOptions>};
}

}  // namespace wend
