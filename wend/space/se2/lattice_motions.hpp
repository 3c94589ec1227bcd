#pragma once

// LatticeMotions: the motions of a robot between poses of a lattice: the middles, corners and edges of cells, each with
// 16 headings. Motions between arbitrary poses drift: none of them may be exactly where the robot passes between
// two walls that it almost touches. Along a row of cells, or across it, a pose of the lattice is.
// M. Pivtoraiko and A. Kelly, "Efficient Constrained Path Planning via Search in State Lattices", 2005.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/space/se2/motion.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

class LatticeMotions {
 public:
  static constexpr double kSpacing = 0.5;       // cells, between poses of the lattice
  static constexpr std::size_t kHeadings = 16;  // of each place

  /// Motions to another pose of the lattice.
  struct Step {
    std::vector<Motion> motions;
    Point by;        // cells
    std::size_t to;  // the number of the heading
  };

  /// The motions of a robot. Without any where the turning radius is too large.
  explicit LatticeMotions(const Steering& steering);

  bool empty() const { return steps_.empty(); }

  Pose pose(double x, double y, std::size_t heading) const { return {x, y, headings_[heading]}; }

  /// The pose of the lattice that is nearest to one, and the number of its heading.
  Pose nearest(const Pose& pose) const;
  std::size_t heading_of(const Pose& pose) const;

  /// The steps from a heading.
  std::span<const Step> steps(std::size_t heading) const { return steps_[heading]; }
  Pose after(const Pose& from, const Step& step) const {
    return {from.x + step.by.x, from.y + step.by.y, headings_[step.to]};
  }

 private:
  std::vector<double> headings_;
  std::vector<std::vector<Step>> steps_;  // by heading
};

}  // namespace wend
