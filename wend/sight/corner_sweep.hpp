#pragma once

// CornerSweep: the corners of Portals that a point or a corner sees, and at which a shortest path from it can turn.
//
//   wend::CornerSweep sweep(portals);
//   sweep.from_point(wend::SightPoint::centre({0, 3}),
//                    [&](std::uint32_t corner, wend::Ray ray) { see(corner, ray); });
//
// Of several corners on one ray only the first is told: the others are reached through it. A corner is told only
// where the ray is tangent to its obstacle: else a path that turns there is not the shortest. Seen from a corner,
// rays are also tangent there. This is exact: coordinates are whole fractions of a cell.
//
// O(portals passed). One thread; it keeps its memory.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include "wend/sight/portals.hpp"
#include "wend/sight/sight_point.hpp"

namespace wend {

/// Where a taut path goes on that came to a corner along a ray: into one of the corner's two quadrants, and there to the
/// left of the ray, to the right of it, or both, the ray included.
struct WayOn {
  bool high;
  bool left;
  bool right;

  WayOn(const TautCorner& corner, Ray ray);
};

/// Does a ray through a corner lie in the upper one of its two quadrants? One along the row lies in the one on its
/// side.
inline bool is_high(const TautCorner& corner, Ray ray) {
  if (ray.y != 0) return ray.y > 0;
  return (ray.x > 0) == (corner.rising == 1);
}

class CornerSweep {
 public:
  explicit CornerSweep(const Portals& portals) : portals_(&portals) {}

  /// Calls tell(corner, ray to it) for every corner. Rays are in the steps of the point.
  template <class Tell>
  void from_point(const SightPoint& point, Tell&& tell) {
    const Viewer viewer{point.x, point.cell.y, point.scale};
    const std::int64_t above_row = point.y - point.scale * point.cell.y;
    Cone all{
        portals_->run_of(point.cell), point.scale - above_row, {-kFar, 1}, {kFar, 1}, false, false};
    sweep<Side::above>(all, viewer, tell, SeeNothing{});
    all.away = above_row;
    sweep<Side::below>(all, viewer, tell, SeeNothing{});
  }

  /// The same from a corner, in half cells.
  template <class Tell>
  void from_corner(std::uint32_t id, Tell&& tell) {
    from_corner(id, tell, SeeNothing{});
  }

  /// And calls see(y, first x, last x) for cells of a row from which from_point() tells this corner to their
  /// centres: for each of them at
  /// least once.
  template <class Tell, class See>
  void from_corner(std::uint32_t id, Tell&& tell, See&& see) {
    const TautCorner& corner = portals_->corners()[id];
    const Portal& portal = portals_->portal(corner.portal);
    const Viewer viewer{2 * std::int64_t{corner.x}, corner.y, 2};
    const Cone to_right{0, 2, {0, 1}, {kFar, 1}, false, false};
    const Cone to_left{0, 2, {-kFar, 1}, {0, 1}, false, false};
    Cone up = corner.rising ? to_right : to_left;
    Cone down = corner.rising ? to_left : to_right;
    up.run = portal.above;
    down.run = portal.below;
    sweep<Side::above>(up, viewer, tell, see);
    sweep<Side::below>(down, viewer, tell, see);
    along_the_row(corner, id, tell);
  }

  /// The same as without See, for what lies ahead of a path that came along a ray.
  template <class Tell>
  void from_corner_ahead(std::uint32_t id, Ray ray, Tell&& tell) {
    const TautCorner& corner = portals_->corners()[id];
    const Portal& portal = portals_->portal(corner.portal);
    const WayOn on(corner, ray);
    const Viewer viewer{2 * std::int64_t{corner.x}, corner.y, 2};
    const bool is_right = on.high == (corner.rising == 1);  // the quadrant
    Cone ahead{on.high ? portal.above : portal.below,
               2,
               {is_right ? 0 : -kFar, 1},
               {is_right ? kFar : 0, 1},
               false,
               false};
    // Left of a ray that leads downwards lies what is right on the map.
    const bool goes_left = on.high ? on.left : on.right;
    const bool goes_right = on.high ? on.right : on.left;
    const Ray along{ray.x, std::abs(ray.y)};
    if (along.y != 0 && !goes_left) ahead.left = along;
    if (along.y != 0 && !goes_right) ahead.right = along;
    if (along.y != 0 || (is_right ? goes_left : goes_right)) {
      if (on.high) {
        sweep<Side::above>(ahead, viewer, tell, SeeNothing{});
      } else {
        sweep<Side::below>(ahead, viewer, tell, SeeNothing{});
      }
    }
    const auto tell_ahead = [&](std::uint32_t other, Ray to) {
      const std::int64_t turn = cross(ray, to);
      if (is_high(corner, to) != on.high) return;
      if ((turn >= 0 && on.left) || (turn <= 0 && on.right)) tell(other, to);
    };
    along_the_row(corner, id, tell_ahead);
  }

