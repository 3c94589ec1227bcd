#pragma once

// DriveWindow: some successive arcs and lines of a drive, whose curvatures and lengths change while both of its
// ends stay where they are. What the smoother of drives is made of.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// A line or an arc of a drive; grid coordinates.
struct DrivePiece {
  double length = 0;     // negative in reverse, never 0
  double curvature = 0;  // of the heading along the piece: turn / length
};

/// What a drive is to be like: the smaller the objective, the better. Lengths are in turning radii there.
struct DriveObjective {
  double radius = 1;            // cells: curvatures are at most 1 / radius
  double change_weight = 0.1;   // of squared changes of curvature from piece to piece
  double bend_weight = 0.3;     // of squared curvatures
  double length_weight = 1;     // of lengths
  double clearance_weight = 1;  // of the squared share by which clearance is too small
  double clearance = 0;  // cells, of the base point, that is enough; 0: clearance does not matter
};

class DriveWindow {
 public:
  /// Begins at `from` with the pieces. `before` and `after` are the curvatures of the neighbours that are driven in the
  /// same gear as the first and the last piece. The space outlives it.
  DriveWindow(const FreeSpace& space, const DriveObjective& objective, const Pose& from,
              std::vector<DrivePiece> pieces, std::optional<double> before,
              std::optional<double> after);

  /// What its pieces add to the objective.
  double objective() const { return objective_of(pieces_); }
  double length() const;

  /// Other pieces that end in the same pose, after a step of the method of Gauss and Newton, shortened by a factor from
  /// 0 to 1; nothing if the step leads to curvatures or lengths that are not allowed. O(pieces^3).
  std::optional<std::vector<DrivePiece>> step(double factor);

  /// The objective of other pieces.
  double objective_of(std::span<const DrivePiece> pieces) const;

  /// The poses between the pieces, the first and the last included.
  std::vector<Pose> poses_of(std::span<const DrivePiece> pieces) const;

 private:
  using Numbers = std::vector<double>;

  Numbers variables() const;
  std::vector<DrivePiece> pieces_at(const Numbers& variables) const;
  Numbers residuals_of(std::span<const DrivePiece> pieces) const;
  Numbers end_of_variables(const Numbers& variables) const;
  double clearance_at(Point point) const;
  bool allowed(const Numbers& variables) const;
  Numbers full_step() const;
  bool restore_end(Numbers& variables) const;

  const FreeSpace* space_;  // never null
  DriveObjective objective_;
  Pose from_;
  std::vector<DrivePiece> pieces_;
  std::optional<double> before_;
  std::optional<double> after_;
  std::vector<std::size_t> run_;  // of each piece: its stretch in one gear
  std::size_t runs_ = 0;
  Numbers wanted_end_;
  Numbers step_;  // the full one, once it is known
};

}  // namespace wend
