// The engine of a robot with motion primitives: A* on a MotionLattice.

#include <algorithm>
#include <cmath>

#include "wend/geometry/compass.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/map/place_text.hpp"
#include "wend/planner/anytime_engine.hpp"
#include "wend/planner/lattice/lattice_engine.hpp"
#include "wend/planner/lattice/lattice_priority.hpp"
#include "wend/robot/zone_name.hpp"
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

std::string blocked(const MotionLattice& lattice, const std::string& name, const Pose& pose) {
  const auto place = lattice.nearest(pose);
  if (!place) return {};
  const Pose taken = lattice.to_grid(*place);
  const auto reason = lattice.free_space().why_blocked(taken);
  const auto mask = reason == BlockReason::obstacle
                        ? mask_that_blocks(lattice.free_space(), cell_at(taken.point()))
                        : std::nullopt;
  return "the robot does not fit at the " + name + " " +
         pose_text(taken, lattice.free_space().map().frame()) + " of the lattice" +
         (reason ? ": " + (mask ? "blocked by " + *mask : std::string(describe(*reason))) : "");
}

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

std::string reason_on(const MotionLattice& lattice, const Query& query, Status status) {
  const auto pose_of_goal = [&] {
    const Goal& goal = query.goals.front();
    return Pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
  };
  if (status == Status::start_blocked) return blocked(lattice, "start", query.start);
  if (query.goals.empty()) return {};
  if (status == Status::goal_blocked) return blocked(lattice, "goal", pose_of_goal());
  if (status != Status::unreachable) return {};
  const Frame& frame = lattice.free_space().map().frame();
  const Goal& goal = query.goals.front();
  return "no sequence of motion primitives leads from the start " + pose_text(query.start, frame) +
         " to the goal " + pose_text(goal.point, goal.heading, frame);
}

}  // namespace wend
