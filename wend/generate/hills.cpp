#include "wend/generate/hills.hpp"

#include <algorithm>

namespace wend {
namespace {

using Height = std::uint16_t;
using Heights = Grid<Height>;
constexpr std::size_t kHeights = UINT16_MAX + std::size_t{1};

/// Random heights at the nodes of a lattice `spacing` cells wide, interpolated smoothly between them.
class Waves {
 public:
  Waves(int width, int height, int spacing, Random& random)
      : spacing_(spacing), nodes_(width / spacing + 2, height / spacing + 2) {
    for (const Cell node : every_cell(nodes_)) nodes_[node] = random.uniform();
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

Heights landscape(int width, int height, int spacing, Random& random) {
  const Waves large(width, height, spacing, random);
  const Waves middling(width, height, std::max(1, spacing / 2), random);
  const Waves small(width, height, std::max(1, spacing / 4), random);
  Heights heights(width, height);
  for (const Cell cell : every_cell(heights)) {
    const double share =
        (4 * large.height(cell) + 2 * middling.height(cell) + small.height(cell)) / 7;
    heights[cell] = static_cast<Height>(share * kHeights);
  }
  return heights;
}

/// For each height, the fraction of cells that lie lower, in [0, 1).
std::vector<double> shares_below(const Heights& heights) {
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

}  // namespace

Hills::Hills(int width, int height, int spacing, Random& random)
    : heights_(landscape(width, height, spacing, random)), share_below_(shares_below(heights_)) {}

}  // namespace wend
