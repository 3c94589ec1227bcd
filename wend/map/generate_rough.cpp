// Rough terrain: smooth hills whose cells cost 2 to 9 on easy ground, and some rocks.

#include <cmath>
#include <cstdint>
#include <vector>

#include "wend/map/generator_block.hpp"
#include "wend/map/generator_kinds.hpp"

namespace wend {
namespace {

struct RoughOptions {
  double roughness = 0.55;
  double rocks = 0.06;
  std::int64_t hill_size = 24;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"roughness", "the share of cells that cost more than 1"}, self.roughness, {0, 1});
    field({"rocks", "the share of blocked cells"}, self.rocks, {0, 1});
    field({"hill_size", "cells from one hill to the next, roughly"}, self.hill_size, {2, 10000});
  }

  MapSize least_size() const { return {3, 3}; }
};

using Height = std::uint16_t;
using Heights = Grid<Height>;
constexpr std::size_t kHeights = UINT16_MAX + std::size_t{1};

/// Random heights at the nodes of a lattice `spacing` cells wide, and smooth between them.
class Hills {
 public:
  Hills(MapSize size, int spacing, Random& random)
      : spacing_(spacing), nodes_(size.width / spacing + 2, size.height / spacing + 2) {
    for (int y = 0; y < nodes_.height(); ++y) {
      for (double& node : nodes_.row(y)) node = random.uniform();
    }
  }

  /// In [0, 1).
  double height(Cell cell) const {
    const Cell node{cell.x / spacing_, cell.y / spacing_};
    const double across = smooth_step(cell.x % spacing_);
    const double along = smooth_step(cell.y % spacing_);
    const double upper = mixed(nodes_[node], nodes_[{node.x + 1, node.y}], across);
    const double lower =
        mixed(nodes_[{node.x, node.y + 1}], nodes_[{node.x + 1, node.y + 1}], across);
    return mixed(upper, lower, along);
  }

 private:
  static double mixed(double a, double b, double share_of_b) { return a + (b - a) * share_of_b; }

  double smooth_step(int cells) const {
    const double t = (cells + 0.5) / spacing_;
    return t * t * (3 - 2 * t);
  }

  int spacing_;
  Grid<double> nodes_;
};

/// Hills with smaller ones on them.
Heights landscape(MapSize size, int spacing, Random& random) {
  const Hills large(size, spacing, random);
  const Hills middling(size, std::max(1, spacing / 2), random);
  const Hills small(size, std::max(1, spacing / 4), random);
  Heights heights(size.width, size.height);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Cell cell{x, y};
      const double height =
          (4 * large.height(cell) + 2 * middling.height(cell) + small.height(cell)) / 7;
      heights[cell] = static_cast<Height>(height * kHeights);
    }
  }
  return heights;
}

/// For each height the share of cells that lie lower, in [0, 1).
std::vector<double> share_below(const Heights& heights) {
  std::vector<std::size_t> cells_of_height(kHeights, 0);
  for (const Height height : heights.values()) ++cells_of_height[height];
  std::vector<double> share(kHeights);
  std::size_t lower = 0;
  for (std::size_t height = 0; height < kHeights; ++height) {
    share[height] = static_cast<double>(lower) / static_cast<double>(heights.size());
    lower += cells_of_height[height];
  }
  return share;
}

/// 1 up to the share of easy cells, then 2 to 9 in bands of the same size.
double cost_of_share(double share, double roughness) {
  const double easy = 1 - roughness;
  return share < easy ? 1 : 2 + std::floor(8 * (share - easy) / roughness);
}

Grid<double> terrain_of(MapSize size, const RoughOptions& options, Random& random) {
  const Heights hills = landscape(size, static_cast<int>(options.hill_size), random);
  const std::vector<double> share = share_below(hills);
  Grid<double> terrain(size.width, size.height, 1);
  if (options.roughness == 0) return terrain;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      terrain[{x, y}] = std::min(9.0, cost_of_share(share[hills[{x, y}]], options.roughness));
    }
  }
  return terrain;
}

GridMap generate(MapSize size, const RoughOptions& options, Random& random) {
  Grid<double> terrain = terrain_of(size, options, random);
  const Heights rocks =
      landscape(size, std::max(1, static_cast<int>(options.hill_size) / 2), random);
  const std::vector<double> share = share_below(rocks);
  Grid<CellState> cells(size.width, size.height, CellState::free);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (share[rocks[{x, y}]] >= 1 - options.rocks) cells[{x, y}] = CellState::occupied;
    }
  }
  for (const Cell corner : {Cell{1, 1}, Cell{size.width - 2, size.height - 2}}) {
    fill(cells, Block{corner.x, corner.y, 1, 1}.grown(1), CellState::free);
  }
  return GridMap(cells, {}, std::move(terrain));
}

}  // namespace

GeneratorInfo rough_generator() {
  GeneratorInfo info = generator_info<RoughOptions>(
      "rough", "hills whose cells cost 2 to 9, with rocks; regions may be cut off", generate);
  info.connected = false;
  return info;
}

}  // namespace wend
