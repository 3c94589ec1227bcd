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

/// The upwind solution for a square of cost `cost` between its cheaper neighbours along both axes.
float upwind(float a, float b, float cost) {
  const float low = std::min(a, b);
  const float gap = std::max(a, b) - low;
  if (!(gap < cost)) return low + cost;
  return (a + b + std::sqrt(2 * cost * cost - gap * gap)) / 2;
}

}  // namespace

CoarseCostField::CoarseCostField(const CoarseGrid& grid)
    : grid_(grid),
      values_(grid.count(), kUnknown),
      settled_flags_(grid.count(), 0),
      per_width_(1 / (kBucketWidth * static_cast<float>(grid.size()))),
      size_(static_cast<float>(grid.size())) {}

void CoarseCostField::begin(std::span<const Seed> goals, Point start, std::function<bool()> stop) {
  stop_ = std::move(stop);
  for (const std::uint32_t square : touched_) {
    values_[square] = kUnknown;
    settled_flags_[square] = 0;
  }
  touched_.clear();
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
      improve(x, y, square, static_cast<float>(goal.cost(middle) * grid_.multiplier(square)));
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

float CoarseCostField::key(int column, int row, float value) const {
  const float dx = (static_cast<float>(column) + 0.5F) * size_ - static_cast<float>(start_.x);
  const float dy = (static_cast<float>(row) + 0.5F) * size_ - static_cast<float>(start_.y);
  return value + std::sqrt(dx * dx + dy * dy);
}

void CoarseCostField::improve(int column, int row, std::size_t square, float value) {
  if (!(value < values_[square] * kWorthwhile)) return;
  if (values_[square] == kUnknown) touched_.push_back(static_cast<std::uint32_t>(square));
  values_[square] = value;
  const float ahead = std::max(0.0F, (key(column, row, value) - first_key_) * per_width_);
  const auto bucket = static_cast<std::uint64_t>(std::min(ahead, 1e15F));
  queue_.push(std::max(bucket, queue_.least_key()),
              {static_cast<std::uint32_t>(square), column, row, value});
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

/// A neighbour that is as cheap gains nothing.
void CoarseCostField::expand(const Waiting& from) {
  const std::size_t up = grid_.stride();
  const std::size_t square = from.square;
  const std::uint8_t sides = grid_.sides(square);
  const auto spread = [&](std::uint8_t side, int column, int row, std::size_t neighbour) {
    if ((sides & side) != 0 && values_[neighbour] > from.value) update(column, row, neighbour);
  };
  spread(CoarseGrid::kRight, from.column + 1, from.row, square + 1);
  spread(CoarseGrid::kLeft, from.column - 1, from.row, square - 1);
  spread(CoarseGrid::kAbove, from.column, from.row + 1, square + up);
  spread(CoarseGrid::kBelow, from.column, from.row - 1, square - up);
}

void CoarseCostField::update(int column, int row, std::size_t square) {
  const std::size_t up = grid_.stride();
  const std::uint8_t sides = grid_.sides(square);
  const auto value = [&](std::uint8_t side, std::size_t neighbour) {
    return (sides & side) != 0 ? values_[neighbour] : kUnknown;
  };
  const float along =
      std::min(value(CoarseGrid::kRight, square + 1), value(CoarseGrid::kLeft, square - 1));
  const float across =
      std::min(value(CoarseGrid::kAbove, square + up), value(CoarseGrid::kBelow, square - up));
  improve(column, row, square, upwind(along, across, grid_.multiplier(square) * size_));
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
