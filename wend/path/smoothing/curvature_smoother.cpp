#include "wend/path/smoothing/curvature_smoother.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/path/smoothing/smoothing.hpp"

namespace wend {
namespace {

// Measured on random office plans: what meets the bound most often, and soonest.
constexpr std::uint64_t kGradientSweeps = 50;
constexpr double kEvening = 0.3;         // the share of the way to the middle of the neighbours
constexpr double kOverRelaxation = 1.8;  // how much farther than put right a bend is moved
constexpr double kWider = 1.01;          // what is aimed at, so that the bound is met some day
constexpr double kRounding = 1e-6;       // of the radius
constexpr double kMostRadii = 2;         // how far a point is moved unless that is said
constexpr double kStill = 1e-12;         // squared cells: a sweep that changes less ends it all

std::optional<std::string> fault_of(const CurvatureOptions& options) {
  if (!(options.radius >= 0 && std::isfinite(options.radius))) {
    return "the radius must be finite and not negative";
  }
  if (!(options.max_distance >= 0)) return "max_distance must be at least 0";
  if (options.max_sweeps < 1) return "max_sweeps must be at least 1";
  return fault_of_weights(options.alpha, options.beta, true);
}

/// The options as text, for the schema: a length for people.
struct CurvatureFlags : CurvatureOptions {
  double turning_radius = 0;  // m

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"turning_radius",
           "lower limit on the turning radius, in metres (in cells on maps in cells); 0: radius "
           "applies"},
          self.turning_radius, OptionRange{0, 1e6});
    CurvatureOptions::fields(self, field);
  }
};

/// The longest line on which arcs within kCornerRounding of the points can have the radius.
double longest_line(double radius) {
  constexpr double kLongest = 1.5;  // cells: steps to neighbouring cells stay whole
  constexpr double kShortest = 0.1;
  return std::clamp(radius / 2, kShortest, kLongest);
}

/// The same way with points near enough to each other.
Path divided(std::span<const Point> points, double longest) {
  std::vector<Point> dense{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Line line{points[i - 1], points[i]};
    const int pieces = std::max(1, static_cast<int>(std::ceil(line.length() / longest)));
    for (int k = 1; k < pieces; ++k) dense.push_back(line.at(k / static_cast<double>(pieces)));
    dense.push_back(line.to);
  }
  return Path::along(std::move(dense));
}

/// How far the middle one of three points is to move towards the others, or they towards it, until its
/// corner can be rounded with a turning radius; and the direction in which it is to move.
struct Bend {
  double excess = 0;
  Point inwards;
};

Bend bend_of(Point a, Point b, Point c, double radius) {
  const double before = distance(a, b);
  const double after = distance(b, c);
  if (before == 0 || after == 0) return {};
  const Corner corner(a, b, c);
  const double widest = corner.widest_half_turn(radius, kCornerRounding);
  if (corner.half_turn_tangent() <= widest) return {};
  if (corner.half_turn_tangent() > 1) {  // it turns back: the line through the others leads nowhere
    const Point to_middle{(a.x + c.x) / 2 - b.x, (a.y + c.y) / 2 - b.y};
    const double way = hypotenuse(to_middle.x, to_middle.y);
    return {way, {to_middle.x / way, to_middle.y / way}};
  }
  const double length = distance(a, c);
  const Point across{(a.y - c.y) / length, (c.x - a.x) / length};
  const double off = (a.x - b.x) * across.x + (a.y - b.y) * across.y;
  // The triangle is 2 |ab| |bc| sin(turn) = 2 off |ac| large.
  const double most = before * after * 2 * widest / (1 + widest * widest) / length;
  const double side = off < 0 ? -1 : 1;
  return {std::max(0.0, std::abs(off) - most), {side * across.x, side * across.y}};
}

/// Can every corner be rounded with that radius? Points on top of each other count once.
bool is_within(std::vector<Point> points, double radius) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (std::size_t i = 2; i < points.size(); ++i) {
    const Corner corner(points[i - 2], points[i - 1], points[i]);
    if (corner.radius(kCornerRounding) < radius * (1 - kRounding)) return false;
  }
  return true;
}

/// Moves the points of a path, sweep by sweep.
class CurvatureSweeps {
 public:
  CurvatureSweeps(const Path& path, MovablePath moved, const CurvatureOptions& options,
                  const StopSmoothing& stop)
      : path_(path.points()),
        moved_(std::move(moved)),
        options_(options),
        stop_(stop),
        held_(path_.size()) {}

  Smoothed run() && {
    Smoothed result;
    const auto most = static_cast<std::uint64_t>(options_.max_sweeps);
    while (!result.converged && result.sweeps < most) {
      if (stop_.before_sweep()) break;
      begin_sweep();
      if (result.sweeps < kGradientSweeps) {
        for_each_inner([&](std::size_t i) { descend(i); });
      } else if (is_within(points(), options_.radius)) {
        result.converged = true;
        break;
      } else {
        for_each_inner([&](std::size_t i) { even_out(i), widen(i); });
        backwards_ = !backwards_;  // what is moved at one end soon reaches the other
        result.converged = squared_change_ < kStill;
      }
      if (stop_.stopped()) {
        result.converged = false;
        break;
      }
      ++result.sweeps;
    }
    result.stopped = stop_.stopped();
    const auto held = std::count(held_.begin(), held_.end(), true);
    if (path_.size() > 2) {
      result.held = static_cast<double>(held) / static_cast<double>(path_.size() - 2);
    }
    moved_.finish(result, Path::along(path_));
    result.within_bound = is_within(result.path.points(), options_.radius);
    result.converged = result.converged || result.within_bound;
    return result;
  }

