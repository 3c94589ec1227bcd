#pragma once

// --trajectory FILE, and how the trajectory is made: --velocity-limits and --trajectory-period.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/parser.hpp"
#include "cli/output/output.hpp"
#include "wend/io/file_error.hpp"
#include "wend/path/refinement.hpp"
#include "wend/report/trajectory_report.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

class TrajectoryArguments {
 public:
  /// --trajectory and --trajectory-period.
  void add_file_to(Parser& app);

  /// --velocity-limits, for commands without a robot's own.
  void add_limits_to(Parser& app);

  bool wanted() const { return !file_.empty(); }

  /// Throws InputError for a file that is neither CSV nor JSON, or that -o writes too, for a missing
  /// folder, and for flags that change nothing without --trajectory.
  void check(const Parser& command, const OutputFiles& output) const;

  /// Throws InputError if the file is among the inputs.
  void check_not_among(const std::vector<std::filesystem::path>& inputs) const;

  /// What --velocity-limits says. Throws InputError for limits out of range.
  TrajectoryLimits limits() const;

  /// The trajectory along a path with its corners rounded within a window, in cells. Throws InputError if there is
  /// none, or if it would be too long for a file.
  SampledTrajectory along(const Path& path, const FreeSpace& space, double window,
                          Adjacency adjacency, const TrajectoryLimits& limits) const;
  /// The same of a trajectory that exists.
  SampledTrajectory sampled(Trajectory trajectory) const;

  /// Writes the file, if one is wanted; of a failure the reason. Throws InputError if it cannot be
  /// written.
  void write(const SampledTrajectory& sampled) const;
  void write_failure(const FailedPlan& plan) const;

 private:
  std::string file_;
  std::string limits_;
  double period_ = 0.05;  // s
};

}  // namespace wend::cli
