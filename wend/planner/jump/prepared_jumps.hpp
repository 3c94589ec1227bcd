#pragma once

// PreparedJumps: what jump point searches have prepared of a space, which all planners on this space share: its
// jump points and dead ends, found once scans of its cells have cost about as much, and the memory of searches that
// have ended.
//
// An edit of the space changes what is near, before the next search begins. After a large edit nothing is known,
// and searches scan again.
//
// Threads may use it at the same time: one of them prepares, and the others wait.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "wend/base/mutex.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/jump/dead_ends.hpp"
#include "wend/jump/jump_boards.hpp"
#include "wend/jump/jump_graph.hpp"
#include "wend/planner/jump/jump_point_search.hpp"
#include "wend/planner/jump/known_jumps.hpp"
#include "wend/planner/jump/scanned_jumps.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class PreparedJumps final : public SpaceAttachment {
 public:
  template <class Jumps>
  using SearchOn = std::unique_ptr<JumpPointSearch<Jumps>>;

  /// Those of a space.
  static std::shared_ptr<PreparedJumps> of(const FreeSpace& space) {
    return space.attachment<PreparedJumps>([] { return std::make_shared<PreparedJumps>(); });
  }

  /// Is the map one of noise, where nothing is worth preparing? Found out once: small edits do not change it.
  bool is_noise(const BitGrid& passable);

  /// A search on the prepared map; null while preparing it is not worth it. `passable`: of the space. O(cells) the
  /// first time.
  template <class Cost>
  SearchOn<KnownJumps<Cost>> known(const BitGrid& passable) {
    const MutexLock lock(mutex_);
    bring_up_to_date(passable);
    if (graph_ == nullptr) return nullptr;
    if (auto idle = taken(idle_of<Cost>().known)) return idle;
    KnownJumps<Cost> jumps(graph_, dead_ends_);
    jumps.keep_open(edits_);
    return std::make_unique<JumpPointSearch<KnownJumps<Cost>>>(std::move(jumps));
  }

  /// A search that scans the cells.
  template <class Cost>
  SearchOn<ScannedJumps<Cost>> scanning(const BitGrid& passable) {
    const MutexLock lock(mutex_);
    if (auto idle = taken(idle_of<Cost>().scanning)) return idle;
    return std::make_unique<JumpPointSearch<ScannedJumps<Cost>>>(ScannedJumps<Cost>(passable));
  }

  /// Keeps the memory of a search for the next one.
  template <class Cost>
  void give_back(SearchOn<KnownJumps<Cost>> search) {
    const MutexLock lock(mutex_);
    keep(idle_of<Cost>().known, std::move(search));
  }
  template <class Cost>
  void give_back(SearchOn<ScannedJumps<Cost>> search) {
    const MutexLock lock(mutex_);
    if (graph_ == nullptr) keep(idle_of<Cost>().scanning, std::move(search));
  }

  /// Counts scans of searches: what they cost decides when the map is prepared.
  void count_scans(std::uint64_t scans) {
    const MutexLock lock(mutex_);
    scans_ += scans;
  }

  void space_edited(const SpaceChange& change) override;

 private:
  static constexpr std::size_t kMostIdle = 2;

  /// Searches that have ended. There is room for them, so that keeping one cannot fail.
  template <class Cost>
  struct Idle {
    Idle() {
      known.reserve(kMostIdle);
      scanning.reserve(kMostIdle);
    }

    std::vector<SearchOn<KnownJumps<Cost>>> known;
    std::vector<SearchOn<ScannedJumps<Cost>>> scanning;
  };

  template <class Cost>
  Idle<Cost>& idle_of() {
    if constexpr (sizeof(Cost) == sizeof(std::uint32_t)) {
      return compact_;
    } else {
      return wide_;
    }
  }

  template <class Search>
  static Search taken(std::vector<Search>& idle) {
    if (idle.empty()) return nullptr;
    Search last = std::move(idle.back());
    idle.pop_back();
    return last;
  }

  template <class Search>
  static void keep(std::vector<Search>& idle, Search search) {
    if (idle.size() < kMostIdle) idle.push_back(std::move(search));
  }

  void bring_up_to_date(const BitGrid& passable);
  void prepare(const BitGrid& passable);
  void repair(const BitGrid& passable);
  void forget();

  Mutex mutex_;  // guards the rest
  std::optional<bool> is_noise_;
  std::uint64_t scans_ = 0;
  std::shared_ptr<JumpBoards> boards_;
  std::shared_ptr<JumpGraph> graph_;  // null: not prepared
  std::shared_ptr<const DeadEnds> dead_ends_;
  std::vector<CellBox> pending_;  // edits that graph_ does not know
  std::vector<CellBox> edits_;    // those that dead_ends_ do not know
  Idle<std::uint32_t> compact_;
  Idle<std::uint64_t> wide_;
};

}  // namespace wend
