#include "wend/planner/lattice/rest_on_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/path/path_collision.hpp"

namespace wend {
namespace {

constexpr double kRounding = 1e-9;  // cells, radians

bool same(const Pose& a, const Pose& b) {
  return std::abs(a.x - b.x) < kRounding && std::abs(a.y - b.y) < kRounding &&
         std::abs(normalized_angle(a.heading - b.heading)) < kRounding;
}

/// The poses from a place on.
Path path_from(std::span<const Pose> poses, const PlaceOnDrive& from) {
  Path rest;
  rest.drive_to(from.pose);
  for (const Pose& pose : poses.subspan(from.joint + 1)) rest.drive_to(pose);
  return rest;
}

/// Is the rest of a step free, from a place in its middle up to the pose at `end`?
bool is_free(const FreeSpace& space, std::span<const Pose> poses, const PlaceOnDrive& from,
             std::size_t end) {
  const Path part = path_from(poses.first(end + 1), from);
  return !first_collision(part, space);
}

/// The step that a path goes on with, and its cost where it fits; null if there is none.
const LatticeStep* step_along(const MotionLattice& lattice, const LatticePose& place,
                              std::span<const Pose> poses) {
  const Cell cell = lattice.cell_of(place.vertex);
  const LatticeStep* longest = nullptr;
  for (const LatticeStep& step : lattice.leaving(place.heading)) {
    if (step.poses.size() >= poses.size()) continue;
    if (longest != nullptr && step.poses.size() <= longest->poses.size()) continue;
    const bool leads_along = std::ranges::equal(
        step.poses, poses.subspan(1, step.poses.size()), [&](const Pose& made, const Pose& driven) {
          return same({cell.x + made.x, cell.y + made.y, made.heading}, driven);
        });
    if (leads_along) longest = &step;
  }
  return longest;
}

double size_of(const Segment& segment) {
  return segment.length != 0 ? std::abs(segment.length) : std::abs(segment.turn);
}

/// Which share of a step that ends at pose `end` lies ahead of a place on it?
double share_ahead(const JoinedPoses& drive, std::size_t begin, std::size_t end,
                   const PlaceOnDrive& from) {
  double ahead = 0;
  double whole = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const double size = size_of(drive.segment(i));
    whole += size;
    if (i == from.joint) ahead += (1 - from.share) * size;
    if (i > from.joint) ahead += size;
  }
  return whole > 0 ? ahead / whole : 0;
}

bool is_before(const PlaceOnDrive& from, std::size_t joint) {
  return from.joint < joint || (from.joint == joint && from.share == 0);
}

}  // namespace

std::optional<Plan> rest_on(const MotionLattice& lattice, std::span<const Pose> poses,
                            const PlaceOnDrive& from) {
  const FreeSpace& space = lattice.free_space();
  Plan rest;
  rest.path = path_from(poses, from);
  auto place = lattice.nearest(poses.front());
  if (!place || !same(lattice.to_grid(*place), poses.front())) return std::nullopt;
  for (std::size_t at = 0; at + 1 < poses.size();) {
    const LatticeStep* const step = step_along(lattice, *place, poses.subspan(at));
    if (step == nullptr) return std::nullopt;
    const std::size_t end = at + step->poses.size();
    if (is_before(from, at)) {
      if (!lattice.fits(place->vertex, *step)) return std::nullopt;
      rest.cost += lattice.cost(place->vertex, *step);
    } else if (from.joint < end) {
      if (!is_free(space, poses, from, end)) return std::nullopt;
      rest.cost +=
          share_ahead(JoinedPoses(poses), at, end, from) * lattice.cost(place->vertex, *step);
    }
    place = LatticePose{{place->vertex.x + step->by.x, place->vertex.y + step->by.y}, step->to};
    at = end;
  }
  for (const Segment& segment : rest.path.segments()) {
    rest.moves.push_back(name_of(segment, space.map().frame()));
  }
  return rest;
}

std::optional<Plan> rest_on(const CarLattice& lattice, std::span<const Pose> poses,
                            const PlaceOnDrive& from) {
  Plan rest;
  rest.path = path_from(poses, from);
  std::vector<CornerPose> places;
  for (const Pose& pose : poses.subspan(from.joint)) {
    const auto place = lattice.nearest(pose);
    if (!place || !same(lattice.to_grid(*place), pose)) return std::nullopt;
    places.push_back(*place);
  }
  const bool in_a_step = from.share > 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool passed = i == 0 && in_a_step;
    if (!passed && !lattice.passable(places[i].vertex)) return std::nullopt;
    if (i == 0) continue;
    const CornerPose& last = places[i - 1];
    const auto move = move_between(last, places[i]);
    if (!move) return std::nullopt;
    const bool first = i == 1 && in_a_step;
    const bool fits = first ? is_free(lattice.free_space(), poses, from, from.joint + 1)
                            : lattice.fits(last.vertex, lattice.step(last.heading, *move));
    if (!fits) return std::nullopt;
    rest.moves.push_back(name_of(*move, lattice.free_space().map().frame()));
  }
  if (!in_a_step) {
    rest.cost = car_path_cost(lattice, places);
    return rest;
  }
  const std::span<const CornerPose> all = places;
  rest.cost = (1 - from.share) * car_path_cost(lattice, all.first(2)) +
              car_path_cost(lattice, all.subspan(1));
  return rest;
}

}  // namespace wend
