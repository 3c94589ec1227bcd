#include "wend/path/smoothing/drive_smoother.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/path/largest_distance.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/smoothing/drive_window.hpp"
#include "wend/path/smoothing/smoothing.hpp"

namespace wend {
namespace {

constexpr double kSpacing = 1.0 / 3;  // turning radii: longer pieces are cut
constexpr double kShortest = 1e-3;    // turning radii: shorter pieces stay as they are
constexpr double kOnCourse = 1e-9;    // radians: a larger course is a step to the side
constexpr double kCurvature = 1e-7;   // of the bound: rounding
constexpr std::size_t kWindow = 12;   // pieces
constexpr double kLeastGain = 1e-6;   // of the objective of a window
constexpr double kConverged = 1e-3;   // of the gain of the first sweep
constexpr std::array<double, 3> kFactors{1, 0.4, 0.1};

std::optional<Error> fault_of(const DriveSmootherOptions& options) {
  for (const double number : {options.turning_radius, options.alpha, options.beta,
                              options.clearance, options.clearance_weight, options.longer}) {
    if (number >= 0 && std::isfinite(number)) continue;
    return Error{Status::invalid_option,
                 "the options of the smoother of drives must be finite and not negative"};
  }
  return std::nullopt;
}

double curvature_of(const Segment& segment) { return segment.turn / segment.length; }

/// Is it a line or an arc that a car drives?
bool is_driven(const Segment& segment) {
  return segment.length != 0 && std::abs(segment.course) <= kOnCourse;
}

/// Of the tightest arc that a car drives.
double tightest_radius(const Path& path) {
  double radius = std::numeric_limits<double>::infinity();
  for (const Segment& segment : path.segments()) {
    if (is_driven(segment)) radius = std::min(radius, 1 / std::abs(curvature_of(segment)));
  }
  return radius;
}

std::vector<Pose> cut(const Path& path, double spacing) {
  const JoinedPoses joined(path.driven_poses());
  std::vector<Pose> poses{joined.poses().front()};
  for (std::size_t i = 0; i < joined.segment_count(); ++i) {
    const Segment segment = joined.segment(i);
    const double pieces = std::max(std::ceil(std::abs(segment.length) / spacing), 1.0);
    for (int k = 1; k < static_cast<int>(pieces); ++k)
      poses.push_back(pose_on(segment, k / pieces));
    poses.push_back(joined.poses()[i + 1]);
  }
  return poses;
}

class DriveSweeps {
 public:
  DriveSweeps(const Path& path, const FreeSpace& space, const DriveObjective& objective,
              const DriveSmootherOptions& options, const StopSmoothing& stop)
      : space_(space),
        objective_(objective),
        options_(options),
        stop_(stop),
        poses_(cut(path, kSpacing * objective.radius)),
        places_(poses_),
        longest_(path.length() * (1 + options.longer)),
        length_(path.length()) {}

  Smoothed run() {
    Smoothed smoothed;
    double first_gain = 0;
    while (!smoothed.converged &&
           smoothed.sweeps < static_cast<std::uint64_t>(options_.max_sweeps)) {
      if (is_stopped()) break;
      const double gain = sweep(smoothed.sweeps % 2 == 0 ? 0 : kWindow / 4);
      if (stopped_) break;
      if (smoothed.sweeps++ == 0) first_gain = gain;
      smoothed.converged = smoothed.sweeps > 1 && gain <= kConverged * first_gain;
    }
    smoothed.held = windows_ > 0 ? static_cast<double>(held_) / static_cast<double>(windows_) : 0;
    smoothed.path = Path::through(poses_);
    smoothed.stopped = stopped_;
    return smoothed;
  }

  bool changed() const { return changed_; }

  double objective() const {
    double sum = 0;
    for (std::size_t first = 0; first < piece_count(); ++first) {
      if (const auto window = window_of(first, first + 1, false)) sum += window->objective();
    }
    return sum;
  }

