// The car's engine: A* on a CarLattice, in whole numbers where its costs are whole.

#include <algorithm>
#include <cassert>
#include <memory>
#include <optional>
#include <utility>

#include "wend/planner/lattice/lattice_engine.hpp"
#include "wend/planner/lattice/lattice_priority.hpp"
#include "wend/planner/widening_engine.hpp"
#include "wend/robot/zone_name.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/lattice/car_heuristic.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {
namespace {

/// A move raises f by at most twice its cost, at most 10 turns: the ring's 256 buckets hold that.
constexpr unsigned kCarBucketBits = 12;
static_assert(2 * static_cast<std::uint64_t>(kMostWholeMultiplier) * CarUnits::kTurn <
              (std::uint64_t{256} << kCarBucketBits));

using CarRegion = LatticeGoal<CornerPose>;

template <class Cost>
using CarFrontier =
    std::conditional_t<std::is_integral_v<Cost>, BucketFrontier<LatticeKey<Cost>, kCarBucketBits>,
                       HeapFrontier<LatticeKey<Cost>>>;

/// The heuristics of car_heuristic.hpp.
template <class Costs>
class CarEstimates {
 public:
  using Cost = typename Costs::Cost;
  using AroundObstacles = GoalCosts<CornerSpace<Costs>, CarFrontier<Cost>>;

  CarEstimates(CarLattice lattice, CarHeuristic kind)
      : lattice_(std::move(lattice)),
        kind_(kind),
        scale_(std::min(1.0, lattice_.driving().reverse_factor)) {}

  /// For where reversing costs less than driving ahead.
  double scale() const { return scale_; }

  std::unique_ptr<AroundObstacles> costs_around_obstacles() const {
    if (kind_ != CarHeuristic::obstacles) return nullptr;
    return std::make_unique<AroundObstacles>(CornerSpace<Costs>(CarSteps<Costs>(lattice_)));
  }

  template <class AroundObstaclesFrom>
  Cost operator()(const CornerPose& place, std::span<const CarRegion> goals,
                  AroundObstaclesFrom&& around_obstacles) const {
    switch (kind_) {
      case CarHeuristic::zero:
        break;
      case CarHeuristic::diagonal:
        return least_over(goals, [&](const CarRegion& goal) { return diagonal(place, goal); });
      case CarHeuristic::headings:
        return on_empty_yard(place, goals);
      case CarHeuristic::obstacles:
        return std::max(on_empty_yard(place, goals), around_obstacles(place.vertex));
    }
    return Cost{0};
  }

 private:
  static Cost on_empty_yard(const CornerPose& place, std::span<const CarRegion> goals) {
    return least_over(goals, [&](const CarRegion& goal) {
      return goal.vertices.is_one_place() ? to_vertex(place, goal) : diagonal(place, goal);
    });
  }

  static Cost diagonal(const CornerPose& place, const CarRegion& goal) {
    return diagonal_estimate<Costs>(place.vertex, goal.vertices.nearest_in_box(place.vertex));
  }

  /// The estimate to a goal of one vertex.
  static Cost to_vertex(const CornerPose& place, const CarRegion& goal) {
    const Cell vertex = goal.vertices.any();
    if (goal.any_heading) return headings_estimate<Costs>(place, CarGoal{vertex, std::nullopt});
    std::optional<Cost> least;
    for (const Heading heading : kAllHeadings) {
      if (!goal.headings[static_cast<std::size_t>(heading)]) continue;
      const Cost estimate = headings_estimate<Costs>(place, CarGoal{vertex, heading});
      least = std::min(least.value_or(estimate), estimate);
    }
    return least.value_or(Cost{0});
  }

