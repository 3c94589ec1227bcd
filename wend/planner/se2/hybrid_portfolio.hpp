#pragma once

// HybridPortfolio: hybrid A* searches that take turns until one finds a path. A search that follows the way of a disc
// can fill a dead end that the robot cannot pass; another heuristic, or finer motions, get past it:
//
//   direct   the costs as they are
//   backward from the goal to the start: where it is difficult to arrive, it is easy to leave
//   wide     a heuristic that avoids narrow places
//   fine     smaller boxes and shorter motions
//   shuffles motions that go on until the robot touches, in small boxes, from either end and at two scales: where
//            the robot has to drive to and fro, as in a parking slot. They begin where the others have found nothing,
//            and in the end try wider arcs than the narrowest ones
//
// All but the first have a finer heuristic, too.
//
// Two floods run along with them. Where the goal or the start is boxed in, or the robot has to shuffle to leave it, one
// of them ends soon: then only the shuffles from that end go on. If all have ended, a last search looks for a drive
// between the poses of a lattice, along and across the cells. If it finds none, the answer is that there is no path. A
// search or a flood is made when a query first needs it; those that have grown large are freed when the query ends.
//
// A query without limits of its own ends when it has used its budget of CPU time, or of memory.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/failure.hpp"
#include "wend/planner/se2/hybrid_ground.hpp"
#include "wend/planner/se2/hybrid_search.hpp"
#include "wend/planner/se2/pose_flood.hpp"
#include "wend/space/se2/lattice_motions.hpp"

namespace wend {

/// What a query without limits of its own may use.
struct HybridBudget {
  double seconds = 2;                    // of CPU time
  std::uint64_t expansions = 1'000'000;  // some 500 MB
  Clock clock = {};                      // measures the seconds; null: cpu_seconds()
};

class HybridPortfolio {
 public:
  /// The ring is of the steering, and may have been used before; null: a new one.
  HybridPortfolio(std::shared_ptr<const HybridGround> ground, const Steering& steering,
                  const HybridResolution& resolution, HybridBudget budget = {},
                  std::shared_ptr<GoalRing> ring = {});

  /// Runs the query to its end. The goals must outlive the run.
  SearchOutcome run(const Pose& start, std::span<const HybridGoal> goals, const Limits& limits,
                    SearchObserver* observer);

  /// The search that has found a path; null if none has.
  const HybridSearch* finder() const { return finder_; }
  /// The work of all searches.
  SearchMetrics metrics() const { return metrics_; }

  /// The heuristic of the first search.
  double heuristic(const Pose& pose) const;

  /// What the last run without a path has learned.
  const NoDriveFound& no_drive() const { return no_drive_; }

 private:
  enum Kind : std::size_t {
    direct,
    backward,
    wide,
    fine,
    shuffle,
    shuffle_backward,
    close_shuffle,
    close_shuffle_backward,
    wider_shuffle,
    wider_shuffle_backward,
    lattice,
    lattice_backward
  };
  static constexpr std::size_t kKinds = 12;

  /// How coarse the squares of a heuristic are.
  enum Squares : std::size_t { quick, closer, closer_and_wide, finest };
  static constexpr std::size_t kSquares = 4;

  using Direction = HybridSearch::Direction;
  /// What a search drives. Wider shuffles have wider arcs.
  enum class Motions { coarse, fine, shuffles, close_shuffles, wider_shuffles, lattice };

  struct KindOfSearch {
    Squares squares;
    Motions motions;
    Direction direction;

    bool shuffles() const { return motions >= Motions::shuffles && motions < Motions::lattice; }
    bool from_goal() const { return direction == Direction::from_goal; }
  };
  static const std::array<KindOfSearch, kKinds> kSearches;

  struct Member {
    std::unique_ptr<HybridSearch> search;
    bool begun = false;
    bool over = false;  // it is exhausted, or has had its share
  };

  /// Which searches still have to be asked.
  struct Course {
    bool coarse = true;         // the first four
    bool from_start = true;     // shuffles
    bool from_goal = true;      // the same
    bool shuffles_due = false;  // have the others had their first turn?
  };

  HybridResolution resolution_of(Motions motions) const;
  double shuffle_length() const;
  bool may_shuffle() const;
  HybridResolution shuffle_resolution(const Steering& steering, double finer) const;
  GoalRing& ring_of(const KindOfSearch& kind);
  bool suits(const KindOfSearch& kind) const;
  const CoarseGrid* grid_of(Squares squares);
  HybridSearch* search_of(Kind kind);

  void begin(const Pose& start, std::span<const HybridGoal> goals, const Limits& limits,
             SearchObserver* observer);
  std::optional<SearchOutcome> interrupted() const;
  std::optional<SearchOutcome> stopped() const;
  std::uint64_t expanded() const;
  SearchOutcome run_member(Kind kind, std::uint64_t most);
  std::optional<SearchOutcome> take_turn(Kind kind, std::uint64_t most);
  std::optional<SearchOutcome> take_turns(std::span<const Kind> kinds, std::uint64_t most);
  bool all_over(std::span<const Kind> kinds) const;
  SearchOutcome take_course();
  void flood(std::uint64_t most, Course& course);
  void run_flood(PoseFlood& flood, std::uint64_t most);
  NoDriveFound::Why why_none() const;
  SearchOutcome search_lattice(Kind kind);
  void end();

  std::shared_ptr<const HybridGround> ground_;
  Steering steering_;
  Steering wider_steering_;  // what the robot can do as well, in larger arcs
  HybridResolution resolution_;
  HybridBudget budget_;
  std::shared_ptr<GoalRing> ring_;
  std::optional<GoalRing> wider_ring_;
  std::unique_ptr<LatticeMotions> lattice_;
  std::array<std::unique_ptr<CoarseGrid>, kSquares> grids_;
  std::array<Member, kKinds> members_;
  std::unique_ptr<PoseFlood> to_goal_;
  std::unique_ptr<PoseFlood> from_start_;
  bool flooded_ = false;  // do the floods run in this query?
  const HybridSearch* finder_ = nullptr;
  Pose start_;
  std::span<const HybridGoal> goals_;
  const Limits* limits_ = nullptr;
  double end_seconds_ = 0;           // on the clock of the query
  double budget_end_ = 0;            // on that of the budget
  std::uint64_t limit_ = 0;          // expansions
  std::uint64_t most_shuffles_ = 0;  // expansions of a search of shuffles
  SearchObserver* observer_ = nullptr;
  SearchMetrics metrics_;
  NoDriveFound no_drive_;
};

}  // namespace wend
