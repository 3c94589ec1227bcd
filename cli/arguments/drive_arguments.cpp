#include "cli/arguments/drive_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "wend/base/parse.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kNoise{0, 10};

/// --loop sets it.
bool is_closed(const OptionInfo& option) { return option.name == "closed"; }

template <class Options>
Options parsed(const OptionValues& values) {
  return value_or_throw(parse_options<Options>(values));
}

/// The name that stands for a TrajectoryTracker: it is made for a path, so it is not in the registry.
constexpr std::string_view kTracker = "trajectory";

/// The options of the tracker. The trajectory takes its other limits from the robot.
struct TrackerOptions {
  TrackingGains gains{};
  double lateral_acceleration = TrajectoryLimits{}.lateral_acceleration;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    TrackingGains::fields(self.gains, field);
    field({"lateral_acceleration", "upper limit on the lateral acceleration in curves, m/s^2"},
          self.lateral_acceleration, {1e-3, 1e3});
  }
};

ChosenController made(const OptionSpec& spec, const MotionModel& robot) {
  if (spec.name == kTracker) {
    return {spec.text, nullptr, parsed<TrackerOptions>(spec.options).gains};
  }
  const ControllerInfo& info = *wend::controllers().find(spec.name);
  if (const auto why = why_unfit(info, robot)) throw InputError(*why);
  auto controller = info.make(spec.options);
  if (!controller) throw InputError(spec.name + ": " + controller.error().message);
  return {spec.text, *std::move(controller), {}};
}

std::vector<OptionSpec> parse_controllers(const std::string& list) {
  return value_or_throw(parse_option_specs(list, "controller", controller_names()));
}

/// Every controller that the robot can obey.
std::vector<OptionSpec> all_for(const MotionModel& robot) {
  std::vector<OptionSpec> specs;
  for (const ControllerInfo& info : wend::controllers()) {
    if (!why_unfit(info, robot)) specs.push_back({info.name, {}, info.name});
  }
  return specs;
}

std::string summaries() {
  std::string text;
  for (const ControllerInfo& info : wend::controllers()) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", info.name, info.summary);
  }
  return text + fmt::format("; {}: tracks the trajectory of --trajectory", kTracker);
}

}  // namespace

std::vector<std::string> controller_names() {
  auto names = wend::controllers().names();
  names.emplace_back(kTracker);
  return names;
}

void DriveArguments::add_to(Parser& app) {
  app.add_option("--controller", controller_,
                 wrapped("Controller (default pure_pursuit, stanley for a path of poses); options "
                         "may follow, as "
                         "in pid:heading_gain=3. " +
                         summaries()))
      .type_name(kControllerType);
  const auto compare = [this](const std::string& text) { compared_ = text; };
  app.add_option("--compare", compare,
                 wrapped("Simulate each of these controllers instead, or all of them; options may "
                         "follow each name, as in --compare=p,pid:heading_gain=3"))
      .optional_value()
      .type_name("[" + std::string(kControllerType) + ",...]");
  add_number(app, "--noise", noise_, kNoise,
             "Set all noise at once, like --actuation-noise S --position-noise S (metres) "
             "--heading-noise S (radians)")
      .type_name("S");
  for (const ControllerInfo& info : wend::controllers()) {
    controller_options_.collect(info.name, info.options);
  }
  controller_options_.collect(std::string(kTracker), option_schema<TrackerOptions>());
  std::vector<OptionInfo> simulation = option_schema<SimulationOptions>();
  std::erase_if(simulation, is_closed);
  simulation_.collect("", simulation);
  following_.collect("", option_schema<FollowerOptions>());
  robot_.collect("", option_schema<MotionModel>());
  for (OptionFlags* flags : {&simulation_, &robot_, &following_}) flags->add_to(app);
  controller_options_.add_to(app, "--controller");
}

SimulationOptions DriveArguments::simulation(bool loop) const {
  OptionValues values;
  for (const char* name : {"actuation_noise", "position_noise", "heading_noise"}) {
    if (noise_) values.emplace_back(name, format_number(*noise_));
  }
  const OptionValues given = simulation_.values_for("");
  values.insert(values.end(), given.begin(), given.end());
  auto options = parsed<SimulationOptions>(values);
  options.closed = loop;
  return options;
}

FollowerOptions DriveArguments::following() const {
  return parsed<FollowerOptions>(following_.values_for(""));
}

MotionModel DriveArguments::robot() const { return parsed<MotionModel>(robot_.values_for("")); }

TrajectoryLimits DriveArguments::trajectory_limits() const {
  const VelocityLimits robot_limits = robot().limits;
  OptionValues values;
  if (const auto given = controller_options_.given("lateral_acceleration")) {
    values.emplace_back("lateral_acceleration", *given);
  }
  const std::string names = compared_.value_or(controller_);
  const auto specs = names.empty() ? std::vector<OptionSpec>() : parse_controllers(names);
  for (const OptionSpec& spec : specs) {
    if (spec.name != kTracker) continue;
    values.insert(values.end(), spec.options.begin(), spec.options.end());
  }
  return {.speed = robot_limits.speed,
          .turn_rate = robot_limits.turn_rate,
          .acceleration = robot_limits.acceleration,
          .turn_acceleration = robot_limits.turn_acceleration,
          .lateral_acceleration = parsed<TrackerOptions>(values).lateral_acceleration};
}

void DriveArguments::check_controllers(const MotionModel& robot) const {
  if (controller_.empty() && !compared_) return;
  controllers(robot, Path());
}

std::vector<ChosenController> DriveArguments::controllers(const MotionModel& robot,
                                                          const Path& path) const {
  std::vector<OptionSpec> specs;
  if (compared_) {
    specs = compared_->empty() ? all_for(robot) : parse_controllers(*compared_);
    for (const OptionSpec& spec : specs) {
      if (!controller_options_.values_for(spec.name).empty()) {
        throw InputError("--compare: options follow each controller, as in pid:heading_gain=3");
      }
    }
  } else {
    const std::string name(default_controller(path));
    specs = parse_controllers(controller_.empty() ? name : controller_);
    if (specs.size() > 1) {
      throw InputError(fmt::format(
          "--controller {}: --controller takes exactly one controller; --compare takes several",
          controller_));
    }
    const OptionValues flags = controller_options_.values_for(specs.front().name);
    specs.front().options.insert(specs.front().options.end(), flags.begin(), flags.end());
  }
  std::vector<ChosenController> chosen;
  chosen.reserve(specs.size());
  for (const OptionSpec& spec : specs) chosen.push_back(made(spec, robot));
  return chosen;
}

}  // namespace wend::cli
