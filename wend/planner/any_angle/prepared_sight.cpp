#include "wend/planner/any_angle/prepared_sight.hpp"

#include <utility>

#include "wend/robot/sweep/fits_along.hpp"

namespace wend {

std::shared_ptr<PreparedSight> PreparedSight::of(const FreeSpace& space) {
  return space.attachment<PreparedSight>([] { return std::make_shared<PreparedSight>(); });
}

std::shared_ptr<const Portals> PreparedSight::portals(const FreeSpace& space, Adjacency adjacency,
                                                      DeadlineCheck& stop) {
  const bool squeezes = adjacency == Adjacency::edges_and_corners;
  const MutexLock lock(mutex_);
  std::shared_ptr<const Portals>& portals = (squeezes ? open_ : closed_).portals;
  if (portals != nullptr) return portals;
  const auto is_open = [&](Cell from, Cell to) {
    return disc_fits_along(space, Line{centre_of(from), centre_of(to)}, adjacency);
  };
  auto made = std::make_shared<const Portals>(
      space.passable(), squeezes ? Portals::OpenGap(is_open) : Portals::OpenGap(), stop);
  if (stop.has_passed()) return nullptr;
  portals = std::move(made);
  return portals;
}

PreparedSight::Ground* PreparedSight::ground_of(const std::shared_ptr<const Portals>& portals) {
  if (portals == closed_.portals) return &closed_;
  return portals == open_.portals ? &open_ : nullptr;
}

std::shared_ptr<const TautMap> PreparedSight::map(const std::shared_ptr<const Portals>& portals,
                                                  const GoesOn& goes_on) {
  std::unique_ptr<TautMapMaking> making;
  {
    const MutexLock lock(mutex_);
    Ground* const ground = ground_of(portals);
    if (ground == nullptr) return nullptr;
    if (ground->map != nullptr || ground->is_too_large) return ground->map;
    if (ground->is_in_the_making || ground->looks < portals->corners().size()) return nullptr;
    ground->is_in_the_making = true;
    making = std::move(ground->making);
  }
  if (making == nullptr) {
    making = std::make_unique<TautMapMaking>(portals, TautMap::usual_most_bytes(*portals));
  }
  const auto state = making->go_on(goes_on);
  const MutexLock lock(mutex_);
  Ground* const ground = ground_of(portals);
  if (ground == nullptr) return nullptr;
  ground->is_in_the_making = false;
  if (state == TautMapMaking::State::finished) ground->map = making->take();
  if (state == TautMapMaking::State::unfinished) ground->making = std::move(making);
  ground->is_too_large = state == TautMapMaking::State::too_large;
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
