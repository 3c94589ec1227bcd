#include "wend/planner/any_angle/prepared_portals.hpp"

#include "wend/robot/fits_along.hpp"

namespace wend {

std::shared_ptr<const Portals> PreparedPortals::of(const FreeSpace& space, Adjacency adjacency) {
  const auto prepared =
      space.attachment<PreparedPortals>([] { return std::make_shared<PreparedPortals>(); });
  return prepared->find(space, adjacency);
}

std::shared_ptr<const Portals> PreparedPortals::find(const FreeSpace& space, Adjacency adjacency) {
  const bool squeezes = adjacency == Adjacency::edges_and_corners;
  const MutexLock lock(mutex_);
  std::shared_ptr<const Portals>& portals = squeezes ? open_ : closed_;
  if (portals != nullptr) return portals;
  const auto is_open = [&](Cell from, Cell to) {
    return disc_fits_along(space, Line{centre_of(from), centre_of(to)}, adjacency);
  };
  portals = std::make_shared<const Portals>(
      space.passable(), squeezes ? Portals::OpenGap(is_open) : Portals::OpenGap());
  return portals;
}

void PreparedPortals::space_edited(const SpaceChange& /*change*/) {
  const MutexLock lock(mutex_);
  closed_.reset();
  open_.reset();
}

}  // namespace wend
