#include "wend/cover/swaths.hpp"

#include <algorithm>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr int kAngles = 12;
constexpr std::size_t kMostToCompare = 60'000;  // cells of a part, for comparing angles

/// The axes of swaths: `along` them, and `across`.
class Axes {
 public:
  explicit Axes(double angle) : turn_(sine_and_cosine(angle)) {}

  double along(Point p) const { return p.x * turn_.cosine + p.y * turn_.sine; }
  double across(Point p) const { return -p.x * turn_.sine + p.y * turn_.cosine; }
  Point at(double along, double across) const {
    return {along * turn_.cosine - across * turn_.sine, along * turn_.sine + across * turn_.cosine};
  }

 private:
  SineCosine turn_;
};

/// A cell in these axes.
struct Spot {
  double along;
  double across;
  bool covered = false;
};

/// Lays swaths over spots, from the lowest across on.
class Sweep {
 public:
  Sweep(const CoverageArea& area, const Axes& axes, double overlap)
      : area_(area), axes_(axes), overlap_(overlap) {}

  std::vector<Stroke> over(std::span<const Cell> cells) {
    spots_.clear();
    for (const Cell cell : cells) {
      const Point p = centre_of(cell);
      spots_.push_back({axes_.along(p), axes_.across(p)});
    }
    std::ranges::sort(spots_, {}, &Spot::across);
    strokes_.clear();
    missed_ = 0;
    const double greatest = spots_.back().across;
    for (std::size_t i = 0; i < spots_.size();) {
      if (spots_[i].covered) {
        ++i;
        continue;
      }
      const double lowest = spots_[i].across;
      lay(i, line_above(lowest, greatest));
      for (; i < spots_.size() && spots_[i].across <= lowest + kRow; ++i) {
        if (!spots_[i].covered) ++missed_;
      }
    }
    return strokes_;
  }

  /// How many spots the strokes leave over.
  std::size_t missed() const { return missed_; }

 private:
  static constexpr double kRow = 0.75;  // cells: spots that count as one row across
  static constexpr double kMargin =
      0.35;  // cells: the lowest row is reached along a stretch, not in a point

  /// As far above the lowest spots as covers them; less if less is left.
  double line_above(double lowest, double greatest) const {
    const double most = std::max(area_.reach() - kMargin - overlap_, area_.reach() / 4);
    return greatest - lowest < 2 * most ? (lowest + greatest) / 2 : lowest + most;
  }

  double half_chord(const Spot& spot, double across) const {
    const double offset = spot.across - across;
    return std::sqrt(std::max(0.0, area_.reach() * area_.reach() - offset * offset));
  }

  /// Lays strokes on one line for the spots that it reaches, from the first spot on.
  void lay(std::size_t first, double across) {
    reached_.clear();
    for (std::size_t i = first; i < spots_.size() && spots_[i].across <= across + area_.reach();
         ++i) {
      if (!spots_[i].covered && spots_[i].across >= across - area_.reach()) reached_.push_back(i);
    }
    std::ranges::sort(reached_, {}, [&](std::size_t i) { return spots_[i].along; });
    const double bridge = 2 * area_.tool_width();
    for (std::size_t begin = 0; begin < reached_.size();) {
      std::size_t end = begin + 1;
      while (end < reached_.size() &&
             spots_[reached_[end]].along - spots_[reached_[end - 1]].along < bridge) {
        ++end;
      }
      lay_run(std::span(reached_).subspan(begin, end - begin), across);
      begin = end;
    }
  }

  /// Where a stroke over these spots has to begin and to end.
  std::pair<double, double> extent(std::span<const std::size_t> run, double across) const {
    double begin = std::numeric_limits<double>::infinity();
    double end = -begin;
    for (const std::size_t i : run) {
      const double chord = half_chord(spots_[i], across);
      begin = std::min(begin, spots_[i].along + chord);
      end = std::max(end, spots_[i].along - chord);
    }
    if (begin > end) begin = end = (begin + end) / 2;
    return {begin, end};
  }

