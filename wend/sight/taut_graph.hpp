#pragma once

// TautGraph: the corners of Portals, joined where a shortest path can go straight from one to the other: they see
// each other, and the line is tangent to both. It looks around a corner when somebody first asks for its edges, and
// keeps what it found. Who asks only seldom glances ahead instead: at the part of them that one path can take.
//
//   const wend::TautGraph::Edges ahead = graph.ahead_of(corner, ray);
//   for (std::uint32_t i = ahead.begin; i < ahead.end; ++i) reach(graph.edge(i));
//
// A shortest path that turns at a corner bends around its obstacle. So of the edges of a corner it can only take
// those that lie ahead of the edge by which it came, on that side. They are consecutive, because the edges of a
// quadrant are sorted by their angle.
//
// A corner is looked at once, in O(portals seen); 24 bytes an edge. One thread.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "wend/sight/corner_sweep.hpp"
#include "wend/sight/portals.hpp"

namespace wend {

class TautGraph {
 public:
  /// Edges [begin, end).
  struct Edges {
    std::uint32_t begin;
    std::uint32_t end;
  };

  struct Edge {
    std::uint32_t to;     // a corner
    std::uint32_t begin;  // those ahead of it, once they are known
    std::uint32_t end;
    std::uint32_t back : 31;  // the same edge the other way, once all is known
    std::uint32_t dead_end
        : 1;        // do all ways that go on from it end, in whatever order they are taken?
    double length;  // cells
  };

  explicit TautGraph(std::shared_ptr<const Portals> portals);

  const Portals& portals() const { return *portals_; }
  const Edge& edge(std::uint32_t id) const { return edges_[id]; }

  /// Have searches asked for the edges of a corner so seldom that it is cheaper to glance at what each of them needs?
  bool is_seldom_asked(std::uint32_t corner) const {
    if (fans_[corner].begin != kUnknown) return false;
    const std::uint64_t glances = glances_[corner];
    return glances == 0 || (glances < kMostGlances && 2 * glances < glances_a_look());
  }
  /// Calls tell(corner, length) where a taut path goes on that came to a corner along a ray. It looks at nothing else, and
  /// keeps nothing.
  template <class Tell>
  void glance_ahead(std::uint32_t corner, Ray ray, Tell&& tell) {
    ++glances_[corner];
    ++all_glances_;
    const std::uint64_t begun = sweep_.work();
    sweep_.from_corner_ahead(
        corner, ray, [&](std::uint32_t other, Ray to) { tell(other, length_from_corner(to)); });
    glance_work_ += sweep_.work() - begun;
  }

  /// The edges by which a taut path goes on that came along an edge.
  Edges ahead(std::uint32_t edge_id, Ray ray);
  /// The same for one that came to a corner along a ray from elsewhere.
  Edges ahead_of(std::uint32_t corner, Ray ray);
  /// Are those of an edge known to be none? Then a path that came along it can only end.
  bool is_known_end(const Edge& edge) const { return edge.begin == edge.end; }

  /// How many edges are known.
  std::size_t edges() const { return edges_.size(); }
  /// How often a corner has been looked at, with the glances that take as long.
  std::size_t looks() const { return known_ + all_glances_ / glances_a_look(); }

  /// Looks at a corner, and calls see() as CornerSweep::from_corner() does. Once for each corner, if for one.
  template <class See>
  void learn(std::uint32_t corner, See&& see) {
    begin_fan();
    const std::uint64_t begun = sweep_.work();
    sweep_.from_corner(
        corner, [&](std::uint32_t other, Ray ray) { take(corner, other, ray); }, see);
    look_work_ += sweep_.work() - begun;
    end_fan(corner);
  }
  /// Finds what lies ahead of every edge, its way back and dead ends, once every corner has been looked at. Then the
  /// rest can be asked by many threads.
  void learn_ahead();
  Edges known_ahead(std::uint32_t edge_id) const {
    return {edges_[edge_id].begin, edges_[edge_id].end};
  }
  /// All edges of a corner.
  Edges known_edges_of(std::uint32_t corner) const {
    return {fans_[corner].begin, fans_[corner].end};
  }
  Edges known_ahead_of(std::uint32_t corner, Ray ray) const {
    return ahead_in(fans_[corner], corner, ray);
  }

 private:
  static constexpr std::uint32_t kUnknown = UINT32_MAX;
  static constexpr std::uint64_t kMostGlances = UINT8_MAX;

  /// How many glances take as long as a look: 2 in mazes, 25 in the open.
  std::uint64_t glances_a_look() const {
    constexpr std::uint64_t kGuess = 2;
    if (known_ == 0 || glance_work_ == 0) return kGuess;
    return std::max(look_work_ * all_glances_ / (glance_work_ * known_), std::uint64_t{1});
  }

  /// Of a ray in half cells.
  static double length_from_corner(Ray ray) {
    const auto x = static_cast<double>(ray.x);
    const auto y = static_cast<double>(ray.y);
    return std::sqrt(x * x + y * y) / 2;
  }

  /// The edges of a corner: those above it, [begin, middle), and those below it, [middle, end).
  struct Fan {
    std::uint32_t begin = kUnknown;
    std::uint32_t middle = 0;
    std::uint32_t end = 0;
  };

  struct Seen {
    std::uint32_t corner;
    Ray ray;
  };

  const Fan& fan(std::uint32_t corner);
  void begin_fan();
  void take(std::uint32_t corner, std::uint32_t other, Ray ray);
  void end_fan(std::uint32_t corner);
  void link_back();
  void find_dead_ends();
  Edges ahead_in(const Fan& fan, std::uint32_t corner, Ray ray) const;
  Ray ray_of(std::uint32_t from, const Edge& edge) const;

  std::shared_ptr<const Portals> portals_;
  CornerSweep sweep_;
  std::vector<Fan> fans_;  // of each corner
  std::vector<Edge> edges_;
  std::vector<Seen> high_;  // what is seen of a corner that is looked at
  std::vector<Seen> low_;
  std::size_t known_ = 0;
  std::vector<std::uint8_t> glances_;  // at each corner
  std::uint64_t all_glances_ = 0;
  std::uint64_t glance_work_ = 0;
  std::uint64_t look_work_ = 0;
};

}  // namespace wend
