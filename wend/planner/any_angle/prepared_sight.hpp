#pragma once

// PreparedSight: the Portals of the cells of a FreeSpace, and their TautMap, which all planners on that space share.
// Portals are made when a planner first asks for them, and again after an edit. The map follows once the searches have
// looked around as often as making it does.

#include <cstdint>
#include <functional>
#include <memory>

#include "wend/base/mutex.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/sight/portals.hpp"
#include "wend/sight/taut_map.hpp"

namespace wend {

class PreparedSight final : public SpaceAttachment {
 public:
  /// That of a space.
  static std::shared_ptr<PreparedSight> of(const FreeSpace& space);

  /// A robot passes between two cells that touch diagonally, where the adjacency lets it, if its (circumscribed) disc
  /// fits along the diagonal.
  /// Null if the deadline passes before.
  std::shared_ptr<const Portals> portals(const FreeSpace& space, Adjacency adjacency,
                                         DeadlineCheck& stop = DeadlineCheck::never());

  /// Whether to go on with making a map, of which this share is done.
  using GoesOn = std::function<bool(double share)>;

  /// The map of these portals, if it is there, or worth making and finished now. Null also while another thread makes
  /// it, where it would be too large, or where the portals have been made again. What goes_on() stops is kept: the next
  /// call goes on with it.
  std::shared_ptr<const TautMap> map(const std::shared_ptr<const Portals>& portals,
                                     const GoesOn& goes_on);
  /// A search on these portals has looked around so many times.
  void count(const std::shared_ptr<const Portals>& portals, std::uint64_t looks);

  void space_edited(const SpaceChange& change) override;

 private:
  struct Ground {
    std::shared_ptr<const Portals> portals;
    std::shared_ptr<const TautMap> map;
    std::unique_ptr<TautMapMaking> making;  // that was stopped
    std::uint64_t looks = 0;
    bool is_in_the_making = false;
    bool is_too_large = false;
  };

  /// Null if these are not its portals any more.
  Ground* ground_of(const std::shared_ptr<const Portals>& portals);

  Mutex mutex_;  // guards the rest
  Ground closed_;
  Ground open_;  // with gaps
};

}  // namespace wend
