#pragma once

// CheapestWords: takes words (curve_words.hpp), and keeps the cheapest ones below a bound.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "wend/geometry/curve_words.hpp"

namespace wend {

/// A word with its lengths. Radius 1.
struct SolvedWord {
  double cost = 0;
  double first = 0;  // arc, >= 0, as all lengths here
  double last = 0;
  double arc = 0;
  double line = 0;
  const WordShape* shape = nullptr;
  bool mirrored = false;
};

/// The goal of a car at the origin with heading 0 and a turning radius of 1.
struct RelativePose {
  double x = 0;
  double y = 0;
  double heading = 0;  // in [0, 2 pi], up to rounding
  SineCosine direction{};

  RelativePose mirrored() const {
    return {x, -y, 2 * kPi - heading, {-direction.sine, direction.cosine}};
  }
};

/// Where `to` lies as seen from `from`.
RelativePose relative_pose(const Pose& from, const Pose& to, double radius);

/// An angle in [0, 2 pi], up to rounding. For angles below 1e6.
inline double whole_turns_removed(double angle) {
  constexpr double kRounding = 6755399441055744.0;  // as in sine_and_cosine()
  const double turns = ((angle * (0.5 / kPi) - 0.5) + kRounding) - kRounding;
  return angle - turns * (2 * kPi);
}

/// A word as a curve of a radius, without the pieces of length 0.
Curve curve_of(const SolvedWord& word, double radius, const CurveCosts& costs);

/// Keeps up to kMost of the cheapest words, sorted.
template <std::size_t kMost>
class CheapestWords {
 public:
  CheapestWords(double radius, const CurveCosts& costs, double bound, std::size_t most = kMost)
      : ahead_{radius, radius * costs.turn},
        reverse_{radius * costs.reverse, radius * costs.reverse * costs.turn},
        gear_change_(costs.gear_change),
        bound_(bound),
        most_(std::min(most, kMost)) {}

  /// The words that follow are between these circles.
  void start(double heading, const CirclePair& pair, bool mirrored) {
    heading_ = heading;
    mirrored_ = mirrored;
    // A rotation by so much moves the end by 1e-10, more than rounding errors of coordinates do. An arc that
    // is shorter is none: rounding decides whether it is there, or nearly a full turn.
    const double rounding = 1e-10 / std::max(pair.distance, 1e-20) + 1e-14;
    limit_ = kPi - rounding;
  }

  /// What a word has to beat.
  double bound() const { return bound_; }

  template <WordLetters kLetters>
  void operator()(CurveWord<kLetters>, const WordHeadings& headings) {
    constexpr const WordShape& kShape = CurveWord<kLetters>::kShape;
    constexpr double kFirst = grows(kShape.first()) ? 1 : -1;
    constexpr double kLast = grows(kShape.last()) ? 1 : -1;
    SolvedWord word{0,
                    whole_turns_removed(kFirst * headings.first),
                    whole_turns_removed(kLast * (heading_ - headings.last)),
                    headings.arc,
                    headings.line,
                    &kShape,
                    mirrored_};
    int changes = kShape.gear_changes();
    if (std::max(std::abs(word.first - kPi), std::abs(word.last - kPi)) > limit_) [[unlikely]] {
      snap(headings, kFirst, kLast, word);
      if (word.first == 0 && kShape.changes_after(0)) --changes;
      if (word.last == 0 && kShape.changes_after(kShape.count - 2)) --changes;
    }
    word.cost = word.first * of(kShape.first()).arc + word.last * of(kShape.last()).arc +
                changes * gear_change_;
    if constexpr (kShape.between(false, true) > 0) {
      word.cost += word.arc * (kShape.between(false, true) * ahead_.arc);
    }
    if constexpr (kShape.between(false, false) > 0) {
      word.cost += word.arc * (kShape.between(false, false) * reverse_.arc);
    }
    if constexpr (kShape.between(true, true) > 0) word.cost += word.line * ahead_.line;
    if constexpr (kShape.between(true, false) > 0) word.cost += word.line * reverse_.line;
    if (word.cost < bound_) keep(word);
  }

  std::span<const SolvedWord> found() const { return std::span(words_).first(count_); }

 private:
  struct Rates {
    double line;
    double arc;
  };

  /// Does the heading grow along this arc?
  static constexpr bool grows(const WordPiece& piece) {
    return (piece.turn == Turn::left) == piece.ahead;
  }

  const Rates& of(const WordPiece& piece) const { return piece.ahead ? ahead_ : reverse_; }

  /// Rotates a word so that its first or last arc has the length 0.
  void snap(const WordHeadings& headings, double first_sign, double last_sign,
            SolvedWord& word) const {
    const auto is_none = [](double arc, double limit) { return std::abs(arc - kPi) > limit; };
    constexpr double kExact = kPi - 1e-11;  // the sum of both arcs does not depend on the centres
    if (is_none(word.first, limit_)) {
      word.first = 0;
      word.last = whole_turns_removed(last_sign * (heading_ - (headings.last - headings.first)));
      if (is_none(word.last, kExact)) word.last = 0;
    } else {
      word.last = 0;
      word.first = whole_turns_removed(first_sign * (headings.first + heading_ - headings.last));
      if (is_none(word.first, kExact)) word.first = 0;
    }
  }

  void keep(const SolvedWord& word) {
    if constexpr (kMost == 1) {
      words_[0] = word;
      count_ = 1;
      bound_ = word.cost;
    } else {
      if (most_ == 0) return;
      if (count_ == most_) --count_;
      const auto end = words_.begin() + static_cast<std::ptrdiff_t>(count_);
      const auto at = std::upper_bound(
          words_.begin(), end, word,
          [](const SolvedWord& a, const SolvedWord& b) { return a.cost < b.cost; });
      std::move_backward(at, end, end + 1);
      *at = word;
      if (++count_ == most_) bound_ = words_[count_ - 1].cost;
    }
  }

  Rates ahead_;
  Rates reverse_;
  double gear_change_;
  double bound_;
  std::size_t most_;
  double heading_ = 0;
  double limit_ = 0;
  bool mirrored_ = false;
  std::size_t count_ = 0;
  std::array<SolvedWord, kMost> words_;  // the first `count_`
};

}  // namespace wend
