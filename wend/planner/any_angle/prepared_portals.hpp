#pragma once

// PreparedPortals: the Portals of the cells of a FreeSpace, which all planners on that space share. They are made
// when a planner first asks for them, and again after an edit.

#include <memory>

#include "wend/base/mutex.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/sight/portals.hpp"

namespace wend {

class PreparedPortals final : public SpaceAttachment {
 public:
  /// Those of a space. A robot passes between two cells that touch diagonally, where the adjacency lets it, if its
  /// (circumscribed) disc fits along the diagonal.
  static std::shared_ptr<const Portals> of(const FreeSpace& space, Adjacency adjacency);

  void space_edited(const SpaceChange& change) override;

 private:
  std::shared_ptr<const Portals> find(const FreeSpace& space, Adjacency adjacency);

  Mutex mutex_;  // guards the rest
  std::shared_ptr<const Portals> closed_;
  std::shared_ptr<const Portals> open_;  // with gaps
};

}  // namespace wend
