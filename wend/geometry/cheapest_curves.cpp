#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "wend/geometry/cheapest_words.hpp"
#include "wend/geometry/curve.hpp"
#include "wend/geometry/curve_words.hpp"

namespace wend {
namespace {

// Circles that touch, or are exactly so far from each other as a word needs, differ from that by rounding.
constexpr double kRounding = 4e-10;  // of the square of a distance

CirclePair pair_of(double x, double y) {
  const double squared = x * x + y * y;
  return {squared, std::sqrt(squared), arc_tangent(y, x)};
}

/// The vectors from the left circle at the start to the circles at the goal.
CirclePair to_left_circle(const RelativePose& goal) {
  return pair_of(goal.x - goal.direction.sine, goal.y - 1 + goal.direction.cosine);
}
CirclePair to_right_circle(const RelativePose& goal) {
  return pair_of(goal.x + goal.direction.sine, goal.y - 1 - goal.direction.cosine);
}

/// The line from a left circle to a right one. It crosses the line of centres, which is at least 2 long.
struct CrossingLine {
  double length;
  double slant;  // the angle between the two lines
};

CrossingLine crossing_line(const CirclePair& pair) {
  const double length = std::sqrt(std::max(0.0, pair.squared - 4));
  return {length, arc_tangent(2, length)};
}

struct ReedsShepp {
  template <class Words>
  static void same_side(const CirclePair& pair, Words& words) {
    same_side_lines(pair, words);
    if (pair.squared <= 16 + kRounding) three_arcs(pair, words);
    if (pair.squared < 8 - kRounding) return;
    const CrossingLine line = crossing_line(pair);
    same_side_quarters(pair, line.length, line.slant, words);
  }

  template <class Words>
  static void other_side(const CirclePair& pair, Words& words) {
    if (pair.squared <= 4 + kRounding) four_arcs_near(pair, words);
    if (pair.squared < 4 - kRounding) return;
    const CrossingLine line = crossing_line(pair);
    other_side_lines(pair, line.length, line.slant, words);
    other_side_quarters(pair, words);
    if (pair.squared <= 20 + kRounding) four_arcs_far(pair, words);
    if (pair.squared >= 20 - kRounding) five_pieces(pair, line.length, line.slant, words);
  }
};

struct Simple {
  template <class Words>
  static void same_side(const CirclePair& pair, Words& words) {
    same_side_lines(pair, words);
  }

  template <class Words>
  static void other_side(const CirclePair& pair, Words& words) {
    if (pair.squared < 4 - kRounding) return;
    const CrossingLine line = crossing_line(pair);
    other_side_lines(pair, line.length, line.slant, words);
  }
};

struct Dubins {
  template <class Words>
  static void same_side(const CirclePair& pair, Words& words) {
    same_side_line_ahead(pair, words);
    if (pair.squared <= 16 + kRounding) three_arcs_ahead(pair, words);
  }

  template <class Words>
  static void other_side(const CirclePair& pair, Words& words) {
    if (pair.squared < 4 - kRounding) return;
    const CrossingLine line = crossing_line(pair);
    other_side_line_ahead(pair, line.length, line.slant, words);
  }
};

/// A lower bound of what any curve costs.
double least_cost(const Pose& from, const Pose& to, const CurveCosts& costs) {
  const double factor = std::min(1.0, costs.reverse) * std::min(1.0, costs.turn);
  constexpr double kSlightlyLess = 1 - 1e-9;
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  return std::sqrt(dx * dx + dy * dy) * factor * kSlightlyLess;
}

template <class Family, std::size_t kMost>
CheapestWords<kMost> solved(const Pose& from, const Pose& to, double radius,
                            const CurveCosts& costs, double bound, std::size_t most = kMost) {
  CheapestWords<kMost> words(radius, costs, bound, most);
  if (most == 0 || least_cost(from, to, costs) >= bound) return words;
  RelativePose goal = relative_pose(from, to, radius);
  for (const bool mirrored : {false, true}) {
    if (mirrored) goal = goal.mirrored();
    const CirclePair same = to_left_circle(goal);
    words.start(goal.heading, same, mirrored);
    Family::same_side(same, words);
    const CirclePair other = to_right_circle(goal);
    words.start(goal.heading, other, mirrored);
    Family::other_side(other, words);
  }
  return words;
}

template <class Family>
Curve cheapest(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
               double bound) {
  const auto words = solved<Family, 1>(from, to, radius, costs, bound);
  if (words.found().empty()) return {};
  const Curve curve = curve_of(words.found().front(), radius, costs);
  return curve.cost < bound ? curve : Curve{};
}

template <class Family, std::size_t kWords>
int cheapest_few(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                 double bound, std::span<Curve> out) {
  const auto words = solved<Family, kWords>(from, to, radius, costs, bound, out.size());
  std::size_t count = 0;
  for (const SolvedWord& word : words.found()) {
    // Without its pieces of length 0, a curve may cost less than its word.
    const Curve curve = curve_of(word, radius, costs);
    if (!(curve.cost < bound)) continue;
    std::size_t at = count++;
    for (; at > 0 && curve.cost < out[at - 1].cost; --at) out[at] = out[at - 1];
    out[at] = curve;
  }
  return static_cast<int>(count);
}

}  // namespace

Curve cheapest_reeds_shepp(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                           double bound) {
  return cheapest<ReedsShepp>(from, to, radius, costs, bound);
}

int reeds_shepp_words(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                      double bound, std::span<Curve> out) {
  return cheapest_few<ReedsShepp, 48>(from, to, radius, costs, bound, out);
}

Curve cheapest_dubins(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                      double bound) {
  return cheapest<Dubins>(from, to, radius, costs, bound);
}

int dubins_words(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                 double bound, std::span<Curve> out) {
  return cheapest_few<Dubins, 6>(from, to, radius, costs, bound, out);
}

int simple_words(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                 double bound, std::span<Curve> out) {
  return cheapest_few<Simple, 8>(from, to, radius, costs, bound, out);
}

}  // namespace wend
