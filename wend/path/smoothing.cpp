#include "wend/path/smoothing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "wend/base/parse.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/robot/swept_clearance.hpp"

namespace wend {
namespace {

std::string text_of(const PathCollision& collision) {
  constexpr double kShown = 1000;  // thousandths of a cell
  const auto rounded = [](double value) {
    return format_number(std::round(value * kShown) / kShown);
  };
  return "the path is not free: " + rounded(collision.along) + " cells along it, at (" +
         rounded(collision.point.x) + ", " + rounded(collision.point.y) + "), it " +
         std::string(describe(collision.kind));
}

}  // namespace

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
    return failure(Status::unsupported_query,
                   "a car's drive is not smoothed: it is arcs that a car can drive already");
  }
  MovablePath movable(space, path.points(), adjacency);
  if (adjacency && !movable.look_around()) {
    if (const auto collision = first_collision(path, space, *adjacency)) {
      return failure(Status::unsupported_query, text_of(*collision));
    }
  }
  return movable;
}

std::optional<double> MovablePath::room_beside(const Line& line) const {
  assert(adjacency_);
  return room_along(*space_, line, *adjacency_);
}

/// Says whether all lines are seen to be free. One in a gap between two obstacles is not.
bool MovablePath::look_around() {
  bool free = on_map(points_.front()) && points_.size() > 1;
  beside_.reserve(points_.size());
  rests_.resize(points_.size());
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Line line{points_[i - 1], points_[i]};
    const auto room = room_beside(line);
    beside_.push_back({line, room ? *room * *room : 0});
    free = free && room && on_map(line.to);
  }
  return free;
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
  std::optional<Beside> before;
  std::optional<Beside> after;
  const auto look_along = [&](const Line& line, std::optional<Beside>& beside) {
    const auto room = room_beside(line);
    if (room) beside = Beside{line, *room * *room};
    return room.has_value();
  };
  if (!beside_[i - 1].allows_end(to) && !look_along({points_[i - 1], to}, before)) return false;
  if (!beside_[i].allows_begin(to) && !look_along({to, points_[i + 1]}, after)) return false;
  if (before) beside_[i - 1] = *before;
  if (after) beside_[i] = *after;
  points_[i] = to;
  return true;
}

void MovablePath::finish(Smoothed& smoothed, const Path& path) const {
  smoothed.path = Path::along(points_);
  const double longest = path.length() * (1 + 1e-12);  // summed up in another order
  if (!adjacency_ || smoothed.path.length() <= longest) return;
  smoothed.path = Path::along(path.points());
  smoothed.returned = true;
}

}  // namespace wend
