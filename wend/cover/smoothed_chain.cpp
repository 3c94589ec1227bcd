#include "wend/cover/smoothed_chain.hpp"

namespace wend {
namespace {

constexpr double kTolerance = 0.75;  // cells: the tool hardly covers less than along the chain

bool stays_near(std::span<const Cell> chain, std::size_t from, std::size_t to) {
  const Line line{centre_of(chain[from]), centre_of(chain[to])};
  for (std::size_t i = from + 1; i < to; ++i) {
    if (distance(line, centre_of(chain[i])) > kTolerance) return false;
  }
  return true;
}

/// The last cell that a straight line from a cell may lead to.
std::size_t farthest(const CoverageArea& area, std::span<const Cell> chain, std::size_t from) {
  const auto may = [&](std::size_t to) {
    return to < chain.size() && stays_near(chain, from, to) &&
           area.free_along(centre_of(chain[from]), centre_of(chain[to]));
  };
  std::size_t step = 1;
  while (may(from + 2 * step)) step *= 2;
  std::size_t best = from + step;
  for (; step > 0; step /= 2) {
    if (may(best + step)) best += step;
  }
  return best;
}

}  // namespace

Stroke smoothed_chain(const CoverageArea& area, std::span<const Cell> chain) {
  Stroke stroke{centre_of(chain.front())};
  for (std::size_t i = 0; i + 1 < chain.size();) {
    i = farthest(area, chain, i);
    stroke.push_back(centre_of(chain[i]));
  }
  return stroke;
}

}  // namespace wend
