#include "cli/arguments/trajectory_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/base/options.hpp"
#include "wend/io/path/trajectory_csv.hpp"
#include "wend/report/path_report.hpp"
#include "wend/session/plan_request.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kPeriods{1e-4, 1e3, "seconds"};
constexpr double kMostSamples = 1e6;

/// "speed 0.5, turn_rate 1.5, ..."
std::string default_limits() {
  std::string text;
  for (const OptionInfo& option : option_schema<TrajectoryLimits>()) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", option.name, option.default_value);
  }
  return text;
}

bool is_json(const std::string& file) { return OutputFiles::is(file, ".json"); }

void write_text(const std::string& file, const std::string& text) {
  const std::string wrong = write_bytes(file, text);
  if (!wrong.empty()) throw InputError(wrong);
}

}  // namespace

void TrajectoryArguments::add_file_to(Parser& app) {
  app.add_option("--trajectory", file_,
                 wrapped("Also write the fastest trajectory along the path within the limits (.csv "
                         "with the columns t,x,y,heading,v,w in seconds, metres and radians, or "
                         ".json). Corners are rounded as by --corner-rounding where the robot "
                         "fits; at others it stops and turns"))
      .type_name(kFileType);
  add_number(app, "--trajectory-period", period_, kPeriods,
             "Seconds between two rows of the trajectory (default 0.05)");
  app.further({"--trajectory-period"});
}

void TrajectoryArguments::add_limits_to(Parser& app) {
  app.add_option("--velocity-limits", limits_,
                 wrapped("Limits of the trajectory, as in speed=1,turn_rate=2 (m, s, rad; "
                         "turn_acceleration is that of turns in place; default " +
                         default_limits() + ")"))
      .type_name("NAME=VALUE,...");
  app.further({"--velocity-limits"});
}

void TrajectoryArguments::check(const Parser& command, const OutputFiles& output) const {
  if (!wanted()) {
    refuse_idle(command, {"--trajectory-period"}, "add --trajectory FILE");
    if (!limits_.empty()) {
      throw InputError("--velocity-limits changes nothing: add --trajectory FILE");
    }
    return;
  }
  if (!is_json(file_) && !OutputFiles::is(file_, ".csv")) {
    throw InputError(fmt::format("--trajectory {}: the file must end with .csv or .json", file_));
  }
  check_folder(file_, "--trajectory " + file_);
  if (std::ranges::find(output.files(), file_) != output.files().end()) {
    throw InputError(fmt::format("--trajectory {}: -o writes this file, too", file_));
  }
}

void TrajectoryArguments::check_not_among(const std::vector<std::filesystem::path>& inputs) const {
  if (wanted()) cli::check_not_among(inputs, file_, "--trajectory " + file_);
}

TrajectoryLimits TrajectoryArguments::limits() const {
  if (limits_.empty()) return {};
  const std::string name = "velocity-limits";
  const auto specs = parse_option_specs(name + ":" + limits_, "option", {name});
  if (!specs) throw InputError("--velocity-limits " + limits_ + ": " + specs.error().message);
  const auto limits = parse_options<TrajectoryLimits>(specs->front().options);
  if (!limits) throw InputError("--velocity-limits " + limits_ + ": " + limits.error().message);
  return *limits;
}

SampledTrajectory TrajectoryArguments::along(const Path& path, const FreeSpace& space,
                                             double window, Adjacency adjacency,
                                             const TrajectoryLimits& limits) const {
  auto trajectory = timed_path(path, space, adjacency, limits, window);
  if (!trajectory) throw InputError("the trajectory: " + trajectory.error().message);
  return sampled(*std::move(trajectory));
}

SampledTrajectory TrajectoryArguments::sampled(Trajectory trajectory) const {
  if (trajectory.duration() / period_ > kMostSamples) {
    throw InputError(fmt::format(
        "the trajectory takes {:.0f} s, more than {:.0f} rows: give a longer --trajectory-period",
        trajectory.duration(), kMostSamples));
  }
  return {std::move(trajectory), period_};
}

void TrajectoryArguments::write(const SampledTrajectory& sampled) const {
  if (!wanted()) return;
  write_text(file_, is_json(file_) ? trajectory_json(sampled)
                                   : trajectory_csv(sampled.trajectory, sampled.period));
}

void TrajectoryArguments::write_failure(const FailedPlan& plan) const {
  if (!wanted()) return;
  write_text(file_, is_json(file_) ? failed_plan_json(plan) : no_trajectory_csv(plan));
}

}  // namespace wend::cli
