#include "wend/cover/pruning.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "wend/map/grid.hpp"

namespace wend {
namespace {

/// How many strokes cover each cell that is wanted.
class Counts {
 public:
  explicit Counts(const CoverageArea& area)
      : area_(area),
        counts_(area.wanted().width(), area.wanted().height(), 0),
        stamps_(area.wanted().width(), area.wanted().height(), 0) {}

  void add(const Stroke& stroke, int sign) {
    visit(stroke, [&](Cell cell) { counts_[cell] += sign; });
  }

  /// The cells that only this stroke covers.
  std::size_t own(const Stroke& stroke) {
    std::size_t own = 0;
    visit(stroke, [&](Cell cell) { own += counts_[cell] == 1 ? 1 : 0; });
    return own;
  }

 private:
  /// Each cell once.
  template <class Visit>
  void visit(const Stroke& stroke, Visit&& visit) {
    ++stamp_;
    const std::size_t lines = std::max<std::size_t>(1, stroke.size() - 1);
    for (std::size_t i = 0; i < lines; ++i) {
      const Line line{stroke[i], stroke[std::min(i + 1, stroke.size() - 1)]};
      visit_cells_near(line, area_.reach(), counts_.width(), counts_.height(), [&](Cell cell) {
        if (!area_.wanted()[cell] || stamps_[cell] == stamp_) return;
        stamps_[cell] = stamp_;
        visit(cell);
      });
    }
  }

  const CoverageArea& area_;
  Grid<std::int32_t> counts_;
  Grid<std::uint32_t> stamps_;
  std::uint32_t stamp_ = 0;
};

}  // namespace

std::vector<Stroke> pruned(const CoverageArea& area, std::vector<Stroke> strokes,
                           std::size_t may_stay) {
  Counts counts(area);
  for (const Stroke& stroke : strokes) counts.add(stroke, 1);
  struct Candidate {
    std::size_t stroke;
    double worth;  // cells for a cell of way
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const double way = length_of(strokes[i]) + 2 * area.tool_width();
    candidates.push_back({i, static_cast<double>(counts.own(strokes[i])) / way});
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::worth);
  for (const Candidate& candidate : candidates) {
    Stroke& stroke = strokes[candidate.stroke];
    const std::size_t own = counts.own(stroke);
    if (own > may_stay) continue;
    may_stay -= own;
    counts.add(stroke, -1);
    stroke.clear();
  }
  std::erase_if(strokes, [](const Stroke& stroke) { return stroke.empty(); });
  return strokes;
}

}  // namespace wend
