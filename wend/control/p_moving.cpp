// A proportional controller that drives while it turns. K. J. Åström and R. M. Murray, "Feedback
// Systems", 2008, chapter 1.

#include "wend/control/controller.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

struct PMovingOptions {
  double heading_gain = 3;
  double distance_gain = 1;
  double standing_angle = 0.8;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"heading_gain", "turn rate for a radian of heading error, 1/s"}, self.heading_gain,
          {0, 1e3});
    field({"distance_gain", "speed for a metre that is left to drive, 1/s"}, self.distance_gain,
          {0, 1e3});
    field({"standing_angle", "slower with heading error, and not at all from this on, rad"},
          self.standing_angle, {1e-3, 1e3});
  }
};

class PMovingController final : public Controller {
 public:
  explicit PMovingController(const PMovingOptions& options) : options_(options) {}

  void begin(const Polyline& /*line*/, const VelocityLimits& /*limits*/) override {}

  Velocity command(const ControllerInput& input) override {
    const TrackingError aim = tracking_error_of(input);
    return while_turning(options_.distance_gain * aim.distance, options_.heading_gain * aim.heading,
                         aim, options_.standing_angle, input.limits);
  }

 private:
  PMovingOptions options_;
};

}  // namespace

ControllerInfo p_moving_controller() {
  return {
      .name = "p_moving",
      .summary = "P that drives while it turns, slower the larger the heading error",
      .idea =
          "The turn rate is proportional to the angle by which the robot does not face the next "
          "waypoint, the speed to what is left to drive. The larger the angle, the slower it "
          "drives; from the standing angle on it only turns.",
      .citation = "Åström, Murray 2008",
      .turns_in_place = true,
      .options = option_schema<PMovingOptions>(),
      .make = make_controller<PMovingController, PMovingOptions>};
}

}  // namespace wend