 private:
  std::vector<Point> points() const { return {moved_.points().begin(), moved_.points().end()}; }
  Point at(std::size_t i) const { return moved_.points()[i]; }

  void begin_sweep() {
    held_.assign(path_.size(), false);
    squared_change_ = 0;
  }

  template <class Visit>
  void for_each_inner(Visit&& visit) {
    for (std::size_t i = 1; i + 1 < path_.size() && !stop_.before_point(); ++i) {
      visit(backwards_ ? path_.size() - 1 - i : i);
    }
  }

  void move(std::size_t i, Point by) {
    if (i == 0 || i + 1 == path_.size()) return;
    const Point before = at(i);
    if (moved_.move(i, {before.x + by.x, before.y + by.y}) < 1) held_[i] = true;
    const Point change{at(i).x - before.x, at(i).y - before.y};
    squared_change_ += change.x * change.x + change.y * change.y;
  }

  /// The gradient-descent step, in place.
  void descend(std::size_t i) {
    const Point b = at(i);
    const double alpha = options_.alpha;
    const double beta = options_.beta;
    move(i, {alpha * (path_[i].x - b.x) + beta * (at(i - 1).x + at(i + 1).x - 2 * b.x),
             alpha * (path_[i].y - b.y) + beta * (at(i - 1).y + at(i + 1).y - 2 * b.y)});
  }

  /// Towards equal distances from both neighbours, without bending more or less: bends would push
  /// their points together.
  void even_out(std::size_t i) {
    const Point chord{at(i + 1).x - at(i - 1).x, at(i + 1).y - at(i - 1).y};
    const double squared = chord.x * chord.x + chord.y * chord.y;
    if (squared == 0) return;
    const Point to_middle{(at(i - 1).x + at(i + 1).x) / 2 - at(i).x,
                          (at(i - 1).y + at(i + 1).y) / 2 - at(i).y};
    const double share = kEvening * (to_middle.x * chord.x + to_middle.y * chord.y) / squared;
    move(i, {share * chord.x, share * chord.y});
  }

  /// The point towards the line through its neighbours, and these away: the least that widens the
  /// bend as far as it should be, and somewhat more.
  void widen(std::size_t i) {
    const Bend bend = bend_of(at(i - 1), at(i), at(i + 1), kWider * options_.radius);
    if (bend.excess == 0) return;
    const double step = kOverRelaxation * bend.excess / 3;
    move(i, {2 * step * bend.inwards.x, 2 * step * bend.inwards.y});
    move(i - 1, {-step * bend.inwards.x, -step * bend.inwards.y});
    move(i + 1, {-step * bend.inwards.x, -step * bend.inwards.y});
  }

  std::vector<Point> path_;
  MovablePath moved_;
  CurvatureOptions options_;
  StopCheck stop_;
  std::vector<bool> held_;  // points that did not go all the way in this sweep
  double squared_change_ = 0;
  bool backwards_ = false;
};

}  // namespace

SmoothingResult smooth_by_curvature(const Path& path, const FreeSpace& space,
                                    const CurvatureOptions& options, const StopSmoothing& stop) {
  if (const auto fault = fault_of(options)) return failure(Status::invalid_option, *fault);
  if (auto fault = fault_of(path, space)) return Unexpected<Error>(*std::move(fault));
  const double longest = longest_line(options.radius);
  if (path.length() / longest > static_cast<double>(kMostResampled)) {
    return failure(Status::unsupported_query,
                   "the path is too long for its smoother: " + format_number(path.length()) +
                       " cells in lines of " + format_number(longest) + " make more than " +
                       std::to_string(kMostResampled) + " points");
  }
  const Path dense =
      path.visit([&](const JoinedPoses&) { return path; },  // which MovablePath refuses
                 [&](const auto&) { return divided(path.points(), longest); });
  auto movable = MovablePath::from(dense, space, options);
  if (!movable) return Unexpected<Error>(std::move(movable).error());
  movable->bind(options.max_distance > 0 ? options.max_distance : kMostRadii * options.radius);
  return CurvatureSweeps(dense, *std::move(movable), options, stop).run();
}

SmootherInfo curvature_smoother() {
  return smoother_with<CurvatureFlags>(
      "curvature", "Limits the curvature to a turning radius where obstacles leave room for it",
      "Kaczmarz 1937; Mueller and others 2007, Position based dynamics",
      [](const Path& path, const FreeSpace& space, CurvatureFlags flags,
         const StopSmoothing& stop) {
        const double resolution = space.map().frame().resolution;
        if (flags.turning_radius > 0) flags.radius = flags.turning_radius / resolution;
        return smooth_by_curvature(path, space, flags, stop);
      });
}

}  // namespace wend
