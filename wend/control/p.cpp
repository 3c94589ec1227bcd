// A proportional controller that turns in place towards the next waypoint, then drives. K. J. Åström
// and R. M. Murray, "Feedback Systems", 2008, chapter 1.

#include <cmath>

#include "wend/control/controller.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

struct POptions {
  double heading_gain = 3;
  double distance_gain = 1;
  double turn_above = 0.4;
  double drive_below = 0.1;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"heading_gain", "turn rate per radian of heading error, 1/s"}, self.heading_gain,
          {0, 1e3});
    field({"distance_gain", "speed per metre of remaining distance, 1/s"}, self.distance_gain,
          {0, 1e3});
    field({"turn_above", "heading error above which the robot stops to turn, rad"}, self.turn_above,
          {1e-3, kPi});
    field({"drive_below", "heading error below which the robot drives on, rad"}, self.drive_below,
          {1e-3, kPi});
  }
};

class PController final : public Controller {
 public:
  explicit PController(const POptions& options) : options_(options) {}

  void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override {
    turning_ = true;
  }

  Velocity command(const ControllerInput& input) override {
    const TrackingError error = tracking_error_of(input);
    turning_ = std::abs(error.heading) > (turning_ ? options_.drive_below : options_.turn_above);
    return {turning_ ? 0 : options_.distance_gain * error.distance,
            options_.heading_gain * error.heading};
  }

 private:
  POptions options_;
  bool turning_ = true;
};

}  // namespace

ControllerInfo p_controller() {
  return {
      .name = "p",
      .summary = "P: turns in place towards the next waypoint, then drives",
      .idea =
          "The turn rate is proportional to the angle between the robot's heading and the next "
          "waypoint, the speed to the remaining distance. While the angle is large it only turns.",
      .citation = "Åström, Murray 2008",
      .turns_in_place = true,
      .options = option_schema<POptions>(),
      .make = controller_from<PController, POptions>};
}

}  // namespace wend
