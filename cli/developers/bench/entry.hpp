#pragma once

// What `wend bench` compares: planners with their options, some of them on an index.

#include <memory>
#include <string>
#include <vector>

#include "bench/database/bench_database.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

/// Throws InputError if a file is damaged or is not an index.
std::vector<GivenIndex> open_indexes(const std::vector<std::string>& files);

/// Is it for this map?
bool is_for(const GivenIndex& index, const FreeSpace& space);

/// What an entry's planners on a map share. Without preprocessing: nothing.
struct Preparation {
  IndexBytes index{};
  BenchIndex cost{};
};

class BenchEntry {
 public:
  /// `info` must outlive this.
  BenchEntry(PlannerSpec spec, const PlannerInfo& info);

  /// As it was typed: "astar:weight=2".
  const std::string& name() const { return spec_.text; }

  bool any_angle() const { return info_.capabilities.any_angle; }

  /// Throws InputError if the planner does not take its options, or terrain where there is some. O(1).
  void check(const FreeSpace& space) const;

  /// Can this entry plan on that index?
  bool takes(const GivenIndex& index) const;

  /// What is needed before planners are made: one of the given indexes, or one that is built now.
  /// One thread builds, so that its CPU time is that of the build. Throws InputError if it cannot be
  /// built.
  Preparation prepare(const FreeSpace& space, const std::vector<GivenIndex>& given) const;

  /// A planner for one thread. Fails if it does not take its options, the map or the index.
  PlannerResult try_make(const FreeSpace& space, const Preparation& preparation) const;

  /// The same; throws InputError.
  std::unique_ptr<Planner> make_planner(const FreeSpace& space,
                                        const Preparation& preparation) const;

 private:
  Preparation build(const FreeSpace& space) const;

  PlannerSpec spec_;
  const PlannerInfo& info_;
};

/// The entries of a --planner list: our planners and, if the build found Boost.Graph, "boost-astar". All
/// use `moves`. Throws InputError for a planner that does not exist or cannot use them.
std::vector<BenchEntry> parse_entries(const std::string& list, GridMoves moves);

}  // namespace wend::cli