  CarLattice lattice_;
  CarHeuristic kind_;
  double scale_;
};

template <class Costs>
std::unique_ptr<LatticeEngine<CarLattice>> engine_of(const CarLattice& lattice,
                                                     CarHeuristic heuristic, double weight) {
  using Space = CarSpace<Costs>;
  using Priority = LatticePriority<Space, CarEstimates<Costs>>;
  using Engine =
      SearchEngineOf<LatticeEngine<CarLattice>, LatticeNames, Space,
                     CarFrontier<typename Costs::Cost>, Priority, DuplicateRule::keep_cheaper>;
  return std::make_unique<Engine>(Space(lattice),
                                  Priority(CarEstimates<Costs>(lattice, heuristic), weight));
}

/// Is the lattice so large that even the estimates outgrow 32 bits?
bool too_far(const CarLattice& lattice) {
  constexpr int kFarthest = UINT32_MAX / CarUnits::kTurn / 4;
  return std::max(lattice.columns(), lattice.rows()) > kFarthest;
}

}  // namespace

std::unique_ptr<LatticeEngine<CarLattice>> make_engine(const CarLattice& lattice,
                                                       CarHeuristic heuristic, double weight) {
  if (weight == 0) heuristic = CarHeuristic::zero;
  const bool whole = has_whole_costs(lattice) && (weight == 1 || weight == 0);
  if (!whole) return engine_of<RealCarCosts>(lattice, heuristic, weight);
  const auto exact = [=] { return engine_of<ExactCarCosts>(lattice, heuristic, weight); };
  if (too_far(lattice)) return exact();
  return std::make_unique<WideningEngine<LatticeEngine<CarLattice>>>(
      [=] { return engine_of<CompactCarCosts>(lattice, heuristic, weight); }, exact);
}

/// Its weights are real numbers, so its costs are.
std::unique_ptr<LatticeEngine<CarLattice>> make_anytime_engine(const CarLattice& lattice,
                                                               CarHeuristic heuristic,
                                                               AnytimeWeights weights) {
  using Space = CarSpace<RealCarCosts>;
  using Priority = LatticePriority<Space, CarEstimates<RealCarCosts>>;
  using Engine = AnytimeEngineOf<LatticeEngine<CarLattice>, LatticeNames, Space, Priority>;
  return std::make_unique<Engine>(
      Space(lattice), Priority(CarEstimates<RealCarCosts>(lattice, heuristic), weights.first),
      weights);
}

std::vector<LeavingMotion> leaving_motions(const CarLattice& lattice, const CornerPose& place) {
  std::vector<LeavingMotion> motions;
  for (int number = 0; number < kCarMoves; ++number) {
    const CornerPose after = moved(place, static_cast<CarMove>(number));
    const Cell vertex = after.vertex;
    if (vertex.x < 0 || vertex.y < 0 || vertex.x >= lattice.columns() ||
        vertex.y >= lattice.rows()) {
      continue;
    }
    motions.push_back({{segment_between(lattice.to_grid(place), lattice.to_grid(after))}});
  }
  return motions;
}

void write_drive(const CarLattice& lattice, std::span<const CornerPose> places, Plan& out) {
  const Frame& frame = lattice.free_space().map().frame();
  for (std::size_t i = 1; i < places.size(); ++i) {
    const auto move = move_between(places[i - 1], places[i]);
    if (move) out.moves.push_back(name_of(*move, frame));
  }
  assert(places.size() == out.path.size() && out.moves.size() + 1 == places.size());
  out.cost = car_path_cost(lattice, places);
}

std::optional<FailureCause> why_blocked(const CarLattice& lattice, EndIndex end,
                                        const CornerPose& place) {
  const auto fault = lattice.why_blocked(place.vertex);
  if (!fault) return std::nullopt;
  const FreeSpace& space = lattice.free_space();
  EndBlocked blocked{.end = end,
                     .reason = fault->reason,
                     .cell = fault->cell,
                     .distance = fault->distance,
                     .radius = space.radius_in_cells()};
  if (fault->cell) blocked.mask = mask_at(space, *fault->cell);
  return blocked;
}

bool can_leave(const CarLattice& lattice, const CornerPose& place) {
  const CarSpace<RealCarCosts> space(lattice);
  bool any = false;
  space.for_each_successor(space.state(place), kNoMove,
                           [&](const CarState&, Move, double) { any = true; });
  return any;
}

/// Moves can be undone.
bool can_arrive(const CarLattice& lattice, const CornerPose& place) {
  return can_leave(lattice, place);
}

}  // namespace wend
