#include "bench/suites/se2/exhaustive_drive.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <vector>

#include "conformance/placed_shape.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/curve.hpp"

namespace wend::bench {
namespace {

constexpr double kSpacing = 0.5;  // cells between poses
constexpr int kHeadingCount = 72;
constexpr double kLength = 1;  // cells, of a motion
constexpr double kStep = 0.1;  // cells, between two places of the shape
constexpr double kDepth = 1e-6;

class ExhaustiveSearch {
 public:
  ExhaustiveSearch(const FreeSpace& space, double radius)
      : space_(space),
        radius_(radius),
        shape_(space, kDepth),
        columns_(static_cast<std::size_t>(std::ceil(space.width() / kSpacing))),
        seen_(columns_ * static_cast<std::size_t>(std::ceil(space.height() / kSpacing)) *
              kHeadingCount) {}

  ExhaustiveAnswer run(const Pose& start, const Pose& goal) {
    ExhaustiveAnswer answer;
    open_.push_back(start);
    while (!open_.empty() && !answer.found) {
      const Pose pose = open_.front();
      open_.pop_front();
      ++answer.states;
      answer.found = reaches(pose, goal);
      for (const double length : {kLength, -kLength}) {
        for (const Turn turn : {Turn::right, Turn::straight, Turn::left}) {
          go(pose, {length, turn});
        }
      }
    }
    return answer;
  }

 private:
  bool is_free(const CurvePiece& piece, const Pose& from) {
    const int steps = static_cast<int>(std::ceil(std::abs(piece.length) / kStep));
    for (int i = 1; i <= steps; ++i) {
      const CurvePiece part{piece.length * i / steps, piece.turn};
      if (shape_.overlapped_at(end_of(part, from, radius_))) return false;
    }
    return true;
  }

  /// Is one of the shortest curves to the goal free?
  bool reaches(const Pose& from, const Pose& goal) {
    const double away = distance(from.point(), goal.point());
    if (away > 3 * radius_) return false;
    std::array<Curve, 6> words;
    const int count = reeds_shepp_words(from, goal, radius_, {}, 6 * radius_ + away, words);
    for (int i = 0; i < count; ++i) {
      Pose pose = from;
      bool free = true;
      for (const CurvePiece& piece : words[static_cast<std::size_t>(i)].driven()) {
        free = free && is_free(piece, pose);
        pose = end_of(piece, pose, radius_);
      }
      if (free) return true;
    }
    return false;
  }

  void go(const Pose& from, const CurvePiece& piece) {
    const Pose to = end_of(piece, from, radius_);
    if (!(to.x >= 0 && to.y >= 0 && to.x < space_.width() && to.y < space_.height())) return;
    const std::size_t number = number_of(to);
    if (seen_[number] || !is_free(piece, from)) return;
    seen_[number] = true;
    open_.push_back(to);
  }

  std::size_t number_of(const Pose& pose) const {
    const double turns = pose.heading / (2 * kPi);
    const auto heading = static_cast<std::size_t>((turns - std::floor(turns)) * kHeadingCount);
    const auto x = static_cast<std::size_t>(pose.x / kSpacing);
    const auto y = static_cast<std::size_t>(pose.y / kSpacing);
    return (y * columns_ + x) * kHeadingCount + heading % kHeadingCount;
  }

  const FreeSpace& space_;
  double radius_;
  test::PlacedShape shape_;
  std::size_t columns_;
  std::vector<bool> seen_;
  std::deque<Pose> open_;
};

}  // namespace

ExhaustiveAnswer exhaustive_drive(const FreeSpace& space, const Query& query, double radius) {
  const Goal& goal = query.goals.front();
  return ExhaustiveSearch(space, radius)
      .run(query.start, {goal.point.x, goal.point.y, goal.heading.value_or(0)});
}

}  // namespace wend::bench
