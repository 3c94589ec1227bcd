#pragma once

// HybridPortfolio: four hybrid A* searches that take turns until one finds a path. A search that follows the way
// of a disc can fill a dead end that the robot cannot pass; another heuristic, or finer motions, get past it:
//
//   direct   the costs as they are
//   backward from the goal to the start: where it is difficult to arrive, it is easy to leave
//   wide     a heuristic that avoids narrow places
//   fine     smaller boxes and shorter motions
//
// All but the first have a finer heuristic, too.
//
// Two floods run along with them: where the goal or the start is boxed in, one of them ends soon. If a flood or all
// four searches have ended, a last search looks for a drive between the poses of a lattice, along and across the cells.
// If it finds none, the answer is that there is no path. A search or a flood is made when a query first needs it.
//
// Poses are many, and what is known of each takes memory. So a query without a limit on expansions has one: it ends
// as expansion_limit, after some 10 s and with some 500 MB.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/se2/hybrid_ground.hpp"
#include "wend/planner/se2/hybrid_search.hpp"
#include "wend/planner/se2/no_drive_found.hpp"
#include "wend/planner/se2/pose_flood.hpp"

namespace wend {

class HybridPortfolio {
 public:
  static constexpr std::uint64_t kMostExpansions = 1'000'000;

  /// `most_expansions` counts for queries without a limit on expansions.
  HybridPortfolio(std::shared_ptr<const HybridGround> ground, const Steering& steering,
                  const HybridResolution& resolution,
                  std::uint64_t most_expansions = kMostExpansions);

  /// Runs the query to its end. The goals must outlive the run.
  SearchOutcome run(const Pose& start, std::span<const HybridGoal> goals, const Limits& limits,
                    SearchObserver* observer);

  /// The search that has found a path; null if none has.
  const HybridSearch* finder() const { return finder_; }
  /// The work of all searches.
  SearchMetrics metrics() const;

  /// The heuristic of the first search.
  double heuristic(const Pose& pose) const;

  /// What the last run without a path has learned.
  const NoDriveFound& no_drive() const { return no_drive_; }

 private:
  enum Kind : std::size_t { direct, backward, wide, fine, lattice, lattice_backward };
  static constexpr std::size_t kKinds = 6;

  struct Member {
    std::unique_ptr<CoarseGrid> grid;
    std::unique_ptr<HybridSearch> search;
    bool begun = false;
    bool exhausted = false;
  };

  void make(Kind kind);
  HybridResolution resolution_of(Kind kind) const;
  static double squares_of(Kind kind);
  std::optional<SearchOutcome> stopped(const Limits& limits, double end) const;
  SearchOutcome run_member(Kind kind, std::uint64_t most, const Limits& limits, double end);
  std::optional<SearchOutcome> take_turn(Kind kind, std::uint64_t most, const Limits& limits,
                                         double end);
  void begin(const Pose& start, std::span<const HybridGoal> goals, SearchObserver* observer);
  bool ends(PoseFlood& flood, NoDriveFound::Why boxed_in, std::uint64_t most, const Limits& limits,
            double end);
  bool is_boxed_in(std::uint64_t most, const Limits& limits, double end);
  SearchOutcome search_lattice(Kind kind, const Limits& limits, double end);

  std::shared_ptr<const HybridGround> ground_;
  Steering steering_;
  HybridResolution resolution_;
  std::uint64_t most_expansions_;  // without a limit
  std::uint64_t limit_ = 0;        // of the query
  GoalRing ring_;
  std::unique_ptr<LatticeMotions> lattice_;
  std::array<Member, kKinds> members_;
  std::unique_ptr<PoseFlood> to_goal_;
  std::unique_ptr<PoseFlood> from_start_;
  const HybridSearch* finder_ = nullptr;
  Pose start_;
  std::span<const HybridGoal> goals_;
  SearchObserver* observer_ = nullptr;
  NoDriveFound no_drive_;
};

}  // namespace wend
