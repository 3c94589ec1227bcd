#include "bench/comparison/random_queries.hpp"

#include "wend/base/random.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/space/lattice/car_lattice.hpp"

namespace wend {
namespace {

/// The cells of each component by its label, in the order of the map; those of one cell have no pairs.
std::vector<std::vector<Cell>> components_with_pairs(const BitGrid& cells,
                                                     const ConnectedComponents& components,
                                                     Adjacency adjacency) {
  std::vector<std::vector<Cell>> lists(components.count(adjacency) + 1);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      const Cell cell{x, y};
      if (components.size_of_component(cell, adjacency) < 2) continue;
      lists[components.component(cell, adjacency)].push_back(cell);
    }
  }
  return lists;
}

/// Pairs of different cells of the same component; empty if there are no such pairs.
std::vector<CellPair> connected_pairs(const BitGrid& cells, const ConnectedComponents& components,
                                      Adjacency adjacency, std::uint64_t count, Random& random) {
  const std::vector<std::vector<Cell>> lists = components_with_pairs(cells, components, adjacency);
  std::vector<Cell> starts;
  for (const auto& list : lists) starts.insert(starts.end(), list.begin(), list.end());
  std::vector<CellPair> pairs;
  if (starts.empty()) return pairs;
  pairs.reserve(count);
  while (pairs.size() < count) {
    const Cell start = starts[random.below(starts.size())];
    const auto& component = lists[components.component(start, adjacency)];
    const Cell goal = component[random.below(component.size())];
    if (goal != start) pairs.push_back({start, goal});
  }
  return pairs;
}

}  // namespace

std::vector<CellPair> random_pairs(const FreeSpace& space, std::uint64_t count,
                                   std::uint64_t seed) {
  Random random(seed);
  return connected_pairs(space.passable(), space.components(), Adjacency::edges, count, random);
}

std::vector<Query> random_drives(const FreeSpace& space, const PlaceGrid& places,
                                 std::uint64_t count, std::uint64_t seed) {
  const CarDriving driving{.unit = places.spacing};
  std::vector<Query> queries;
  if (!has_room_for(space.map(), driving)) return queries;
  const CarLattice lattice(space, driving);
  Random random(seed);
  const auto pose = [&](Cell corner) {
    return lattice.to_grid({corner, kAllHeadings[random.below(kHeadings)]});
  };
  const ConnectedComponents components(lattice.passable());
  for (const CellPair& corners : connected_pairs(lattice.passable(), components,
                                                 Adjacency::edges_and_corners, count, random)) {
    const Pose start = pose(corners.start);
    queries.push_back({start, {pose(corners.goal)}});
  }
  return queries;
}

}  // namespace wend
