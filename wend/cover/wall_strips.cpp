#include "wend/cover/wall_strips.hpp"

#include <array>
#include <cstdint>
#include <span>

#include "wend/cover/smoothed_chain.hpp"
#include "wend/map/grid.hpp"

namespace wend {
namespace {

/// A side of a cell, on which no reachable cell lies. 0: +x, then counter-clockwise.
struct Side {
  Cell cell;
  unsigned side;
};

constexpr std::array<Cell, 4> kOutward{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

Cell moved(Cell cell, Cell by) { return {cell.x + by.x, cell.y + by.y}; }

/// Follows contours: closed chains of cells, the reachable side on the left.
class ContourTracer {
 public:
  explicit ContourTracer(const CoverageArea& area)
      : area_(area), seen_(area.reachable().width(), area.reachable().height()) {}

  std::vector<std::vector<Cell>> trace() {
    std::vector<std::vector<Cell>> contours;
    for (const Cell cell : every_cell(seen_)) {
      if (!area_.reachable(cell)) continue;
      for (unsigned side = 0; side < 4; ++side) {
        if (is_border({cell, side}) && !seen({cell, side}))
          contours.push_back(follow({cell, side}));
      }
    }
    return contours;
  }

 private:
  bool is_border(Side at) const { return !area_.reachable(moved(at.cell, kOutward[at.side])); }
  bool seen(Side at) const { return ((seen_[at.cell] >> at.side) & 1U) != 0; }

  std::vector<Cell> follow(Side at) {
    std::vector<Cell> chain;
    while (!seen(at)) {
      seen_[at.cell] |= static_cast<std::uint8_t>(1U << at.side);
      if (chain.empty() || chain.back() != at.cell) chain.push_back(at.cell);
      const Cell ahead = moved(at.cell, kOutward[(at.side + 1) % 4]);
      const Cell beside = moved(ahead, kOutward[at.side]);
      if (!area_.reachable(ahead)) {
        at.side = (at.side + 1) % 4;
      } else if (!area_.reachable(beside)) {
        at.cell = ahead;
      } else {
        chain.push_back(ahead);
        at = {beside, (at.side + 3) % 4};
      }
    }
    return chain;
  }

  const CoverageArea& area_;
  Grid<std::uint8_t> seen_;  // a bit for each side
};

/// How many cells each cell of a contour is the first to cover.
std::vector<std::size_t> gains(const std::vector<Cell>& chain, CoverageArea& scratch) {
  std::vector<std::size_t> gains;
  gains.reserve(chain.size());
  for (const Cell cell : chain) {
    const std::size_t before = scratch.count_left();
    const std::array<Point, 1> place{centre_of(cell)};
    scratch.cover(place);
    gains.push_back(before - scratch.count_left());
  }
  return gains;
}

/// A part of a chain that covers something.
struct Run {
  std::size_t begin;
  std::size_t end;
  std::size_t gain;
};

/// The runs of gains, bridged where nothing is gained for a short while.
std::vector<Run> runs_of(std::span<const std::size_t> gains, std::size_t bridge) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    if (gains[i] == 0) continue;
    if (runs.empty() || i - runs.back().end > bridge) runs.push_back({i, i, 0});
    runs.back().end = i + 1;
    runs.back().gain += gains[i];
  }
  return runs;
}

/// Rotates a closed chain so that it begins behind its longest useless part.
void begin_behind_longest_gap(std::vector<Cell>& chain, std::vector<std::size_t>& gains) {
  const std::size_t n = chain.size();
  std::size_t longest = 0;
  std::size_t begin = 0;
  std::size_t gap = 0;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    gap = gains[i % n] == 0 ? gap + 1 : 0;
    if (gap <= longest || gap > n) continue;
    longest = gap;
    begin = (i + 1) % n;
  }
  std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(begin), chain.end());
  std::rotate(gains.begin(), gains.begin() + static_cast<std::ptrdiff_t>(begin), gains.end());
}

}  // namespace

std::vector<Stroke> wall_strips(CoverageArea& area, double least) {
  std::vector<Stroke> strips;
  CoverageArea scratch = area;
  const auto bridge = static_cast<std::size_t>(std::max(1.0, area.tool_width()));
  for (std::vector<Cell>& chain : ContourTracer(area).trace()) {
    std::vector<std::size_t> gained = gains(chain, scratch);
    begin_behind_longest_gap(chain, gained);
    const bool closed = !gained.empty() && gained.back() != 0;
    for (const Run& run : runs_of(gained, bridge)) {
      if (static_cast<double>(run.gain) < least) continue;
      std::vector<Cell> part(chain.begin() + static_cast<std::ptrdiff_t>(run.begin),
                             chain.begin() + static_cast<std::ptrdiff_t>(run.end));
      if (closed && run.end - run.begin == chain.size()) part.push_back(part.front());
      strips.push_back(smoothed_chain(area, part));
      area.cover(strips.back());
    }
  }
  return strips;
}

}  // namespace wend
