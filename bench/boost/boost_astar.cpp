#include "bench/boost/boost_astar.hpp"

#include <algorithm>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace wend::bench {
namespace {

// Floats halve the memory that Boost goes through. The heuristic uses the same rounded number, so
// that it stays consistent.
constexpr float kDiagonal = std::numbers::sqrt2_v<float>;

struct Step {
  float length;
};

using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Step,
                                                 boost::no_property, std::uint32_t, std::uint32_t>;
using Vertex = boost::graph_traits<Graph>::vertex_descriptor;

Graph make_graph(const FreeSpace& space) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<Step> steps;
  const auto vertex = [&](Cell cell) {
    return static_cast<std::uint32_t>(cell.y) * static_cast<std::uint32_t>(space.width()) +
           static_cast<std::uint32_t>(cell.x);
  };
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      if (!space.passable({x, y})) continue;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if ((dx == 0 && dy == 0) || !space.passable({x + dx, y + dy})) continue;
          if (!space.passable({x + dx, y}) || !space.passable({x, y + dy})) continue;
          edges.emplace_back(vertex({x, y}), vertex({x + dx, y + dy}));
          steps.push_back({dx != 0 && dy != 0 ? kDiagonal : 1.0F});
        }
      }
    }
  }
  return {boost::edges_are_sorted, edges.begin(), edges.end(), steps.begin(),
          static_cast<std::uint32_t>(space.map().size())};
}

/// Octile distance to the goal.
class Octile : public boost::astar_heuristic<Graph, double> {
 public:
  Octile(int width, Vertex goal) : width_(width), goal_(cell(goal)) {}

  double operator()(Vertex vertex) const {
    const Cell here = cell(vertex);
    const double dx = std::abs(here.x - goal_.x);
    const double dy = std::abs(here.y - goal_.y);
    return std::max(dx, dy) + (double{kDiagonal} - 1) * std::min(dx, dy);
  }

 private:
  Cell cell(Vertex vertex) const {
    return {static_cast<int>(vertex) % width_, static_cast<int>(vertex) / width_};
  }

  int width_;
  Cell goal_;
};

constexpr double kNoPath = std::numeric_limits<double>::infinity();

struct Ended {
  Status status;
};

/// Counts expansions and ends the search at the goal, as Boost's own example does, or at a limit.
class UntilGoal : public boost::default_astar_visitor {
 public:
  UntilGoal(Vertex goal, std::uint64_t& expanded, const Limits& limits)
      : goal_(goal),
        expanded_(&expanded),
        limits_(&limits),
        deadline_(limits.timed() ? limits.now() + limits.seconds : 0) {}

  void examine_vertex(Vertex vertex, const Graph& /*graph*/) {
    if (*expanded_ % Limits::kExpansionsBetweenClockReads == 0) look();
    if (*expanded_ >= limits_->expansions) throw Ended{Status::expansion_limit};
    ++*expanded_;
    if (vertex == goal_) throw Ended{Status::found};
  }

 private:
  void look() const {
    if (limits_->cancel != nullptr && limits_->cancel->load(std::memory_order_relaxed)) {
      throw Ended{Status::cancelled};
    }
    if (limits_->clock && limits_->clock() > deadline_) throw Ended{Status::time_limit};
  }

  Vertex goal_;
  std::uint64_t* expanded_;
  const Limits* limits_;
  double deadline_;
};

}  // namespace

struct BoostAStar::Search {
  explicit Search(const FreeSpace& space)
      : width(space.width()),
        graph(make_graph(space)),
        predecessors(num_vertices(graph)),
        costs(num_vertices(graph)),
        estimates(num_vertices(graph)),
        colours(num_vertices(graph)) {}

  int width;
  Graph graph;
  std::vector<Vertex> predecessors;
  std::vector<double> costs;
  std::vector<double> estimates;
  std::vector<boost::default_color_type> colours;
};

BoostAStar::BoostAStar(const FreeSpace& space) : search_(std::make_unique<Search>(space)) {}
BoostAStar::~BoostAStar() = default;
BoostAStar::BoostAStar(BoostAStar&&) noexcept = default;
BoostAStar& BoostAStar::operator=(BoostAStar&&) noexcept = default;

BoostAStar::Answer BoostAStar::plan(Cell start, Cell goal, Path& path, const Limits& limits) {
  Search& search = *search_;
  const auto vertex = [&](Cell cell) {
    return static_cast<Vertex>(cell.y) * static_cast<Vertex>(search.width) +
           static_cast<Vertex>(cell.x);
  };
  const auto index = get(boost::vertex_index, search.graph);
  std::uint64_t expanded = 0;
  path.clear();
  try {
    boost::astar_search(
        search.graph, vertex(start), Octile(search.width, vertex(goal)),
        boost::visitor(UntilGoal(vertex(goal), expanded, limits))
            .weight_map(get(&Step::length, search.graph))
            .predecessor_map(boost::make_iterator_property_map(search.predecessors.begin(), index))
            .distance_map(boost::make_iterator_property_map(search.costs.begin(), index))
            .rank_map(boost::make_iterator_property_map(search.estimates.begin(), index))
            .color_map(boost::make_iterator_property_map(search.colours.begin(), index)));
  } catch (const Ended& ended) {
    if (ended.status != Status::found) return {ended.status, kNoPath, expanded};
    for (Vertex at = vertex(goal);; at = search.predecessors[at]) {
      path.append({static_cast<int>(at) % search.width, static_cast<int>(at) / search.width});
      if (at == vertex(start)) break;
    }
    path.reverse();
    return {Status::found, path.length(), expanded};
  }
  return {Status::unreachable, kNoPath, expanded};
}

}  // namespace wend::bench
