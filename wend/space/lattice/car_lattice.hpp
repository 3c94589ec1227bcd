#pragma once

// CarLattice: where a car on the corners of a grid may be, and the terrain cost there. The state space,
// the heuristics and the path costs of the car use it.
//
// Lattice coordinates: corner (i, j) is the point (i, j) times the unit in grid coordinates, and
// lattice cell (i, j) lies between corners (i, j) and (i + 1, j + 1). Corners lie on the map. A
// lattice cell that the map's edge cuts also counts for the corners that touch it.
//
// A lattice cell is blocked if any of its map cells is an obstacle, and its terrain is their mean.
// A blocked cell makes its corners impassable; for a robot with a radius the corner must be at
// least as far from every obstacle. So no move sweeps a blocked cell: its ends would touch it.
//
// Immutable, cheap to copy, shared between threads. Built in O(cells); with a radius above sqrt(2) - 1
// units every arc is swept as well.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/map/grid.hpp"
#include "wend/robot/car_primitives.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/lattice/driving_options.hpp"
#include "wend/space/lattice/lattice_pose.hpp"

namespace wend {

/// A car's primitive from one heading, with what it touches on a lattice.
struct CarStep {
  Cell by{};              // from corner to corner
  Heading to{};           // afterwards
  bool turns = false;     // or is straight
  bool reverses = false;  // or leads ahead
  CarMove undone_by{};    // the move that leads back
  Cell swept{};           // for a turn: the lattice cell that the arc sweeps, from the corner
  Cell beside{};          // straight move: one of the two lattice cells beside it
  Cell other_beside{};    // the other one
  unsigned arc_bit = 0;   // the index of its arc or line in CarLattice::fits()
  Cell arc_owner{};       // the owner of the arc or line, from the corner
};

/// Why a corner is impassable.
struct CornerFault {
  BlockReason reason;
  std::optional<Cell> cell{};  // a map cell that blocks it; none for too_close
  double distance = 0;         // for too_close: to the nearest obstacle, in map cells
};

class WEND_API CarLattice {
 public:
  using Place = CornerPose;
  static constexpr double kVertexOffset = 0;  // of vertex (0, 0) in grid coordinates

  /// Of no use if the deadline passes before it is made.
  CarLattice(FreeSpace space, const CarDriving& driving,
             DeadlineCheck& stop = DeadlineCheck::never());

  const FreeSpace& free_space() const { return data_->space; }
  const CarDriving& driving() const { return data_->driving; }
  int unit() const { return static_cast<int>(data_->driving.unit); }

  /// The number of corners.
  int columns() const { return data_->passable.width(); }
  int rows() const { return data_->passable.height(); }

  /// May the car stand on a corner? All corners as bits.
  bool passable(Cell corner) const {
    return data_->passable.contains(corner) && data_->passable[corner];
  }
  const BitGrid& passable() const { return data_->passable; }

  /// Could moves join two corners if headings did not matter? 8-connected.
  bool connected(Cell a, Cell b) const {
    return data_->components.connected(a, b, Adjacency::edges_and_corners);
  }

  /// Why the car cannot stand on a corner; nothing if it can.
  std::optional<CornerFault> why_blocked(Cell corner) const;

  /// The step of a move from a heading.
  const CarStep& step(Heading heading, CarMove move) const {
    return data_
        ->steps[static_cast<std::size_t>(heading) * kCarMoves + static_cast<std::size_t>(move)];
  }

  /// Does the robot's disc fit along a move between passable corners?
  bool fits(Cell corner, const CarStep& step) const {
    if (!sweeps()) return true;
    const Cell owner{corner.x + step.arc_owner.x, corner.y + step.arc_owner.y};
    return ((data_->fitting[owner] >> step.arc_bit) & 1U) != 0;
  }
  bool sweeps() const { return !data_->fitting.empty(); }

  /// The multipliers of the lattice cells, at least 1; an empty grid on uniform terrain.
  const Grid<double>& terrain() const { return data_->terrain; }

  /// A multiplier of a lattice cell that a move from a corner sweeps or runs beside.
  double terrain_at(Cell corner, Cell offset) const {
    return data_->terrain.empty() ? 1 : data_->terrain[{corner.x + offset.x, corner.y + offset.y}];
  }

  /// The multiplier of a move's cost for the terrain. The move must be legal.
  double ground(const CornerPose& from, CarMove move) const;

  /// Converts a pose from lattice coordinates to grid coordinates.
  Pose to_grid(const CornerPose& place) const;

  /// The grid coordinates of a vertex.
  Cell cell_of(Cell vertex) const { return {vertex.x * unit(), vertex.y * unit()}; }

  /// The lattice pose nearest to a pose in grid coordinates; it may lie outside the map. Nothing if the
  /// coordinates are too large.
  std::optional<CornerPose> nearest(const Pose& pose) const;

  /// The pose of the lattice that a query's pose stands for: the nearest one, of those on the map.
  /// Nothing for a pose outside the map.
  std::optional<CornerPose> place_on(const Pose& pose) const;

  /// May the car stand there? It does not depend on the heading.
  bool may_stand(const CornerPose& place) const { return passable(place.vertex); }
  bool may_stand(Cell vertex, const HeadingSet& /*accepted*/) const { return passable(vertex); }

  /// The headings in radians, and the index of the one nearest to a finite angle.
  static std::span<const double> headings() { return car_primitives().headings(); }
  static int nearest_heading(double radians) {
    return static_cast<int>(wend::nearest_heading(radians));
  }

  /// The number of poses where it may stand.
  std::uint64_t possible_poses() const { return passable().count() * kHeadings; }

 private:
  struct Data {
    FreeSpace space;
    CarDriving driving;
    std::array<CarStep, std::size_t{kHeadings} * kCarMoves> steps;
    BitGrid blocked;   // lattice cells
    BitGrid passable;  // corners
    ConnectedComponents components;
    Grid<double> terrain;        // lattice cells; empty if uniform
    Grid<std::uint8_t> fitting;  // arcs and lines that fit, by the corner with the least x and y
  };

  std::shared_ptr<const Data> data_;
};

/// Is there at least one lattice cell on the map?
WEND_API bool has_room_for(const GridMap& map, const CarDriving& driving);

/// Why a car cannot drive on a map at all; empty if it can.
std::string why_no_lattice(const GridMap& map, const CarDriving& driving);

// The cost of a path, recomputed from its poses alone, never from the sums of a search.

/// The move between two consecutive poses of a lattice; nothing if no move joins them.
std::optional<CarMove> move_between(const CornerPose& from, const CornerPose& to);

/// The cost of a path in units: the sum over all moves of length times ground, times the factor for
/// reversing. The poses are in lattice coordinates and joined by moves. Moves of the same kind are
/// counted, so that equal paths over whole multipliers cost the same to the last bit.
double car_path_cost(const CarLattice& lattice, std::span<const CornerPose> poses);

}  // namespace wend
