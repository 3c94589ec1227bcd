// The engine of a robot with motion primitives: A* on a MotionLattice.

#include <algorithm>
#include <cmath>

#include "wend/geometry/compass.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/planner/lattice/lattice_engine.hpp"
#include "wend/planner/lattice/lattice_priority.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/search/paged_nodes.hpp"
#include "wend/space/lattice/motion_steps.hpp"

namespace wend {
namespace {

using MotionGoal = LatticeGoal<LatticePose>;
using MotionFrontier = HeapFrontier<RealKey<double>>;

class MotionEstimates {
 public:
  using AroundObstacles = GoalCosts<VertexSpace, MotionFrontier, ParentLinks>;

  MotionEstimates(MotionLattice lattice, LatticeHeuristic kind)
      : lattice_(std::move(lattice)), kind_(kind) {}

  static constexpr double scale() { return 1; }

  std::unique_ptr<AroundObstacles> costs_around_obstacles() const {
    if (kind_ != LatticeHeuristic::obstacles) return nullptr;
    return std::make_unique<AroundObstacles>(VertexSpace(lattice_));
  }

  template <class AroundObstaclesFrom>
  double operator()(const LatticePose& place, std::span<const MotionGoal> goals,
                    AroundObstaclesFrom&& around_obstacles) const {
    switch (kind_) {
      case LatticeHeuristic::zero:
        break;
      case LatticeHeuristic::distance:
        return lattice_.least_cost_per_cell() * straight_distance(place.vertex, goals);
      case LatticeHeuristic::obstacles:
        return around_obstacles(place.vertex);
    }
    return 0;
  }

 private:
  double straight_distance(Cell vertex, std::span<const MotionGoal> goals) const {
    const Cell from = lattice_.cell_of(vertex);
    return least_over(goals, [&](const MotionGoal& goal) {
      const Cell cell = lattice_.cell_of(goal.vertices.nearest_in_box(vertex));
      return hypotenuse(cell.x - from.x, cell.y - from.y);
    });
  }

  MotionLattice lattice_;
  LatticeHeuristic kind_;
};

using MotionPriority = LatticePriority<MotionSpace, MotionEstimates>;
using MotionEngine =
    SearchEngineOf<LatticeEngine<MotionLattice>, LatticeNames, MotionSpace, MotionFrontier,
                   MotionPriority, DuplicateRule::keep_cheaper, ParentLinks, PagedNodes>;
using AnytimeMotionEngine = AnytimeEngineOf<LatticeEngine<MotionLattice>, LatticeNames, MotionSpace,
                                            MotionPriority, ParentLinks, PagedNodes>;

}  // namespace

std::unique_ptr<LatticeEngine<MotionLattice>> make_engine(const MotionLattice& lattice,
                                                          LatticeHeuristic heuristic,
                                                          double weight) {
  const auto kind = weight == 0 ? LatticeHeuristic::zero : heuristic;
  return std::make_unique<MotionEngine>(MotionSpace(lattice),
                                        MotionPriority(MotionEstimates(lattice, kind), weight));
}

std::unique_ptr<LatticeEngine<MotionLattice>> make_anytime_engine(const MotionLattice& lattice,
                                                                  LatticeHeuristic heuristic,
                                                                  AnytimeWeights weights) {
  return std::make_unique<AnytimeMotionEngine>(
      MotionSpace(lattice), MotionPriority(MotionEstimates(lattice, heuristic), weights.first),
      weights);
}

std::vector<LeavingMotion> leaving_motions(const MotionLattice& lattice, const LatticePose& place) {
  std::vector<LeavingMotion> motions;
  const Cell cell = lattice.cell_of(place.vertex);
  for (const LatticeStep& step : lattice.leaving(place.heading)) {
    if (!lattice.contains({place.vertex.x + step.by.x, place.vertex.y + step.by.y})) continue;
    LeavingMotion& motion = motions.emplace_back();
    Pose from = lattice.to_grid(place);
    for (const Pose& pose : step.poses) {
      const Pose to{cell.x + pose.x, cell.y + pose.y, pose.heading};
      motion.segments.push_back(segment_between(from, to));
      from = to;
    }
  }
  return motions;
}

/// The path gets the segments of the steps.
void write_drive(const MotionLattice& lattice, std::span<const LatticePose> places, Plan& out) {
  out.path.clear();
  out.path.drive_to(lattice.to_grid(places.front()));
  out.cost = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const LatticePose& last = places[i - 1];
    const LatticeStep* const step = lattice.step_between(last, places[i]);
    const Cell cell = lattice.cell_of(last.vertex);
    out.cost += lattice.cost(last.vertex, *step);
    for (const Pose& pose : step->poses) {
      out.path.drive_to({cell.x + pose.x, cell.y + pose.y, pose.heading});
    }
  }
  const auto poses = out.path.driven_poses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Segment segment = segment_between(poses[i - 1], poses[i]);
    out.moves.push_back(name_of(segment, lattice.free_space().map().frame()));
  }
}

std::optional<FailureCause> why_blocked(const MotionLattice& lattice, EndIndex end,
                                        const LatticePose& place) {
  return why_blocked(lattice.free_space(), end, lattice.to_grid(place));
}

bool can_leave(const MotionLattice& lattice, const LatticePose& place) {
  return std::ranges::any_of(lattice.leaving(place.heading), [&](const LatticeStep& step) {
    return lattice.fits(place.vertex, step);
  });
}

bool can_arrive(const MotionLattice& lattice, const LatticePose& place) {
  return std::ranges::any_of(lattice.steps(), [&](const LatticeStep& step) {
    const Cell from{place.vertex.x - step.by.x, place.vertex.y - step.by.y};
    return step.to == place.heading && lattice.contains(from) && lattice.fits(from, step);
  });
}

}  // namespace wend
