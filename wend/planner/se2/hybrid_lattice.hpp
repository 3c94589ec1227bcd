#pragma once

// HybridLattice: a HybridSearch between poses of a lattice only, for passages in which motions between arbitrary poses
// never fit (lattice_motions.hpp). Only the start and the goals may lie beside it.

#include "wend/planner/se2/hybrid_search.hpp"
#include "wend/space/se2/lattice_motions.hpp"

namespace wend {

class HybridLattice final : public HybridSearch {
 public:
  /// All but the resolution must outlive the search.
  HybridLattice(const MotionCheck& check, const Steering& steering, GoalRing& ring,
                const CoarseGrid& grid, const HybridResolution& resolution, Direction direction,
                const LatticeMotions& lattice)
      : HybridSearch(check, steering, ring, grid, resolution, direction), lattice_(lattice) {}

 private:
  void expand_from(Index node, bool to_goal) override;
  void join(Index start);

  const LatticeMotions& lattice_;
};

}  // namespace wend
