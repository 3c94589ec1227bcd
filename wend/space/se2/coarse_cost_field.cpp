#include "wend/space/se2/coarse_cost_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wend {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr double kNoWay = std::numeric_limits<double>::infinity();
constexpr float kBucketWidth = 0.25F;   // squares
constexpr float kWorthwhile = 0.9995F;  // a smaller gain is not worth another round

/// The upwind solution for a square of cost `cost` between its cheaper neighbours along both axes; `before` if it is
/// clear without a square root that it is no gain over that.
float upwind(float a, float b, float cost, float before) {
  constexpr float kClearly = 0.9998F;  // nearer to 1 than kWorthwhile, by far more than rounding
  const float low = std::min(a, b);
  const float gap = std::max(a, b) - low;
  if (!(gap < cost)) return low + cost;
  const float rest = 2 * cost * cost - gap * gap;
  const float least_gain = 2 * before * kClearly - (a + b);
  if (!(least_gain > 0) || least_gain * least_gain <= rest) return before;
  return (a + b + std::sqrt(rest)) / 2;
}

}  // namespace

CoarseCostField::CoarseCostField(const CoarseGrid& grid)
    : grid_(grid),
      values_(grid.count(), kUnknown),
      settled_flags_(grid.count(), 0),
      touched_(std::make_unique_for_overwrite<std::uint32_t[]>(grid.count() + 1)),
      per_width_(1 / (kBucketWidth * static_cast<float>(grid.size()))),
      size_(static_cast<float>(grid.size())) {}

void CoarseCostField::begin(std::span<const Seed> goals, Point start, std::function<bool()> stop) {
  stop_ = std::move(stop);
  for (std::size_t i = 0; i < touched_count_; ++i) {
    values_[touched_[i]] = kUnknown;
    settled_flags_[touched_[i]] = 0;
  }
  touched_count_ = 0;
  queue_.begin(0, 0);
  bucket_.clear();
  taken_ = settled_ = 0;
  start_ = start;
  first_key_ = 0;
  float least = kUnknown;
  for (const Seed& goal : goals) {
    least = std::min(least, static_cast<float>(straight_distance(goal.point, start)));
  }
  first_key_ = least - 2 * size_;  // a square in which a goal lies may be nearer
  for (const Seed& goal : goals) seed(goal);
}

/// Is every square on the line between two squares open, and none dear?
bool CoarseCostField::in_sight(int column, int row, int to_column, int to_row) const {
  const int steps = 2 * std::max(std::abs(to_column - column), std::abs(to_row - row));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps == 0 ? 0 : static_cast<double>(i) / steps;
    const auto x = static_cast<int>(std::lround(column + share * (to_column - column)));
    const auto y = static_cast<int>(std::lround(row + share * (to_row - row)));
    if (grid_.multiplier(grid_.index(x, y)) != 1) return false;
  }
  return true;
}

/// Gives the squares in sight of a goal their costs: differences are coarse there. The square of the goal gets one
/// in any case.
void CoarseCostField::seed(const Seed& goal) {
  const auto column = static_cast<int>(std::floor(goal.point.x / size_));
  const auto row = static_cast<int>(std::floor(goal.point.y / size_));
  const auto reach = static_cast<int>(goal.reach / size_);
  for (int y = std::max(row - reach, 0); y <= std::min(row + reach, grid_.rows() - 1); ++y) {
    for (int x = std::max(column - reach, 0); x <= std::min(column + reach, grid_.columns() - 1);
         ++x) {
      const std::size_t square = grid_.index(x, y);
      const bool here = x == column && y == row;
      const Point middle = grid_.middle(square);
      if (!grid_.open(square) || straight_distance(middle, goal.point) > goal.reach + size_)
        continue;
      if (!here && !in_sight(column, row, x, y)) continue;
      improve(static_cast<std::uint32_t>(x + 1), static_cast<std::uint32_t>(y + 1),
              static_cast<std::uint32_t>(square),
              static_cast<float>(goal.cost(middle) * grid_.multiplier(square)));
    }
  }
}

CoarseCostField::Around CoarseCostField::around(Point point) const {
  const double x = point.x / grid_.size() - 0.5;
  const double y = point.y / grid_.size() - 0.5;
  const double left = std::floor(x);
  const double below = std::floor(y);
  const std::size_t square = grid_.index(static_cast<int>(left), static_cast<int>(below));
  return {{square, square + 1, square + grid_.stride(), square + grid_.stride() + 1},
          x - left,
          y - below};
}

float CoarseCostField::key(std::uint32_t column, std::uint32_t row, float value) const {
  const auto middle = [&](std::uint32_t place) {
    return (static_cast<float>(static_cast<std::int32_t>(place)) - 0.5F) * size_;
  };
  const float dx = middle(column) - static_cast<float>(start_.x);
  const float dy = middle(row) - static_cast<float>(start_.y);
  return value + std::sqrt(dx * dx + dy * dy);
}

