#include "wend/planner/any_angle/prepared_sight.hpp"

#include "wend/robot/fits_along.hpp"

namespace wend {

std::shared_ptr<PreparedSight> PreparedSight::of(const FreeSpace& space) {
  return space.attachment<PreparedSight>([] { return std::make_shared<PreparedSight>(); });
}

std::shared_ptr<const Portals> PreparedSight::portals(const FreeSpace& space, Adjacency adjacency) {
  const bool squeezes = adjacency == Adjacency::edges_and_corners;
  const MutexLock lock(mutex_);
  std::shared_ptr<const Portals>& portals = (squeezes ? open_ : closed_).portals;
  if (portals != nullptr) return portals;
  const auto is_open = [&](Cell from, Cell to) {
    return disc_fits_along(space, Line{centre_of(from), centre_of(to)}, adjacency);
  };
  portals = std::make_shared<const Portals>(
      space.passable(), squeezes ? Portals::OpenGap(is_open) : Portals::OpenGap());
  return portals;
}

PreparedSight::Ground* PreparedSight::ground_of(const std::shared_ptr<const Portals>& portals) {
  if (portals == closed_.portals) return &closed_;
  return portals == open_.portals ? &open_ : nullptr;
}

std::shared_ptr<const TautMap> PreparedSight::map(const std::shared_ptr<const Portals>& portals) {
  const MutexLock lock(mutex_);
  Ground* const ground = ground_of(portals);
  if (ground == nullptr) return nullptr;
  if (ground->map != nullptr || ground->is_too_large) return ground->map;
  if (ground->looks < portals->corners().size()) return nullptr;
  ground->map = TautMap::make(portals, TautMap::usual_most_bytes(*portals));
  ground->is_too_large = ground->map == nullptr;
  return ground->map;
}

void PreparedSight::count(const std::shared_ptr<const Portals>& portals, std::uint64_t looks) {
  const MutexLock lock(mutex_);
  if (Ground* const ground = ground_of(portals)) ground->looks += looks;
}

void PreparedSight::space_edited(const SpaceChange& /*change*/) {
  const MutexLock lock(mutex_);
  closed_ = {};
  open_ = {};
}

}  // namespace wend
