#include "wend/path/smoothing/smoothing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/path/largest_distance.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"

namespace wend {
std::string text_of(const PathCollision& collision) {
  constexpr double kShown = 1000;  // thousandths of a cell
  const auto rounded = [](double value) {
    return format_number(std::round(value * kShown) / kShown);
  };
  return "the path is not free: " + rounded(collision.along) + " cells along it, at (" +
         rounded(collision.point.x) + ", " + rounded(collision.point.y) + "), it " +
         std::string(describe(collision.kind));
}

std::optional<std::string> fault_of_weights(double alpha, double beta, bool in_place) {
  if (!(alpha >= 0 && beta >= 0 && std::isfinite(alpha) && std::isfinite(beta))) {
    return "alpha and beta must be finite and not negative";
  }
  const double neighbours = in_place ? 2 : 4;
  const double sum = alpha + neighbours * beta;
  if (sum < 2) return std::nullopt;
  std::string what = std::string(in_place ? "alpha + 2 beta" : "alpha + 4 beta") + " is " +
                     format_number(sum) + ", and sweeps diverge unless it is less than 2";
  if (alpha < 2) {
    what += ": with this alpha, beta must be less than " + format_number((2 - alpha) / neighbours);
    if (!in_place && alpha + 2 * beta < 2) what += ", or set in_place";
  }
  return what;
}

Expected<MovablePath, Error> MovablePath::from(const Path& path, const FreeSpace& space,
                                               std::optional<Adjacency> adjacency) {
  if (path.driven()) {
    return failure(
        Status::unsupported_query,
        "a path of poses is not smoothed: its arcs and turns are ones that the robot can drive");
  }
  if (auto fault = fault_of(path, space)) return Unexpected<Error>(*std::move(fault));
  MovablePath movable(space, path.points(), adjacency);
  if (adjacency && !movable.look_around()) {
    if (const auto collision = first_collision(path, space, *adjacency)) {
      return failure(Status::unsupported_query, text_of(*collision));
    }
  }
  return movable;
}

double MovablePath::move_within_bound(std::size_t i, Point to) {
  assert(bound_);
  const Point place = bound_->places[i];
  const double away = distance(place, to);
  if (away <= bound_->most) return move_freely(i, to);
  const double share = move_freely(i, Line{place, to}.at(bound_->most / away));
  constexpr double kHeld = 0.99;
  return std::min(share, kHeld);
}

/// What the disc around the robot says.
MovablePath::Beside MovablePath::look_beside(const Line& line) const {
  assert(adjacency_);
  const auto room = room_along(*space_, line, *adjacency_);
  return {line, room ? *room * *room : 0, room.has_value()};
}

std::optional<MovablePath::Beside> MovablePath::free_beside(const Line& line) const {
  const Beside beside = look_beside(line);
  const bool free = beside.any_heading || (space_->outline() && fits_along(*space_, line));
  return free ? std::optional(beside) : std::nullopt;
}

/// Says whether all lines are seen to be free at every heading. One in a gap between two obstacles is
/// not.
bool MovablePath::look_around() {
  bool free = on_map(points_.front()) && points_.size() > 1;
  beside_.reserve(points_.size());
  rests_.resize(points_.size());
  for (std::size_t i = 1; i < points_.size(); ++i) {
    beside_.push_back(look_beside({points_[i - 1], points_[i]}));
    free = free && beside_.back().any_heading && on_map(points_[i]);
  }
  return free;
}

/// Can a polygon turn at a point from the line before to the line after it? Lines of length 0 have no
/// heading.
bool MovablePath::turn_fits(std::size_t i) const {
  std::size_t before = i;
  while (before > 0 && points_[before - 1] == points_[i]) --before;
  std::size_t after = i;
  while (after + 1 < points_.size() && points_[after + 1] == points_[i]) ++after;
  if (before == 0 || after + 1 == points_.size()) return true;
  if (beside_[before - 1].any_heading || beside_[after].any_heading) return true;
  const double arrival = Line{points_[before - 1], points_[i]}.heading();
  const double departure = Line{points_[i], points_[after + 1]}.heading();
  return turns_with_margin(*space_, points_[i], arrival, departure);
}

/// The turns that change if point i moves.
bool MovablePath::turns_fit_around(std::size_t i) const {
  return !space_->outline() || (turn_fits(i - 1) && turn_fits(i) && turn_fits(i + 1));
}

// Measured on office plans and in clutter: halves and quarters leave the objective within 0.1 %, and
// rests do not change it; together they halve the time.
double MovablePath::move_as_far_as_free(std::size_t i, Point to) {
  Rest& rest = rests_[i];
  if (rest.left > 0) {
    --rest.left;
    return 0;
  }
  constexpr double kLittle = 0.125;
  const bool all = try_move(i, to);
  if (all || try_move(i, Line{points_[i], to}.at(kLittle))) {
    rest = {};
    return all ? 1 : kLittle;
  }
  constexpr int kLongest = 8;
  rest.before = std::clamp(2 * rest.before, 1, kLongest);
  rest.left = rest.before;
  return 0;
}

bool MovablePath::try_move(std::size_t i, Point to) {
  if (!on_map(to)) return false;
  std::optional<Beside> before = beside_[i - 1];
  std::optional<Beside> after = beside_[i];
  if (!before->allows_end(to)) before = free_beside({points_[i - 1], to});
  if (!before) return false;
  if (!after->allows_begin(to)) after = free_beside({to, points_[i + 1]});
  if (!after) return false;
  std::swap(points_[i], to);
  std::swap(beside_[i - 1], *before);
  std::swap(beside_[i], *after);
  if (turns_fit_around(i)) return true;
  points_[i] = to;
  beside_[i - 1] = *before;
  beside_[i] = *after;
  return false;
}

void MovablePath::finish(Smoothed& smoothed, const Path& path) const {
  smoothed.path = Path::along(points_);
  smoothed.distance = largest_distance(path, smoothed.path);
  const double longest = path.length() * (1 + 1e-12);  // summed up in another order
  if (!adjacency_ || smoothed.path.length() <= longest) return;
  smoothed.path = Path::along(path.points());
  smoothed.distance = 0;
  smoothed.returned = true;
}

}  // namespace wend
