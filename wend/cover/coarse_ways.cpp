#include "wend/cover/coarse_ways.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

namespace wend {
namespace {

constexpr std::array<Cell, 4> kBeside{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

}  // namespace

CoarseWays::CoarseWays(const CoverageArea& area, int block)
    : nodes_(area.reachable().width(), area.reachable().height(), 0) {
  label(area, block);
  link(area);
}

void CoarseWays::label(const CoverageArea& area, int block) {
  std::vector<Cell> cells;
  for (const Cell first : every_cell(nodes_)) {
    if (!area.reachable(first) || nodes_[first] != 0) continue;
    const auto node = static_cast<std::uint32_t>(middles_.size() + 1);
    nodes_[first] = node;
    cells.assign(1, first);
    Point sum;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell from = cells[i];
      sum = {sum.x + from.x + 0.5, sum.y + from.y + 0.5};
      for (const Cell by : kBeside) {
        const Cell to{from.x + by.x, from.y + by.y};
        if (!area.reachable(to) || nodes_[to] != 0) continue;
        if (to.x / block != first.x / block || to.y / block != first.y / block) continue;
        nodes_[to] = node;
        cells.push_back(to);
      }
    }
    const auto count = static_cast<double>(cells.size());
    middles_.push_back({sum.x / count, sum.y / count});
  }
}

void CoarseWays::link(const CoverageArea& area) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Cell cell : every_cell(nodes_)) {
    if (!area.reachable(cell)) continue;
    for (const Cell to : {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}}) {
      if (area.reachable(to) && nodes_[to] != nodes_[cell]) {
        pairs.emplace_back(node_of(cell), node_of(to));
        pairs.emplace_back(node_of(to), node_of(cell));
      }
    }
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  links_.resize(middles_.size());
  for (const auto& [from, to] : pairs) {
    links_[from].push_back({to, distance(middles_[from], middles_[to])});
  }
  // What is diagonally beside: else ways would have corners.
  const std::vector<std::vector<Link>> beside = links_;
  for (std::uint32_t from = 0; from < beside.size(); ++from) {
    for (const Link& link : beside[from]) {
      for (const Link& next : beside[link.to]) {
        if (next.to <= from || !area.free_along(middles_[from], middles_[next.to])) continue;
        const double length = distance(middles_[from], middles_[next.to]);
        links_[from].push_back({next.to, length});
        links_[next.to].push_back({from, length});
      }
    }
  }
}

std::vector<double> CoarseWays::lengths_from(std::uint32_t node) const {
  std::vector<double> lengths(middles_.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  lengths[node] = 0;
  open.emplace(0, node);
  while (!open.empty()) {
    const auto [length, from] = open.top();
    open.pop();
    if (length > lengths[from]) continue;
    for (const Link& link : links_[from]) {
      const double there = length + link.length;
      if (there >= lengths[link.to]) continue;
      lengths[link.to] = there;
      open.emplace(there, link.to);
    }
  }
  return lengths;
}

}  // namespace wend
