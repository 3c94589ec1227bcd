#pragma once

// What smoothers are made of: they refuse what cannot be smoothed, move the points of a MovablePath,
// and let no safe result be longer than the path.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/path/path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/smoothing/smoother.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// Asks a StopSmoothing now and then, and remembers that it said yes.
class StopCheck {
 public:
  explicit StopCheck(const StopSmoothing& stop) : stop_(stop) {}

  /// Before a sweep.
  bool before_sweep() {
    points_ = 0;
    return ask();
  }

  /// Before each point of a sweep.
  bool before_point() { return ++points_ % kPointsBetween == 0 ? ask() : stopped_; }

  bool stopped() const { return stopped_; }

 private:
  static constexpr std::size_t kPointsBetween = 1000;

  bool ask() {
    stopped_ = stopped_ || (stop_ && stop_());
    return stopped_;
  }

  const StopSmoothing& stop_;
  std::size_t points_ = 0;
  bool stopped_ = false;
};

/// Where a path that is to be smoothed is not free, in words.
std::string text_of(const PathCollision& collision);

/// Why gradient descent with such weights would not converge; nothing if it does. `in_place`: each
/// point sees where its neighbours are already, not where they were in the sweep before.
std::optional<std::string> fault_of_weights(double alpha, double beta, bool in_place);

/// A path whose inner points are moved, one at a time, and that stays free all the while, by
/// first_collision(), unless it is unbound.
///
/// Every line remembers where its ends were when it was last looked at on the map, and how much room
/// there was beside it (room_along()): while its ends stay within that room the line is free, as all
/// its points stay within it. So most moves cost two comparisons. What was found to be blocked is
/// looked at less and less often. Where a polygon does not fit at every heading there is no such room:
/// it is swept along the lines that a move changes, and turned where they begin and end.
class MovablePath {
 public:
  /// From now on every point stays within a distance of where it is; 0: anywhere.
  void bind(double most_distance) {
    if (most_distance > 0) bound_ = Bound{points_, most_distance};
  }

  /// Of a path that first_collision() finds free. A path that is not, one with a fault, and a drive, are
  /// unsupported_query. The options say `squeeze`, and `unsafe` for an unbound path. The space
  /// outlives it.
  template <class Options>
  static Expected<MovablePath, Error> from(const Path& path, const FreeSpace& space,
                                           const Options& options) {
    std::optional<Adjacency> adjacency;
    if (!options.unsafe) {
      adjacency = options.squeeze ? Adjacency::edges_and_corners : Adjacency::edges;
    }
    return from(path, space, adjacency);
  }

  /// Without an adjacency it is unbound: its points move wherever they are to go.
  static Expected<MovablePath, Error> from(const Path& path, const FreeSpace& space,
                                           std::optional<Adjacency> adjacency);

  std::span<const Point> points() const { return points_; }

  /// Moves an inner point all the way to a place (or, if it is bound, to the nearest one that it may be at), or an
  /// eighth of it, or not at all: the most after which both of its lines are free. Returns that share, below 1 where
  /// the bound held it back. A point that could not move at all rests:
  /// unless the room seen before allows it, its next 1, 2, 4, 8, 8 ... moves are left out.
  double move(std::size_t i, Point to) {
    if (bound_) return move_within_bound(i, to);
    return move_freely(i, to);
  }

  /// Puts the points into the result, or the path that they come from where they are longer; an
  /// unbound one may be longer.
  void finish(Smoothed& smoothed, const Path& path) const;

 private:
  struct Beside {
    Line line;
    double squared_room = 0;
    bool any_heading = false;  // does the robot fit along it at every heading?

    bool allows_begin(Point point) const { return near(line.from, point); }
    bool allows_end(Point point) const { return near(line.to, point); }

   private:
    bool near(Point a, Point b) const {
      const double dx = a.x - b.x;
      const double dy = a.y - b.y;
      return dx * dx + dy * dy <= squared_room;
    }
  };

  struct Bound {
    std::vector<Point> places;  // of the points
    double most = 0;            // cells, from there
  };

  struct Rest {
    int left = 0;    // moves to leave out
    int before = 0;  // how many that were when it could not move the last time
  };

  MovablePath(const FreeSpace& space, std::vector<Point> points, std::optional<Adjacency> adjacency)
      : space_(&space), adjacency_(adjacency), points_(std::move(points)) {}

  bool on_map(Point point) const {
    return point.x >= 0 && point.x <= space_->width() && point.y >= 0 &&
           point.y <= space_->height();
  }

  double move_freely(std::size_t i, Point to) {
    if (!adjacency_ ||
        (beside_[i - 1].allows_end(to) && beside_[i].allows_begin(to) && on_map(to))) {
      points_[i] = to;
      return 1;
    }
    return move_as_far_as_free(i, to);
  }

  double move_within_bound(std::size_t i, Point to);
  Beside look_beside(const Line& line) const;
  std::optional<Beside> free_beside(const Line& line) const;
  bool turns_fit_around(std::size_t i) const;
  bool turn_fits(std::size_t i) const;
  bool look_around();
  double move_as_far_as_free(std::size_t i, Point to);
  bool try_move(std::size_t i, Point to);

  const FreeSpace* space_;              // never null
  std::optional<Adjacency> adjacency_;  // nothing: unbound
  std::vector<Point> points_;
  std::optional<Bound> bound_;
  std::vector<Rest> rests_;     // of the points
  std::vector<Beside> beside_;  // line i goes from point i to the next
};

/// Tells of a smoother by its options: those texts of them that are wrong are Status::invalid_option.
template <class Options, class Smooth>
SmootherInfo smoother_with(std::string name, std::string summary, std::string citation,
                           Smooth&& smooth) {
  return {std::move(name),
          std::move(summary),
          std::move(citation),
          option_schema<Options>(),
          [smooth](const OptionValues& values) -> SmootherResult {
            const auto options = parse_options<Options>(values);
            if (!options) return Unexpected<Error>(options.error());
            return Smoother([smooth, options = *options](const Path& path, const FreeSpace& space,
                                                         const StopSmoothing& stop) {
              return smooth(path, space, options, stop);
            });
          },
          false};
}

}  // namespace wend