  /// How many runs of cells it has seen, again and again: its work so far.
  std::uint64_t work() const { return work_; }

 private:
  /// More than any distance on a map, in steps.
  static constexpr std::int64_t kFar = std::int64_t{1} << 31;

  enum class Side : bool { below, above };

  struct SeeNothing {
    void operator()(int, int, int) const {}
  };

  /// Who looks: its x in steps, the row that begins at it or contains it, and how many steps a cell has.
  struct Viewer {
    std::int64_t x;
    int y;
    std::int64_t scale;
  };

  /// What is seen of a run: between two rays, both included, that end on its far side. Their y counts away from the
  /// point that looks, upwards or downwards.
  struct Cone {
    std::uint32_t run;
    std::int64_t away;  // the distance of the run's far side, in steps
    Ray left;
    Ray right;
    bool left_told;  // a corner on this ray has been told
    bool right_told;
  };

  /// -1: left of the ray, 0: on it, 1: right of it. Both y are positive.
  static std::int64_t side_of(std::int64_t x, std::int64_t away, Ray ray) {
    return x * ray.y - ray.x * away;
  }

  template <Side kSide, class Tell, class See>
  void sweep(const Cone& first, Viewer viewer, Tell& tell, const See& see) {
    cones_.assign(1, first);
    while (!cones_.empty()) {
      const Cone cone = cones_.back();
      cones_.pop_back();
      ++work_;
      if constexpr (!std::is_same_v<See, SeeNothing>) show_cells<kSide>(cone, viewer, see);
      pass<kSide>(cone, viewer, tell);
    }
  }

  /// The cells of a cone's run whose centres lie in it, but not on a ray on which a corner has been told.
  template <Side kSide, class See>
  void show_cells(const Cone& cone, Viewer viewer, const See& see) const {
    const SightRun& run = portals_->run(cone.run);
    const std::int64_t away = cone.away - 1;
    // Cell c lies at 2 c + 1 - viewer.x.
    const auto before = [&](Ray ray, bool strictly) {  // how many cells lie left of a ray
      const std::int64_t twice = 2 * ray.y;
      const std::int64_t at = ray.x * away + (viewer.x - 1) * ray.y;
      const std::int64_t whole = floor_of(at, twice);
      return strictly && whole * twice == at ? whole : whole + 1;
    };
    const std::int64_t first = before(cone.left, !cone.left_told);
    const std::int64_t end = before(cone.right, cone.right_told);
    const int left = static_cast<int>(std::max<std::int64_t>(first, run.left));
    const int right = static_cast<int>(std::min<std::int64_t>(end, run.right));
    const auto rows = static_cast<int>(cone.away / 2);
    if (left < right)
      see(kSide == Side::above ? viewer.y + rows - 1 : viewer.y - rows, left, right - 1);
  }

  static std::int64_t floor_of(std::int64_t number, std::int64_t divisor) {
    return number / divisor - (number % divisor < 0 ? 1 : 0);
  }

  /// Clips a cone to each portal on the far side of its run.
  template <Side kSide, class Tell>
  void pass(const Cone& cone, const Viewer& viewer, Tell& tell) {
    constexpr bool kUp = kSide == Side::above;
    const SightRun& run = portals_->run(cone.run);
    const std::uint32_t end = kUp ? portals_->end_above(cone.run) : portals_->end_below(cone.run);
    for (std::uint32_t id = first_seen(cone, kUp ? run.first_above : run.first_below, end, viewer);
         id < end; ++id) {
      const Portal& portal = portals_->portal(id);
      const std::int64_t x = viewer.scale * portal.left - viewer.x;
      if (side_of(x, cone.away, cone.right) > 0) return;
      pass<kSide>(cone, portal, viewer, tell);
    }
  }

