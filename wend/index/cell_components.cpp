#include "wend/index/cell_components.hpp"

#include <algorithm>
#include <ranges>
#include <unordered_map>

namespace wend {
namespace {

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

CellComponents::CellComponents(const Corners& corners, const AllFirstCorners& first) {
  struct Member {
    Cell cell;
    std::size_t component;
  };
  std::vector<Member> members;
  std::unordered_map<List, std::size_t, ListHash, SameList> components;
  const BitGrid& passable = corners.passable();
  for (int y = 0; y < passable.height(); ++y) {
    for (int x = 0; x < passable.width(); ++x) {
      const Cell cell{x, y};
      if (!passable[cell] || corners.contains(cell)) continue;
      const std::size_t component =
          components.try_emplace(first.of(cell), components.size()).first->second;
      members.push_back({cell, component});
    }
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
