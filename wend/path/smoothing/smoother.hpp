#pragma once

// Smoothers: what makes a path smooth, by name and with options. See gradient_smoother.hpp and
// curvature_smoother.hpp, for paths of cells or waypoints, and drive_smoother.hpp, for paths of poses.
//
//   const auto smoother = wend::make_smoother("gradient", {{"beta", "0.4"}});
//   if (!smoother) return report(smoother.error().message);
//   const auto smoothed = (*smoother)(plan->path, space);
//   if (!smoothed) report(smoothed.error().message);
//
// A smoother keeps the path's ends. Unless its option `unsafe` is set, it takes a free path (see
// path_collision.hpp) and gives a free one, no longer than it (`drive`: or as its option `longer` allows): where smoothing would leave free
// space it holds back. Thread-safe.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/options.hpp"
#include "wend/base/registry.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// A smoothed path, and how smoothing went.
struct Smoothed {
  Path path;                 // waypoints, at least as many as the path had points
  std::uint64_t sweeps = 0;  // over all points
  bool converged = false;    // else the limit of sweeps ended it
  double held = 0;  // the share of the inner points, 0 to 1, that obstacles or a bound held back
  bool returned = false;  // the result would have been longer than the path: it is the path
  bool stopped = false;   // StopSmoothing ended it: the path is as far as it came
  double distance = 0;    // cells: largest_distance() between the path and the smoothed one

  // Of the smoother that bounds curvature.
  bool within_bound = true;  // every bend is as wide as asked
};

/// Errors: invalid_option, or unsupported_query for a drive, a path with a fault (path_fault.hpp) or one that is not
/// free.
using SmoothingResult = Expected<Smoothed, Error>;

/// Asked while a path is smoothed, before every sweep and every thousand points: should that end now? Nothing: never.
using StopSmoothing = std::function<bool()>;

/// A smoother with its options. Thread-safe.
class Smoother {
 public:
  /// What smooths.
  using Function =
      std::function<SmoothingResult(const Path&, const FreeSpace&, const StopSmoothing&)>;

  /// Of a function that is set.
  explicit Smoother(Function smooth) : smooth_(std::move(smooth)) {}

  /// Smooths a path. If `stop` says so, the result is what it is then: free, and not yet as smooth as it could be.
  SmoothingResult operator()(const Path& path, const FreeSpace& space,
                             const StopSmoothing& stop = {}) const {
    return smooth_(path, space, stop);
  }

 private:
  Function smooth_;
};

/// A smoother, or why it could not be made: invalid_option.
using SmootherResult = Expected<Smoother, Error>;

/// A smoother: its description, its options, and the function.
struct SmootherInfo {
  std::string name;                                         // as in options
  std::string summary;                                      // one line
  std::string citation;                                     // the paper or book it comes from
  std::vector<OptionInfo> options;                          // which `make` takes
  std::function<SmootherResult(const OptionValues&)> make;  // from options as text
  bool drives = false;                                      // takes paths of poses, and only these
};

/// gradient, curvature, drive.
WEND_API const Registry<SmootherInfo>& smoothers();

/// Makes a smoother by name; an unknown name or option is Status::invalid_option.
WEND_API SmootherResult make_smoother(std::string_view name, const OptionValues& options = {});

}  // namespace wend