 private:
  /// A window takes far longer than the question.
  bool is_stopped() {
    stopped_ = stopped_ || (stop_ && stop_());
    return stopped_;
  }

  std::size_t piece_count() const { return poses_.size() - 1; }
  Segment piece(std::size_t i) const { return segment_between(poses_[i], poses_[i + 1]); }

  bool movable(std::size_t i) const {
    const Segment segment = piece(i);
    return is_driven(segment) && std::abs(segment.length) >= kShortest * objective_.radius;
  }

  /// The curvature of a neighbour, if it is driven in the same gear.
  std::optional<double> neighbour(std::size_t i, double length) const {
    if (i >= piece_count() || !movable(i) || piece(i).length * length < 0) return std::nullopt;
    return curvature_of(piece(i));
  }

  /// Of pieces that are all movable; `both` neighbours, or only the one before.
  std::optional<DriveWindow> window_of(std::size_t first, std::size_t end, bool both) const {
    std::vector<DrivePiece> pieces;
    for (std::size_t i = first; i < end; ++i) {
      if (!movable(i)) return std::nullopt;
      const Segment segment = piece(i);
      const double most = 1 / objective_.radius;
      pieces.push_back({segment.length, std::clamp(curvature_of(segment), -most, most)});
    }
    const auto before = first > 0 ? neighbour(first - 1, pieces.front().length) : std::nullopt;
    const auto after = both ? neighbour(end, pieces.back().length) : std::nullopt;
    return DriveWindow(space_, objective_, poses_[first], std::move(pieces), before, after);
  }

  /// All windows, each half over the one before. The gain of the objective.
  double sweep(std::size_t offset) {
    double gain = 0;
    windows_ = 0;
    held_ = 0;
    for (std::size_t first = offset; first < piece_count() && !is_stopped(); first += kWindow / 2) {
      std::size_t end = first;
      while (end < std::min(first + kWindow, piece_count()) && movable(end)) ++end;
      if (end - first >= 2) gain += improve(first, end);
    }
    return gain;
  }

  double improve(std::size_t first, std::size_t end) {
    auto made = window_of(first, end, true);
    if (!made) return 0;
    auto& window = *made;
    ++windows_;
    const double before = window.objective();
    bool blocked = false;
    for (const double factor : kFactors) {
      const auto pieces = window.step(factor);
      if (!pieces) continue;
      const double gain = before - window.objective_of(*pieces);
      if (!(gain > kLeastGain * before)) continue;
      std::vector<Pose> poses = window.poses_of(*pieces);
      poses.back() = poses_[end];
      const double length = length_ - window.length() + length_of(*pieces);
      const Path part = Path::through(poses);
      if (is_too_far(poses, first)) continue;
      if (length > longest_ || !drivable(part)) continue;
      if (first_collision(part, space_)) {
        blocked = true;
        continue;
      }
      std::ranges::copy(poses, poses_.begin() + static_cast<std::ptrdiff_t>(first));
      length_ = length;
      changed_ = true;
      return gain;
    }
    if (blocked) ++held_;
    return 0;
  }

  /// Are poses, of which the first is the one with that index, farther from where they were than allowed?
  bool is_too_far(const std::vector<Pose>& poses, std::size_t first) const {
    if (options_.max_distance == 0) return false;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Point place = places_[first + i].point();
      if (distance(place, poses[i].point()) > options_.max_distance) return true;
    }
    return false;
  }

  static double length_of(const std::vector<DrivePiece>& pieces) {
    double sum = 0;
    for (const DrivePiece& piece : pieces) sum += std::abs(piece.length);
    return sum;
  }

  /// By the segments between the poses themselves, which is what a robot gets.
  bool drivable(const Path& part) const {
    return std::ranges::all_of(part.segments(), [this](const Segment& segment) {
      return is_driven(segment) &&
             std::abs(curvature_of(segment)) * objective_.radius <= 1 + kCurvature;
    });
  }

