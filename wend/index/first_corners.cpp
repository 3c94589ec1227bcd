#include "wend/index/first_corners.hpp"

#include <algorithm>
#include <ranges>
#include <unordered_map>

#include "wend/geometry/direction.hpp"

namespace wend {
namespace {

bool is_stop(const BitGrid& passable, Cell cell, Direction straight) {
  return (jump_directions(passable.block(cell)) & set_of(straight)) != 0;
}

/// Visits every cell that has a corner in its list: back along the rays that stop there, and back
/// along the diagonals that cast them.
template <class Visit>
void visit_cells_before(const BitGrid& passable, Cell corner, Visit&& visit) {
  for (const Direction straight : kStraightDirections) {
    if (!is_stop(passable, corner, straight)) continue;
    for (Cell cell = step(corner, opposite(straight)); passable[cell];
         cell = step(cell, opposite(straight))) {
      visit(cell);
      for (const Direction diagonal : beside(straight)) {
        walk_diagonal(passable, cell, opposite(diagonal), [&](Cell start) {
          visit(start);
          return true;
        });
      }
      if (is_stop(passable, cell, straight)) break;
    }
  }
}

using List = std::span<const std::uint32_t>;

struct ListHash {
  std::size_t operator()(List list) const {
    std::uint64_t hash = list.size();
    for (const std::uint32_t corner : list) {
      hash = (hash ^ corner) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
};

struct SameList {
  bool operator()(List a, List b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
};

}  // namespace

AllFirstCorners::AllFirstCorners(const Corners& corners, const IndexBuilding& building)
    : width_(corners.passable().width()),
      begins_(static_cast<std::size_t>(width_) *
                  static_cast<std::size_t>(corners.passable().height()) +
              1) {
  const BitGrid& passable = corners.passable();
  const auto count = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t corner = 0; corner < count; ++corner) {
    if (building.cancelled()) return;
    visit_cells_before(passable, corners.cell(corner),
                       [&](Cell cell) { ++begins_[number_of(cell)]; });
  }
  std::size_t end = 0;  // filling moves each to its begin
  for (std::size_t& begin : begins_) begin = end += begin;
  corners_.resize(end);
  for (std::uint32_t corner = count; corner-- > 0;) {
    if (building.cancelled()) return;
    visit_cells_before(passable, corners.cell(corner),
                       [&](Cell cell) { corners_[--begins_[number_of(cell)]] = corner; });
  }
}

CellComponents::CellComponents(const Corners& corners, const AllFirstCorners& first,
                               const IndexBuilding& building) {
  struct Member {
    Cell cell;
    std::size_t component;
  };
  std::vector<Member> members;
  std::unordered_map<List, std::size_t, ListHash, SameList> components;
  const BitGrid& passable = corners.passable();
  for (const Cell cell : every_cell(passable)) {
    if (!passable[cell] || corners.contains(cell)) continue;
    if (building.cancelled()) return;
    const std::size_t component =
        components.try_emplace(first.of(cell), components.size()).first->second;
    members.push_back({cell, component});
  }
  begins_.resize(components.size() + 1);
  for (const Member& member : members) ++begins_[member.component];
  std::size_t end = 0;  // filling moves each to its begin
  for (std::size_t& begin : begins_) begin = end += begin;
  cells_.resize(members.size());
  for (const Member& member : members | std::views::reverse) {
    cells_[--begins_[member.component]] = member.cell;
  }
}

}  // namespace wend
