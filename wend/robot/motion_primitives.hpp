#pragma once

// MotionPrimitives: the motions that a robot can make between the vertices of a lattice, as data. A vertex
// is the middle or a corner of a cell; a robot on it has one of the set's headings. A primitive leads from a heading at one vertex to
// a heading at another, along segments: ahead or in reverse, on arcs, to a side, or turning in place.
// M. Pivtoraiko and A. Kelly, "Efficient Constrained Path Planning via Search in State Lattices", 2005.
//
//   const auto robot = wend::MotionPrimitives::turning_circle(4);  // radius of at least 4 cells
//   if (!robot) return report(robot.error().message);
//   const std::size_t ways = robot->leaving(0).size();  // straight, two turns, and the same in reverse
//
// Lengths are in cells of the set, angles in radians, in grid coordinates. Immutable, cheap to copy; copies
// share the data, also between threads. io/primitives/ reads sets from files.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// Where the vertices of a lattice lie.
enum class Vertices {
  centres,  // in the middle of cells
  corners,  // where cells meet
};

/// A motion from one vertex and heading to another.
struct MotionPrimitive {
  int number = 0;          // as its file numbers it
  int from = 0;            // heading: an index in the set's headings
  int to = 0;              // heading: an index in the set's headings
  Cell by = {};            // from vertex to vertex
  double cost_factor = 1;  // on the cost of its length, above 0
  std::vector<Pose>
      poses;  // joined by segments (geometry/segment.hpp); from the vertex (0, 0) to `by`

  friend bool operator==(const MotionPrimitive&, const MotionPrimitive&) = default;
};

class WEND_API MotionPrimitives {
 public:
  static constexpr std::size_t kMostHeadings = 256;     // of a set
  static constexpr std::size_t kMostPrimitives = 8192;  // of a set
  static constexpr std::size_t kMostPoses = 1024;       // of a primitive
  static constexpr int kFarthest = 256;                 // cells, of every pose from the vertex

  /// What a set is made from.
  struct Parts {
    std::optional<double> resolution;         // metres per cell; nothing: that of the map
    std::vector<double> headings;             // radians
    std::vector<MotionPrimitive> primitives;  // in any order
    Vertices vertices = Vertices::centres;    // where they begin and end
  };

  /// Moves the ends of each primitive onto their exact vertices and headings, the poses between them in
  /// proportion, and joins segments that agree with one segment up to 0.02 cells and 0.01 radians. Rejects
  /// numbers that are NaN or out of range, equal headings, poses that end more than a quarter of a cell or
  /// 0.2 radians from their vertex or heading, and primitives that do not move. `where` of the error is
  /// "primitive 3", by its place in the list, or empty.
  static Expected<MotionPrimitives, Error> make(Parts parts);

  /// A robot that drives straight in 16 directions, from (1,0) and (2,1) to (2,-1), and turns from each
  /// to the next, forwards and in reverse: on arcs of at least this radius in cells; if it is 0, in place.
  /// Rejects a radius that is negative, NaN, or too large for kFarthest.
  static Expected<MotionPrimitives, Error> turning_circle(double radius);

  /// Metres per cell; nothing if the set has the resolution of any map.
  std::optional<double> resolution() const { return data_->parts.resolution; }
  /// The headings in radians; primitives refer to them by index.
  std::span<const double> headings() const& { return data_->parts.headings; }

  /// Where the vertices lie: files have them in the middle of cells, car_primitives() at corners.
  Vertices vertices() const { return data_->parts.vertices; }

  /// All primitives, ordered by their first headings.
  std::span<const MotionPrimitive> all() const& { return data_->parts.primitives; }

  /// Not of a temporary: they would be gone.
  std::span<const double> headings() const&& = delete;
  std::span<const MotionPrimitive> all() const&& = delete;

  /// These, and the way back of each that has none: the same segments in reverse.
  MotionPrimitives with_ways_back() const;

  /// Those that leave with this heading.
  std::span<const MotionPrimitive> leaving(int heading) const;

  /// The heading nearest to a finite angle. O(headings).
  int nearest_heading(double radians) const;

  /// Are both copies of one set?
  friend bool operator==(const MotionPrimitives& a, const MotionPrimitives& b) {
    return a.data_ == b.data_;
  }

 private:
  struct Data {
    Parts parts;
    std::vector<std::size_t> first;  // in parts.primitives, by heading; one more than headings
  };

  static MotionPrimitives in_order(Parts parts);

  explicit MotionPrimitives(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

}  // namespace wend