  const FreeSpace& space_;
  DriveObjective objective_;
  DriveSmootherOptions options_;
  const StopSmoothing& stop_;
  std::vector<Pose> poses_;
  std::vector<Pose> places_;  // of the poses before anything was smoothed
  double longest_;            // cells
  double length_;             // cells
  std::size_t windows_ = 0;   // of this sweep
  std::size_t held_ = 0;      // of these, by obstacles
  bool changed_ = false;
  bool stopped_ = false;
};

/// Of a path with arcs.
DriveObjective objective_for(const Path& path, const FreeSpace& space,
                             const DriveSmootherOptions& options) {
  const double resolution = space.map().frame().resolution;
  const double own = tightest_radius(path);
  const double wanted = options.turning_radius / resolution;
  const double inscribed = space.footprint().inscribed_radius() / resolution;
  return {.radius = wanted > 0 ? std::min(wanted, own) : own,
          .change_weight = options.alpha,
          .bend_weight = options.beta,
          .clearance_weight = options.clearance_weight,
          .clearance = options.clearance > 0 ? inscribed + options.clearance / resolution : 0};
}

/// Why a path cannot be cut into pieces to be smoothed.
std::optional<Error> fault_of(const Path& path, const FreeSpace& space,
                              const DriveSmootherOptions& options) {
  if (auto fault = fault_of(options)) return fault;
  if (auto fault = wend::fault_of(path, space)) return fault;
  if (!path.driven()) {
    return Error{Status::unsupported_query,
                 "the smoother of drives needs a path of poses: use the smoother gradient",
                 {}};
  }
  const double radius = objective_for(path, space, options).radius;
  const double pieces = path.length() / (kSpacing * radius) + static_cast<double>(path.size());
  if (!(pieces > kMostDrivePieces)) return std::nullopt;
  return Error{Status::unsupported_query,
               "the path is too long for its turning radius of " + format_number(radius) +
                   " cells: it would be cut into more than " + std::to_string(kMostDrivePieces) +
                   " pieces",
               {}};
}

}  // namespace

SmoothingResult smooth_drive(const Path& path, const FreeSpace& space,
                             const DriveSmootherOptions& options, const StopSmoothing& stop) {
  if (auto fault = fault_of(path, space, options)) return Unexpected<Error>(*std::move(fault));
  if (const auto collision = first_collision(path, space)) {
    return failure(Status::unsupported_query, text_of(*collision));
  }
  constexpr double kRounding = 1e-6;
  const double wanted = options.turning_radius / space.map().frame().resolution;
  const bool within = tightest_radius(path) >= wanted * (1 - kRounding);
  const DriveObjective objective = objective_for(path, space, options);
  Smoothed unchanged{.path = path, .converged = true, .within_bound = within};
  if (!std::isfinite(objective.radius)) return unchanged;
  DriveSweeps sweeps(path, space, objective, options, stop);
  Smoothed smoothed = sweeps.run();
  smoothed.within_bound = within;
  if (!sweeps.changed()) smoothed.path = path;
  smoothed.distance = largest_distance(path, smoothed.path);
  return smoothed;
}

Expected<double, Error> drive_roughness(const Path& path, const FreeSpace& space,
                                        const DriveSmootherOptions& options) {
  if (auto fault = fault_of(path, space, options)) return Unexpected<Error>(*std::move(fault));
  const DriveObjective objective = objective_for(path, space, options);
  if (!std::isfinite(objective.radius)) return path.length();
  const StopSmoothing never;
  return DriveSweeps(path, space, objective, options, never).objective();
}

SmootherInfo drive_smoother() {
  SmootherInfo info = smoother_with<DriveSmootherOptions>(
      "drive", "Widens the arcs of a path of poses, with a least turning radius",
      "Dolgov, Thrun, Montemerlo, Diebel 2010",
      [](const Path& path, const FreeSpace& space, const DriveSmootherOptions& options,
         const StopSmoothing& stop) { return smooth_drive(path, space, options, stop); });
  info.drives = true;
  return info;
}

}  // namespace wend
