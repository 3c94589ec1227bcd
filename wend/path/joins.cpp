#include "wend/path/joins.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {
namespace {

/// The items of the first leg, and those of the others but for the first of each.
template <class ItemsOf>
auto in_a_row(std::span<const Path> legs, ItemsOf items_of) {
  const auto first = items_of(legs.front());
  std::vector all(first.begin(), first.end());
  for (const Path& leg : legs.subspan(1)) {
    const auto items = items_of(leg);
    all.insert(all.end(), items.begin() + 1, items.end());
  }
  return all;
}

}  // namespace

Path part_of(const Path& path, std::size_t first, std::size_t last) {
  assert(first <= last && last < path.size());
  const auto some = [&](auto joints) {
    const auto part = joints.subspan(first, last - first + 1);
    return std::vector(part.begin(), part.end());
  };
  return path.visit([&](std::span<const Cell> cells) { return Path(some(cells)); },
                    [&](std::span<const Point> waypoints) {
                      return path.leads_over_cells() ? Path::over_cells(some(waypoints))
                                                     : Path::along(some(waypoints));
                    },
                    [&](const JoinedPoses& drive) { return Path::through(some(drive.poses())); });
}

Path end_to_end(std::span<const Path> legs) {
  assert(std::ranges::none_of(legs, &Path::empty));
  if (legs.front().driven()) {
    return Path::through(in_a_row(legs, [](const Path& leg) { return leg.driven_poses(); }));
  }
  if (std::ranges::none_of(legs, [](const Path& leg) { return leg.cells().empty(); })) {
    return Path(in_a_row(legs, [](const Path& leg) { return leg.cells(); }));
  }
  std::vector<Point> points = in_a_row(legs, [](const Path& leg) { return leg.points(); });
  return std::ranges::all_of(legs, &Path::leads_over_cells) ? Path::over_cells(std::move(points))
                                                            : Path::along(std::move(points));
}

std::optional<Error> fault_of_joins(std::span<const std::size_t> joins, std::size_t size) {
  std::size_t least = 0;
  for (const std::size_t join : joins) {
    if (join < least || join >= size) {
      return Error{Status::invalid_option,
                   "join " + std::to_string(join) + " must be a point from " +
                       std::to_string(least) + " on of a path of " + std::to_string(size),
                   "joins"};
    }
    least = join;
  }
  return std::nullopt;
}

std::vector<Path> legs_between(const Path& path, std::span<const std::size_t> joins) {
  std::vector<Path> legs;
  std::size_t first = 0;
  for (const std::size_t join : joins) {
    legs.push_back(part_of(path, first, join));
    first = join;
  }
  legs.push_back(part_of(path, first, path.size() - 1));
  return legs;
}

}  // namespace wend
