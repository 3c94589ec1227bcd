#include "wend/planner/se2/hybrid_lattice.hpp"

#include <limits>

namespace wend {

void HybridLattice::expand_from(Index node, bool to_goal) {
  if (to_goal) try_goals(node);
  if (node == 0) return join(node);
  const Pose from = this->node(node).pose;
  for (const LatticeMotions::Step& step : lattice_.steps(lattice_.heading_of(from))) {
    const Pose to = lattice_.after(from, step);
    const auto cost = drive(node, step.motions, std::numeric_limits<double>::infinity());
    if (cost) add(node, step.motions, *cost, false, &to);
  }
}

/// Connects the start to the poses of the lattice around it.
void HybridLattice::join(Index start) {
  constexpr int kAround = 6;  // poses of the lattice to each side
  const Pose pose = node(start).pose;
  free_box(pose);  // a pose of the lattice may share it
  const Pose middle = lattice_.nearest(pose);
  for (int dx = -kAround; dx <= kAround; ++dx) {
    for (int dy = -kAround; dy <= kAround; ++dy) {
      for (std::size_t heading = 0; heading < LatticeMotions::kHeadings; ++heading) {
        const Pose to = lattice_.pose(middle.x + dx * LatticeMotions::kSpacing,
                                      middle.y + dy * LatticeMotions::kSpacing, heading);
        connect_to(start, to, 2, true);
      }
    }
  }
}

}  // namespace wend
