#pragma once

// Drive: the motions of a path, one after the other, with the pose before each.

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/space/se2/motion.hpp"
#include "wend/space/se2/motion_check.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

struct DrivenMotion {
  Pose from;
  Motion motion;
};

using DrivenMotions = std::vector<DrivenMotion>;

/// The cost of a drive that fits, in cells, with its changes of gear.
double cost_of(const DrivenMotions& drive, const MotionCheck& check, const Steering& steering);

/// Puts one motion where several of the same curvature follow each other.
void join(DrivenMotions& drive);

/// Makes drives cheaper: where a connection between two poses of a drive is cheaper than the drive between them, it
/// takes that. As Dijkstra's algorithm over some poses of the drive and connections of some lengths. Keeps its memory.
class DriveShortener {
 public:
  /// Check and steering must outlive it. `spacing` is the distance between poses of a drive, in cells.
  DriveShortener(const MotionCheck& check, const Steering& steering, double spacing)
      : check_(check), steering_(steering), spacing_(spacing) {}

  /// The ends stay, and the drive costs at most as much as before.
  void shorten(DrivenMotions& drive);

 private:
  /// A pose of the drive, and the cheapest way to it that is known.
  struct Knot {
    Pose pose;
    double cost = std::numeric_limits<double>::infinity();
    int gear = 0;            // before the pose
    std::size_t before = 0;  // the knot that the way comes from
    std::array<DrivenMotion, 5> way = {};
    std::size_t way_size = 0;
  };

  void cut(const DrivenMotions& drive);
  void take_cheapest(DrivenMotions& drive);
  void go_along(std::size_t from);
  void connect(std::size_t from, std::size_t to);
  bool is_worth(std::size_t from, std::size_t to, double cost) const;

  const MotionCheck& check_;
  const Steering& steering_;
  double spacing_;
  DrivenMotions pieces_;
  DrivenMotions before_;
  std::vector<Knot> knots_;
};

}  // namespace wend
