#include "wend/sight/taut_graph.hpp"

#include <algorithm>
#include <utility>

namespace wend {
namespace {

/// Towards the blocked cell of a corner.
Ray towards(BlockedCell cell) {
  switch (cell) {
    case BlockedCell::low_left:
      return {-1, -1};
    case BlockedCell::low_right:
      return {1, -1};
    case BlockedCell::high_left:
      return {-1, 1};
    case BlockedCell::high_right:
      return {1, 1};
    case BlockedCell::gap:
      break;
  }
  return {0, 0};
}

}  // namespace

WayOn::WayOn(const TautCorner& corner, Ray ray) : high(is_high(corner, ray)) {
  const bool is_gap = corner.blocked_cell() == BlockedCell::gap;
  left = is_gap || cross(ray, towards(corner.blocked_cell())) > 0;
  right = is_gap || !left;
}

TautGraph::TautGraph(std::shared_ptr<const Portals> portals)
    : portals_(std::move(portals)),
      sweep_(*portals_),
      fans_(portals_->corners().size()),
      glances_(fans_.size()) {}

const TautGraph::Fan& TautGraph::fan(std::uint32_t corner) {
  if (fans_[corner].begin == kUnknown) learn(corner, [](int, int, int) {});
  return fans_[corner];
}

void TautGraph::begin_fan() {
  high_.clear();
  low_.clear();
}

void TautGraph::take(std::uint32_t corner, std::uint32_t other, Ray ray) {
  (is_high(portals_->corners()[corner], ray) ? high_ : low_).push_back({other, ray});
}

void TautGraph::end_fan(std::uint32_t corner) {
  const auto append = [this](std::vector<Seen>& seen) {
    std::ranges::sort(seen, [](const Seen& a, const Seen& b) { return cross(a.ray, b.ray) > 0; });
    for (const auto& [other, ray] : seen) {
      edges_.push_back({other, kUnknown, 0, 0, 0, length_from_corner(ray)});
    }
    return static_cast<std::uint32_t>(edges_.size());
  };
  Fan& fan = fans_[corner];
  fan.begin = static_cast<std::uint32_t>(edges_.size());
  fan.middle = append(high_);
  fan.end = append(low_);
  ++known_;
}

void TautGraph::learn_ahead() {
  for (std::uint32_t corner = 0; corner < fans_.size(); ++corner) {
    for (std::uint32_t id = fans_[corner].begin; id < fans_[corner].end; ++id) {
      const Edges found = ahead_in(fans_[edges_[id].to], edges_[id].to, ray_of(corner, edges_[id]));
      edges_[id].begin = found.begin;
      edges_[id].end = found.end;
    }
  }
  link_back();
  find_dead_ends();
}

/// Both corners of an edge see each other: what is tangent from one side is tangent from the other.
void TautGraph::link_back() {
  constexpr std::uint32_t kBits = (1U << 31U) - 1;
  for (std::uint32_t corner = 0; corner < fans_.size(); ++corner) {
    for (std::uint32_t id = fans_[corner].begin; id < fans_[corner].end; ++id) {
      std::uint32_t back = fans_[edges_[id].to].begin;
      while (edges_[back].to != corner) ++back;
      edges_[id].back = back & kBits;
    }
  }
}

/// An edge is one if all edges ahead of it are. Those behind an edge are the ways back of those ahead of its way back.
void TautGraph::find_dead_ends() {
  std::vector<std::uint32_t> ways_on;  // of each edge
  std::vector<std::uint32_t> ends;     // whose predecessors are still to be told
  for (std::uint32_t id = 0; id < edges_.size(); ++id) {
    ways_on.push_back(edges_[id].end - edges_[id].begin);
    if (ways_on.back() == 0) ends.push_back(id);
  }
  while (!ends.empty()) {
    Edge& end = edges_[ends.back()];
    ends.pop_back();
    end.dead_end = 1;
    const Edge& back = edges_[end.back];
    for (std::uint32_t i = back.begin; i < back.end; ++i) {
      const std::uint32_t before = edges_[i].back;
      if (--ways_on[before] == 0) ends.push_back(before);
    }
  }
}

Ray TautGraph::ray_of(std::uint32_t from, const Edge& edge) const {
  const TautCorner& a = portals_->corners()[from];
  const TautCorner& b = portals_->corners()[edge.to];
  return {std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y};
}

TautGraph::Edges TautGraph::ahead_of(std::uint32_t corner, Ray ray) {
  return ahead_in(fan(corner), corner, ray);
}

TautGraph::Edges TautGraph::ahead_in(const Fan& all, std::uint32_t corner, Ray ray) const {
  const WayOn on(portals_->corners()[corner], ray);
  const std::uint32_t begin = on.high ? all.begin : all.middle;
  const std::uint32_t end = on.high ? all.middle : all.end;
  if (on.left && on.right) return {begin, end};
  const auto first = edges_.begin() + begin;
  const auto last = edges_.begin() + end;
  const auto split = std::partition_point(first, last, [&](const Edge& edge) {
    const std::int64_t angle = cross(ray, ray_of(corner, edge));
    return on.left ? angle < 0 : angle <= 0;
  });
  const auto middle = static_cast<std::uint32_t>(split - edges_.begin());
  return on.left ? Edges{middle, end} : Edges{begin, middle};
}

TautGraph::Edges TautGraph::ahead(std::uint32_t edge_id, Ray ray) {
  if (edges_[edge_id].begin == kUnknown) {
    const Edges found = ahead_of(edges_[edge_id].to, ray);  // may move the edges
    edges_[edge_id].begin = found.begin;
    edges_[edge_id].end = found.end;
  }
  return {edges_[edge_id].begin, edges_[edge_id].end};
}

}  // namespace wend