  void lay_run(std::span<const std::size_t> run, double across) {
    const auto [begin, end] = extent(run, across);
    if (add(run, begin, end, across)) return;
    // Not free all the way: the free pieces of it.
    const auto pieces = free_pieces(begin, end, across);
    for (const auto& [from, to] : pieces) {
      std::vector<std::size_t> here;
      for (const std::size_t i : run) {
        const double chord = half_chord(spots_[i], across);
        if (!spots_[i].covered && spots_[i].along + chord >= from &&
            spots_[i].along - chord <= to) {
          here.push_back(i);
        }
      }
      if (here.empty()) continue;
      auto [first, last] = extent(here, across);
      first = std::clamp(first, from, to);
      last = std::clamp(last, first, to);
      add(here, first, last, across);
    }
  }

  std::vector<std::pair<double, double>> free_pieces(double begin, double end,
                                                     double across) const {
    std::vector<std::pair<double, double>> pieces;
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * (end - begin))));
    bool open = false;
    for (int i = 0; i <= steps; ++i) {
      const double at = begin + (end - begin) * i / steps;
      const Point here = axes_.at(at, across);
      if (open && area_.free_along(axes_.at(pieces.back().second, across), here)) {
        pieces.back().second = at;
      } else {
        open = area_.free_along(here, here);
        if (open) pieces.emplace_back(at, at);
      }
    }
    return pieces;
  }

  bool add(std::span<const std::size_t> run, double begin, double end, double across) {
    const Point from = axes_.at(begin, across);
    const Point to = axes_.at(end, across);
    if (!area_.free_along(from, to)) return false;
    for (const std::size_t i : run) {
      const double chord = half_chord(spots_[i], across);
      if (spots_[i].along + chord >= begin && spots_[i].along - chord <= end)
        spots_[i].covered = true;
    }
    if (end > begin) {
      strokes_.push_back({from, to});
    } else {
      strokes_.push_back({from});
    }
    return true;
  }

  const CoverageArea& area_;
  const Axes& axes_;
  double overlap_;
  std::vector<Spot> spots_;
  std::vector<std::size_t> reached_;
  std::vector<Stroke> strokes_;
  std::size_t missed_ = 0;
};

/// About what strokes cost, with the ways between them, their turns, and what they leave over.
double cost_of(const std::vector<Stroke>& strokes, double missed, const CoverageArea& area,
               double turn_cost) {
  double cost = 2 * missed / area.tool_width();
  for (const Stroke& stroke : strokes) cost += length_of(stroke) + area.tool_width() + turn_cost;
  return cost;
}

/// A sample of a part's cells, at random: rows and columns of it would favour some angles.
std::vector<Cell> sample_of(std::span<const Cell> part) {
  if (part.size() <= kMostToCompare) return {part.begin(), part.end()};
  const double share = static_cast<double>(kMostToCompare) / static_cast<double>(part.size());
  Random random(1);
  std::vector<Cell> sample;
  for (const Cell cell : part) {
    if (random.chance(share)) sample.push_back(cell);
  }
  return sample;
}

double cheapest_angle(const CoverageArea& area, std::span<const Cell> part,
                      const SwathOptions& options) {
  const std::vector<Cell> sample = sample_of(part);
  const double scale = static_cast<double>(part.size()) / static_cast<double>(sample.size());
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kAngles; ++i) {
    const double angle = kPi * i / kAngles;
    const Axes axes(angle);
    Sweep sweep(area, axes, options.overlap);
    const std::vector<Stroke> strokes = sweep.over(sample);
    const double missed = static_cast<double>(sweep.missed()) * scale;
    const double cost = cost_of(strokes, missed, area, options.turn_cost);
    if (cost < least - 1e-9) {
      least = cost;
      best = angle;
    }
  }
  return best;
}

}  // namespace

std::vector<Stroke> swaths(CoverageArea& area, std::span<const Cell> part,
                           const SwathOptions& options) {
  if (part.empty()) return {};
  const Axes axes(options.angle ? *options.angle : cheapest_angle(area, part, options));
  std::vector<Stroke> strokes = Sweep(area, axes, options.overlap).over(part);
  std::erase_if(strokes, [&](const Stroke& stroke) {
    const std::size_t before = area.count_left();
    area.cover(stroke);
    return area.count_left() == before;
  });
  return strokes;
}

}  // namespace wend
