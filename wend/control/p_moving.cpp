// A proportional controller that drives while it turns. K. J. Åström and R. M. Murray, "Feedback
// Systems", 2008, chapter 1.

#include "wend/control/controller.hpp"

namespace wend {
namespace {

struct PMovingOptions {
  double heading_gain = 3;
  double distance_gain = 1;
  double standing_angle = 0.8;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"heading_gain", "turn rate per radian of heading error, 1/s"}, self.heading_gain,
          {0, 1e3});
    field({"distance_gain", "speed per metre of remaining distance, 1/s"}, self.distance_gain,
          {0, 1e3});
    field({"standing_angle",
           "heading error from which the robot only turns, rad; below it the speed falls with the "
           "error"},
          self.standing_angle, {1e-3, 1e3});
  }
};

class PMovingController final : public Controller {
 public:
  explicit PMovingController(const PMovingOptions& options) : options_(options) {}

  void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override {}

  Velocity command(const ControllerInput& input) override {
    const TrackingError error = tracking_error_of(input);
    return while_turning(options_.distance_gain * error.distance,
                         options_.heading_gain * error.heading, error, options_.standing_angle,
                         input.limits);
  }

 private:
  PMovingOptions options_;
};

}  // namespace

ControllerInfo p_moving_controller() {
  return {
      .name = "p_moving",
      .summary =
          "P while moving: drives and turns at the same time, slower with a larger heading error",
      .idea =
          "The turn rate is proportional to the angle between the robot's heading and the next "
          "waypoint, the speed to the remaining distance. The speed falls as the angle grows; from "
          "the standing angle on the robot only turns.",
      .citation = "Åström, Murray 2008",
      .turns_in_place = true,
      .options = option_schema<PMovingOptions>(),
      .make = controller_from<PMovingController, PMovingOptions>};
}

}  // namespace wend
