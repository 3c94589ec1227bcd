#include "wend/robot/sweep/footprint_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "wend/map/row_bits.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"

namespace wend {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// From where to where a shape reaches in a row.
struct Reach {
  double low = kNowhere;
  double high = -kNowhere;

  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// An edge of a shape, from its lower end to its upper one.
struct Slope {
  Point low;
  Point high;
  double per_row = 0;  // how far it goes to the right on the way up a row

  Slope(const Point& a, const Point& b) : low(a.y <= b.y ? a : b), high(a.y <= b.y ? b : a) {
    if (high.y > low.y) per_row = (high.x - low.x) / (high.y - low.y);
  }

  /// Includes the part with y in [bottom, top].
  void include_part(double bottom, double top, Reach& reach) const {
    if (high.y < bottom || low.y > top) return;
    reach.include(low.y >= bottom ? low.x : low.x + (bottom - low.y) * per_row);
    reach.include(high.y <= top ? high.x : low.x + (top - low.y) * per_row);
  }
};

/// Some rows of the map, one above the other, and how far a shape reaches in each.
class Band {
 public:
  static constexpr int kRows = 32;

  Band(int first, int last, double grown) : first_(first), last_(last), grown_(grown) {}

  int last() const { return last_; }
  const Reach& operator[](int row) const { return reach_[static_cast<std::size_t>(row - first_)]; }

  /// Includes an edge in the rows that it passes.
  void include(const Slope& edge) {
    const double low = edge.low.y - grown_;
    const double high = edge.high.y + grown_;
    if (!(high >= first_ && low <= last_ + 1)) return;
    const int begin =
        low > first_ ? std::max(static_cast<int>(std::floor(low)) - 1, first_) : first_;
    const int end = high < last_ ? std::min(static_cast<int>(std::floor(high)) + 1, last_) : last_;
    for (int row = begin; row <= end; ++row) {
      edge.include_part(row - grown_, row + 1 + grown_,
                        reach_[static_cast<std::size_t>(row - first_)]);
    }
  }

 private:
  int first_;
  int last_;
  double grown_;
  std::array<Reach, kRows> reach_;
};

/// The corners of a shape at a pose.
class PlacedCorners {
 public:
  PlacedCorners(std::span<const Point> corners, const Pose& pose) : size_(corners.size()) {
    if (size_ > kFew) many_.resize(size_);
    const std::span<Point> placed = size_ > kFew ? std::span<Point>(many_) : few_;
    const auto [sine, cosine] = sine_and_cosine(pose.heading);
    for (std::size_t i = 0; i < size_; ++i) {
      const Point& corner = corners[i];
      placed[i] = {pose.x + cosine * corner.x - sine * corner.y,
                   pose.y + sine * corner.x + cosine * corner.y};
      bottom_ = std::min(bottom_, placed[i].y);
      top_ = std::max(top_, placed[i].y);
    }
  }

  std::span<const Point> all() const {
    return size_ <= kFew ? std::span<const Point>(few_.data(), size_) : many_;
  }
  double bottom() const { return bottom_; }
  double top() const { return top_; }

 private:
  static constexpr std::size_t kFew = 64;  // corners that need no memory of their own

  std::array<Point, kFew> few_;
  std::vector<Point> many_;
  std::size_t size_;
  double bottom_ = kNowhere;
  double top_ = -kNowhere;
};

/// Is any cell of a row blocked that a shape reaches?
bool is_blocked(const FreeSpace& space, int row, const Reach& reach, double grown) {
  if (reach.low > reach.high) return false;
  const auto first = static_cast<int>(std::floor(reach.low - grown));
  const auto last = static_cast<int>(std::ceil(reach.high + grown)) - 1;
  const bool closed = space.outside() == OutsidePolicy::blocked;
  if (closed && (first < 0 || last >= space.width())) return true;
  const int from = std::max(first, 0);
  const int to = std::min(last, space.width() - 1);
  return from <= to && any_set(space.obstacles().blocked().row_words(row), from, to);
}

}  // namespace

bool is_convex(std::span<const Point> corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % count];
    const Point& c = corners[(i + 2) % count];
    if ((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) < 0) return false;
  }
  return true;
}

FootprintRows::FootprintRows(const Polygon& outline)
    : corners_(outline.corners()), convex_(is_convex(outline.corners())) {}

bool FootprintRows::meet_obstacle(const FreeSpace& space, const Pose& pose, double margin) const {
  const PlacedCorners placed(corners_, pose);
  const std::span<const Point> corners = placed.all();
  const double grown = margin - kOverlapTolerance;
  const auto first_row = static_cast<int>(std::floor(placed.bottom() - grown));
  const auto last_row = static_cast<int>(std::ceil(placed.top() + grown)) - 1;
  const bool closed = space.outside() == OutsidePolicy::blocked;
  if (closed && (first_row < 0 || last_row >= space.height())) return true;
  const int end = std::min(last_row, space.height() - 1);
  for (int first = std::max(first_row, 0); first <= end; first += Band::kRows) {
    Band band(first, std::min(first + Band::kRows - 1, end), grown);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      band.include(Slope(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]));
    }
    for (int row = first; row <= band.last(); ++row) {
      if (is_blocked(space, row, band[row], grown)) return true;
    }
  }
  return false;
}

}  // namespace wend
