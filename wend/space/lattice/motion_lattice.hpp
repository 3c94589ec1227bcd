#pragma once

// MotionLattice: motion primitives on a map, for one robot: where each fits, and what it costs there. The
// state space, the heuristics and the paths of the planner `lattice` use it.
//
// Vertex (i, j) is the middle of cell (i, j) times the unit: 1, unless the primitives are made for cells
// that are larger than those of the map. A step is a primitive with everything that is known of it before
// a search: the cells that the robot sweeps, its cost, and how long its way is in each cell.
//
// A step costs, in cells, its length on the map, times the reverse factor where it leads backwards, plus the
// turn cost times the angle by which it turns in place; times the cost factor of its primitive and the mean
// terrain along its way, sampled kTerrainSamples times in a cell.
//
// Immutable, cheap to copy, shared between threads. Built in O(swept cells of all primitives).

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/motion_primitives.hpp"
#include "wend/robot/sweep/swept_cells.hpp"
#include "wend/space/lattice/driving_options.hpp"
#include "wend/space/lattice/lattice_pose.hpp"

namespace wend {

inline constexpr int kTerrainSamples = 16;

/// Which share of a way lies in a cell, seen from its first cell.
struct CellShare {
  Cell offset;
  double share;
};

struct LatticeStep {
  int from;  // headings
  int to;
  Cell by;                  // vertices
  double cost;              // on uniform terrain
  std::vector<Pose> poses;  // in grid coordinates from vertex (0, 0), without the first
  SweptCells swept;
  std::vector<CellShare> ground;
};

class MotionLattice {
 public:
  using Place = LatticePose;
  static constexpr double kVertexOffset = 0.5;  // of vertex (0, 0) in grid coordinates

  /// why_none() is empty.
  MotionLattice(const FreeSpace& space, const MotionPrimitives& primitives,
                const LatticeCosts& costs);

  /// Why these primitives make no lattice for a robot on a map; empty if they do.
  static std::string why_none(const FreeSpace& space, const MotionPrimitives& primitives);

  const FreeSpace& free_space() const { return data_->space; }
  std::span<const double> headings() const { return data_->primitives.headings(); }

  /// The number of vertices.
  int columns() const { return data_->columns; }
  int rows() const { return data_->rows; }
  bool contains(Cell vertex) const {
    return vertex.x >= 0 && vertex.y >= 0 && vertex.x < columns() && vertex.y < rows();
  }
  Cell cell_of(Cell vertex) const { return {vertex.x * data_->unit, vertex.y * data_->unit}; }

  /// The steps that leave with a heading.
  std::span<const LatticeStep> leaving(int heading) const {
    const auto index = static_cast<std::size_t>(heading);
    return steps().subspan(data_->first[index], data_->first[index + 1] - data_->first[index]);
  }
  std::span<const LatticeStep> steps() const { return data_->steps; }

  /// May the robot make the step from this vertex?
  bool fits(Cell vertex, const LatticeStep& step) const {
    const Cell to{vertex.x + step.by.x, vertex.y + step.by.y};
    return contains(to) && wend::fits(data_->space, step.swept, cell_of(vertex));
  }

  /// The cost of a step that fits.
  double cost(Cell vertex, const LatticeStep& step) const {
    return data_->space.uniform_terrain() ? step.cost : step.cost * ground(vertex, step);
  }

  /// No step leads farther, in cells, than its cost divided by this.
  double least_cost_per_cell() const { return data_->least_cost_per_cell; }

  /// The pose in grid coordinates, and the lattice's pose nearest to one; nothing outside the map, and for a
  /// pose that is not finite.
  Pose to_grid(const LatticePose& place) const;
  std::optional<LatticePose> nearest(const Pose& pose) const;
  /// The heading nearest to a finite angle.
  int nearest_heading(double radians) const { return data_->primitives.nearest_heading(radians); }

  /// The pose that the pose of a query stands for.
  std::optional<LatticePose> place_on(const Pose& pose) const { return nearest(pose); }

  /// Does the robot fit there? At a vertex: with one of these headings?
  bool may_stand(const LatticePose& place) const { return data_->space.fits(to_grid(place)); }
  bool may_stand(Cell vertex, const HeadingSet& accepted) const;

  /// Could there be a way? Only a search knows.
  bool connected(Cell /*a*/, Cell /*b*/) const { return true; }

  /// An upper bound on the poses where the robot fits.
  std::uint64_t possible_poses() const {
    return data_->space.possible().count() * headings().size();
  }

  /// The cheapest step that leads from one pose to another and fits; null if there is none.
  const LatticeStep* step_between(const LatticePose& from, const LatticePose& to) const;

 private:
  double ground(Cell vertex, const LatticeStep& step) const;

  struct Data {
    FreeSpace space;
    MotionPrimitives primitives;
    int unit;
    int columns;
    int rows;
    std::vector<LatticeStep> steps;  // by the first heading
    std::vector<std::size_t> first;  // in steps, by heading; one more than headings
    double least_cost_per_cell;
  };

  std::shared_ptr<const Data> data_;
};

}  // namespace wend
