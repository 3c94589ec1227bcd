#pragma once

// MovablePath: a path whose inner points are moved, one at a time, and that stays free all the while.
//
// Every line remembers where its ends were when it was last looked at on the map, and how much room
// there was beside it (line_room.hpp): while its ends stay within that room the line is free, as all
// its points stay within it. So most moves cost two comparisons. What was found to be blocked is
// looked at less and less often.

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/map/free_space.hpp"
#include "wend/path/path.hpp"
#include "wend/path/smoother.hpp"

namespace wend {

class MovablePath {
 public:
  /// Of a path (not empty) that first_collision() finds free; else the reason is unsupported_query,
  /// as for a drive. The space outlives it.
  static Expected<MovablePath, SmoothingError> from(const Path& path, const FreeSpace& space,
                                                    Adjacency adjacency);

  std::span<const Point> points() const { return points_; }

  /// Moves an inner point all the way to a place, or an eighth of it, or not at all: the most after
  /// which both of its lines are free. Returns that share. A point that could not move at all rests:
  /// unless the room seen before allows it, its next 1, 2, 4, 8, 8 ... moves are left out.
  double move(std::size_t i, Point to) {
    if (beside_[i - 1].allows_end(to) && beside_[i].allows_begin(to) && on_map(to)) {
      points_[i] = to;
      return 1;
    }
    return move_as_far_as_free(i, to);
  }

 private:
  struct Beside {
    Line line;
    double squared_room = 0;

    bool allows_begin(Point point) const { return near(line.from, point); }
    bool allows_end(Point point) const { return near(line.to, point); }

   private:
    bool near(Point a, Point b) const {
      const double dx = a.x - b.x;
      const double dy = a.y - b.y;
      return dx * dx + dy * dy <= squared_room;
    }
  };

  struct Rest {
    int left = 0;    // moves to leave out
    int before = 0;  // how many that were when it could not move the last time
  };

  MovablePath(const FreeSpace& space, std::vector<Point> points, Adjacency adjacency)
      : space_(&space), adjacency_(adjacency), points_(std::move(points)) {}

  bool on_map(Point point) const {
    return point.x >= 0 && point.x <= space_->width() && point.y >= 0 &&
           point.y <= space_->height();
  }

  bool look_around();
  double move_as_far_as_free(std::size_t i, Point to);
  bool try_move(std::size_t i, Point to);

  const FreeSpace* space_;  // never null
  Adjacency adjacency_;
  std::vector<Point> points_;
  std::vector<Rest> rests_;     // of the points
  std::vector<Beside> beside_;  // line i goes from point i to the next
};

}  // namespace wend
