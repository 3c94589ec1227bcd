// Lab::drive(): a simulated robot follows the last path.

#include <algorithm>

#include "lab/wasm/answers.hpp"
#include "lab/wasm/json.hpp"
#include "lab/wasm/lab.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/simulation.hpp"

namespace wend::lab {
namespace {

struct Driver {
  std::unique_ptr<Controller> controller;
  MotionModel model;
  SimulationOptions simulation;
};

Expected<Driver, Error> driver_of(std::string_view controller, std::string_view robot,
                                  std::string_view simulation) {
  const auto its_name = parse_option_specs(controller, "controller", controllers().names());
  if (!its_name) return Unexpected<Error>(its_name.error());
  const OptionSpec& spec = its_name->front();
  auto made = make_controller(spec.name, spec.options);
  if (!made) return Unexpected<Error>(made.error());
  const auto robot_options = parse_option_specs(robot, "part", {"robot"});
  if (!robot_options) return Unexpected<Error>(robot_options.error());
  const auto model = parse_options<MotionModel>(robot_options->front().options);
  if (!model) return Unexpected<Error>(model.error());
  const auto simulation_options = parse_option_specs(simulation, "part", {"simulation"});
  if (!simulation_options) return Unexpected<Error>(simulation_options.error());
  const auto options = parse_options<SimulationOptions>(simulation_options->front().options);
  if (!options) return Unexpected<Error>(options.error());
  if (const auto why = why_unfit(*controllers().find(spec.name), *model)) {
    return Unexpected<Error>(Error{Status::invalid_option, *why});
  }
  return Driver{*std::move(made), *model, *options};
}

}  // namespace

std::string Lab::drive(std::string_view controller, std::string_view robot,
                       std::string_view simulation) {
  const auto view = session_.view();
  if (!view) return error_text(view.error());
  if (!path_ || path_->empty()) {
    return error_text({Status::unsupported_query, "there is no path to follow"});
  }
  auto driver = driver_of(controller, robot, simulation);
  if (!driver) return error_text(driver.error());
  driver->simulation.escape = std::max(driver->simulation.escape, escape_);
  const Drive drive =
      simulate(view->space, *path_, *driver->controller, driver->model, driver->simulation);
  if (drive.outcome == DriveOutcome::refused) {
    return error_text({Status::unsupported_query, drive.refusal});
  }
  points_.clear();
  for (const DriveSample& at : drive.samples) {
    points_.insert(points_.end(), {at.time, at.pose.x, at.pose.y, at.pose.heading,
                                   at.velocity.linear, at.cross_track, at.heading_error});
  }
  return Json()
      .object()
      .field("outcome", choice_name(drive.outcome))
      .field("told", describe(drive.outcome))
      .field("time", drive.time)
      .field("distance", drive.distance)
      .field("rms", drive.cross_track_rms)
      .field("largest", drive.cross_track_largest)
      .field("finalError", drive.final_error)
      .field("swings", drive.swings)
      .field("oscillates", drive.oscillates())
      .end_object()
      .text();
}

}  // namespace wend::lab