[[gnu::always_inline]] inline void CoarseCostField::improve(std::uint32_t column, std::uint32_t row,
                                                            std::uint32_t square, float value) {
  const float before = values_[square];
  if (!(value < before * kWorthwhile)) return;
  touched_[touched_count_] = square;
  touched_count_ += before == kUnknown ? 1 : 0;
  values_[square] = value;
  const float ahead = std::max(0.0F, (key(column, row, value) - first_key_) * per_width_);
  const auto bucket = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::min(ahead, 1e15F)));
  queue_.push(std::max(bucket, queue_.least_key()), {square, value});
}

void CoarseCostField::go_to_next_bucket() {
  bucket_.clear();
  queue_.take_bucket(bucket_);
  taken_ = 0;
}

bool CoarseCostField::settle_next() {
  while (!exhausted()) {
    if (taken_ == bucket_.size()) go_to_next_bucket();
    const Waiting next = bucket_[taken_++];
    if (next.value != values_[next.square]) continue;  // it has got a better value since
    ++settled_;
    settled_flags_[next.square] = 1;
    expand(next);
    return true;
  }
  return false;
}

/// The upwind solution for a square. Where there is no way to a neighbour, the square's own value stands for it: what
/// follows from that is no gain.
inline float CoarseCostField::updated(std::uint32_t square) const {
  const std::size_t up = grid_.stride();
  const std::uint8_t sides = grid_.sides(square);
  const auto value = [&](std::uint8_t side, std::size_t step) {
    return values_[square + ((sides & side) != 0 ? step : 0)];
  };
  const float along =
      std::min(value(CoarseGrid::kRight, 1), value(CoarseGrid::kLeft, -std::size_t{1}));
  const float across = std::min(value(CoarseGrid::kAbove, up), value(CoarseGrid::kBelow, -up));
  return upwind(along, across, grid_.multiplier(square) * size_, values_[square]);
}

/// A neighbour that is as cheap gains nothing.
void CoarseCostField::expand(const Waiting& from) {
  struct Neighbour {
    std::uint8_t side;
    std::uint32_t right;
    std::uint32_t up;
  };
  constexpr std::uint32_t kBack = -std::uint32_t{1};
  constexpr std::array<Neighbour, 4> kNeighbours{{{CoarseGrid::kRight, 1, 0},
                                                  {CoarseGrid::kLeft, kBack, 0},
                                                  {CoarseGrid::kAbove, 0, 1},
                                                  {CoarseGrid::kBelow, 0, kBack}}};
  const auto stride = static_cast<std::uint32_t>(grid_.stride());
  const std::uint32_t row = from.square / stride;
  const std::uint32_t column = from.square - row * stride;
  const std::uint8_t sides = grid_.sides(from.square);
  for (const Neighbour& next : kNeighbours) {
    const std::uint32_t square = from.square + next.right + next.up * stride;
    if ((sides & next.side) == 0 || !(values_[square] > from.value)) continue;
    improve(column + next.right, row + next.up, square, updated(square));
  }
}

CoarseCostField::Value CoarseCostField::at(Point point) const {
  const Around near = around(point);
  const std::array<double, 4> shares{(1 - near.x) * (1 - near.y), near.x * (1 - near.y),
                                     (1 - near.x) * near.y, near.x * near.y};
  double sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t square = near.squares[i];
    if (!grid_.open(square)) continue;
    if (known(square)) {
      sum += shares[i] * values_[square];
      total += shares[i];
    } else if (!exhausted()) {
      const double reached = first_key_ + static_cast<double>(queue_.least_key()) / per_width_;
      const double bound = reached - straight_distance(point, start_);
      return {std::max(0.0, bound - grid_.size()), false};
    }
  }
  return {total > 0 ? sum / total : kNoWay, true};
}

void CoarseCostField::settle(Point point) {
  constexpr std::size_t kBetweenLooks = 1024;
  for (const std::size_t square : around(point).squares) {
    if (!grid_.open(square)) continue;
    while (!known(square)) {
      if (!settle_next()) return;
      if (stop_ && settled_ % kBetweenLooks == 0 && stop_()) return;
    }
  }
}

Point CoarseCostField::descent(Point point) const {
  const Around near = around(point);
  std::array<double, 4> value{};
  bool all = true;
  for (std::size_t i = 0; i < 4; ++i) {
    all = all && known(near.squares[i]);
    value[i] = values_[near.squares[i]];
  }
  Point way{0, 0};
  if (all) {
    way = {(1 - near.y) * (value[0] - value[1]) + near.y * (value[2] - value[3]),
           (1 - near.x) * (value[0] - value[2]) + near.x * (value[1] - value[3])};
  } else {
    const auto least = std::ranges::min_element(value) - value.begin();
    const std::size_t square = near.squares[static_cast<std::size_t>(least)];
    if (known(square)) {
      const Point middle = grid_.middle(square);
      way = {middle.x - point.x, middle.y - point.y};
    }
  }
  const double length = std::sqrt(way.x * way.x + way.y * way.y);
  return length > 0 ? Point{way.x / length, way.y / length} : Point{0, 0};
}

}  // namespace wend
