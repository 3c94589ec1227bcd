#pragma once

// WarmPlanners: planners that have answered queries and are kept for the next ones, with their prepared
// data and their memory. A WarmPlanner is one that is in use; it returns by itself.
//
//   wend::WarmPlanners planners(2);
//   auto planner = planners.take(space, version, spec);
//   if (!planner) return report(planner.error().message);
//   const auto plan = (*planner)->plan(query);
//
// All threads may call everything. Each WarmPlanner belongs to one thread at a time.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// A planner in use. It goes back to its WarmPlanners, or is deleted, when this object is
/// destroyed.
class WEND_API WarmPlanner {
 public:
  /// Leaves the other one without a planner.
  WarmPlanner(WarmPlanner&&) noexcept;
  /// Gives back the present planner, and leaves the other one without.
  WarmPlanner& operator=(WarmPlanner&&) noexcept;
  WarmPlanner(const WarmPlanner&) = delete;
  WarmPlanner& operator=(const WarmPlanner&) = delete;
  ~WarmPlanner();

  /// The planner; not of an object that was moved from.
  Planner& operator*() const { return *planner_; }
  /// The planner; null in an object that was moved from.
  Planner* operator->() const { return planner_.get(); }

  /// Deletes the planner: one that an exception stopped in the middle of a query must not return.
  void discard() { planner_.reset(); }

 private:
  friend class WarmPlanners;
  struct Shelf;

  WarmPlanner(std::shared_ptr<Shelf> shelf, std::uint64_t version, std::string key,
              std::unique_ptr<Planner> planner);
  void give_back();

  std::shared_ptr<Shelf> shelf_;
  std::uint64_t version_;
  std::string key_;
  std::unique_ptr<Planner> planner_;
};

class WEND_API WarmPlanners {
 public:
  /// Keeps at most `most_idle` planners that nobody uses; each has its own memory for searches
  /// (PlannerInfo::bytes_per_cell).
  explicit WarmPlanners(std::size_t most_idle);

  /// A planner for this space: a kept one with the same name and options, or a new one. `version`
  /// stands for the space: planners of other versions are dropped. Fails as make_planner() does; a new one is made
  /// before the deadline.
  Expected<WarmPlanner, Error> take(const FreeSpace& space, std::uint64_t version,
                                    const PlannerSpec& spec, const Deadline& deadline = {});

  /// `count` of them, one for each thread. They share what they prepare: the work is done once.
  Expected<std::vector<WarmPlanner>, Error> take(const FreeSpace& space, std::uint64_t version,
                                                 const PlannerSpec& spec, std::size_t count,
                                                 const Deadline& deadline = {});

  /// Planners that nobody uses, while the space that they were made for changes.
  class Released;

  /// Takes the planners of this version that nobody uses, and makes them let go of their space.
  Released release(std::uint64_t version);

  /// Keeps them for another space, which is a new version: `change` says what differs. A planner that
  /// cannot plan on it is dropped; one with an index that does not match stays, and says so.
  void keep(Released released, const FreeSpace& space, const SpaceChange& change,
            std::uint64_t version);

  /// The index that planners of this name plan on from now on.
  void set_index(std::string_view planner, IndexBytes index);

 private:
  PlannerResult make(const FreeSpace& space, const PlannerSpec& spec,
                     const Deadline& deadline) const;

  std::shared_ptr<WarmPlanner::Shelf> shelf_;
};

/// Planners without a space, by what they are asked for.
class WarmPlanners::Released {
 private:
  friend class WarmPlanners;

  std::vector<std::pair<std::string, std::unique_ptr<Planner>>> planners_;
};

}  // namespace wend