  /// The first portal that ends not left of the cone.
  std::uint32_t first_seen(const Cone& cone, std::uint32_t first, std::uint32_t end,
                           const Viewer& viewer) const {
    constexpr std::uint32_t kFew = 8;
    const auto is_left = [&](std::uint32_t id) {
      const std::int64_t x = viewer.scale * portals_->portal(id).right - viewer.x;
      return side_of(x, cone.away, cone.left) < 0;
    };
    while (end - first > kFew) {
      const std::uint32_t middle = first + (end - first) / 2;
      if (is_left(middle)) {
        first = middle + 1;
      } else {
        end = middle;
      }
    }
    while (first < end && is_left(first)) ++first;
    return first;
  }

  template <Side kSide, class Tell>
  void pass(const Cone& cone, const Portal& portal, const Viewer& viewer, Tell& tell) {
    constexpr bool kUp = kSide == Side::above;
    const Ray left{viewer.scale * portal.left - viewer.x, cone.away};
    const Ray right{viewer.scale * portal.right - viewer.x, cone.away};
    const std::int64_t left_in = side_of(left.x, cone.away, cone.left);
    const std::int64_t right_in = -side_of(right.x, cone.away, cone.right);
    Cone next{kUp ? portal.above : portal.below, cone.away + viewer.scale,
              left_in > 0 ? left : cone.left,    right_in > 0 ? right : cone.right,
              left_in <= 0 && cone.left_told,    right_in <= 0 && cone.right_told};
    const auto told_on = [&](std::int64_t x) {
      return (cone.left_told && side_of(x, cone.away, cone.left) == 0) ||
             (cone.right_told && side_of(x, cone.away, cone.right) == 0);
    };
    const auto told = [&](std::uint32_t corner, Ray ray) {
      if (corner == Portals::kNoCorner || told_on(ray.x)) return false;
      if (!is_tangent(portals_->corners()[corner].blocked_cell(), kUp, ray.x)) return false;
      tell(corner, Ray{ray.x, kUp ? ray.y : -ray.y});
      return true;
    };
    if (left_in >= 0 && told(portal.left_corner, left)) next.left_told = true;
    if (portal.left == portal.right) return;  // the way through a gap turns there
    if (right_in >= 0 && told(portal.right_corner, right)) next.right_told = true;
    if (cross(next.right, next.left) == 0) {  // one ray, between obstacles on either side
      if (next.left_told || next.right_told) return;
    }
    cones_.push_back(next);
  }

  /// Is a ray to an end of a portal tangent to the obstacle there? To one on the far side only if it comes from
  /// under the opening.
  static bool is_tangent(BlockedCell blocked, bool up, std::int64_t x) {
    switch (blocked) {
      case BlockedCell::low_left:
        return up || x >= 0;
      case BlockedCell::high_left:
        return !up || x >= 0;
      case BlockedCell::low_right:
        return up || x <= 0;
      case BlockedCell::high_right:
        return !up || x <= 0;
      case BlockedCell::gap:
        break;
    }
    return true;
  }

  /// The next corner on either side of a corner, in its row, along a wall or through the opening.
  template <class Tell>
  void along_the_row(const TautCorner& corner, std::uint32_t id, const Tell& tell) const {
    const std::uint32_t number = corner.portal;
    const Portal& portal = portals_->portal(number);
    const SightRun& low = portals_->run(portal.below);
    const SightRun& high = portals_->run(portal.above);
    std::uint32_t right = Portals::kNoCorner;
    if (portal.left_corner == id && portal.left != portal.right) {
      right = portal.right_corner;
    } else if (low.right > corner.x || high.right > corner.x) {
      const std::uint32_t end = low.right > corner.x ? portals_->end_above(portal.below)
                                                     : portals_->end_below(portal.above);
      if (number + 1 < end) right = portals_->portal(number + 1).left_corner;
    }
    std::uint32_t left = Portals::kNoCorner;
    if (portal.right_corner == id && portal.left != portal.right) {
      left = portal.left_corner;
    } else if (low.left < corner.x || high.left < corner.x) {
      const std::uint32_t begin = low.left < corner.x ? low.first_above : high.first_below;
      if (number > begin) left = portals_->portal(number - 1).right_corner;
    }
    for (const std::uint32_t next : {left, right}) {
      if (next == Portals::kNoCorner) continue;
      tell(next, Ray{2 * (std::int64_t{portals_->corners()[next].x} - corner.x), 0});
    }
  }

  const Portals* portals_;
  std::vector<Cone> cones_;  // still to be passed
  std::uint64_t work_ = 0;
};

}  // namespace wend
