#pragma once

// CurveWord: the words of curve.hpp for one pair of circles. A car that starts on a circle to its left, and ends
// on a circle to its left or right, drives from heading to heading: its words follow from the distance and the
// direction between the centres of these two circles alone. With a radius of 1, let the start be at the origin
// with heading 0, and
//
//   e(h) = (sin h, -cos h)   from the centre of a left circle to the car; from a right circle it is -e(h)
//   f(h) = (cos h, sin h)    ahead
//
// Then L+R- with the change at heading h leads to a centre at 2 e(h), and L+S+ with a line of length w at
// heading h leads to another left circle at w f(h), or to a right one at w f(h) + 2 e(h). A word is solved when
// these steps add up to the vector between the two circles. The functions below are the solutions; the words
// that start on a circle to the right are those of the mirror image.
//
// What they share (three arc tangents for each pair of circles, mostly) is computed once for all words.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/curve.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {

/// One piece of a word, for a car that starts on a left circle.
struct WordPiece {
  Turn turn = Turn::straight;
  bool ahead = true;
};

/// The letters of a word as a template argument: "L+R-S-L-".
template <std::size_t kSize>
struct WordLetters {
  std::array<char, kSize> letters{};
  // NOLINTNEXTLINE(google-explicit-constructor): CurveWord<"L+S+L+"> converts its argument
  consteval WordLetters(const char (&text)[kSize]) { std::copy_n(text, kSize, letters.begin()); }
};

/// The pieces that a word has.
struct WordShape {
  std::array<WordPiece, 5> pieces{};
  int count = 0;

  constexpr const WordPiece& first() const { return pieces[0]; }
  constexpr const WordPiece& last() const { return pieces[static_cast<std::size_t>(count) - 1]; }
  /// Does the gear change behind piece i?
  constexpr bool changes_after(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return pieces[at].ahead != pieces[at + 1].ahead;
  }
  constexpr int gear_changes() const {
    int changes = 0;
    for (int i = 0; i + 1 < count; ++i) changes += changes_after(i) ? 1 : 0;
    return changes;
  }
  /// The number of pieces between the first and the last that are lines, or arcs.
  constexpr int between(bool lines, bool ahead) const {
    int found = 0;
    for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(count); ++i) {
      if ((pieces[i].turn == Turn::straight) == lines && pieces[i].ahead == ahead) ++found;
    }
    return found;
  }
};

template <std::size_t kSize>
consteval WordShape shape_of(const WordLetters<kSize>& word) {
  WordShape shape;
  for (std::size_t i = 0; i + 2 < kSize; i += 2) {
    const char letter = word.letters[i];
    const Turn turn = letter == 'L' ? Turn::left : letter == 'R' ? Turn::right : Turn::straight;
    shape.pieces[static_cast<std::size_t>(shape.count++)] = {turn, word.letters[i + 1] == '+'};
  }
  return shape;
}

/// A word as a type: CurveWord<"L+R-L+">.
template <WordLetters kLetters>
struct CurveWord {
  static constexpr WordShape kShape = shape_of(kLetters);
};

/// Two circles of radius 1.
struct CirclePair {
  double squared = 0;   // square of the distance between the centres
  double distance = 0;  // between the centres
  double angle = 0;     // from the first centre to the second
};

/// What a word needs to be driven: where its first arc ends and where its last begins, and how long the pieces
/// between are. (All arcs between have the same length.)
struct WordHeadings {
  double first = 0;  // radians
  double last = 0;   // radians
  double arc = 0;    // radians, >= 0
  double line = 0;   // radii, >= 0
};

/// The arc cosine of a number in [0, 1] whose square is at hand.
inline double arc_cosine(double x) { return arc_tangent(std::sqrt(std::max(0.0, 1 - x * x)), x); }

/// Between two left circles: arc, line, arc. `take` is called with a word and its headings, here and below.
template <class Take>
void same_side_line_ahead(const CirclePair& pair, Take&& take) {
  take(CurveWord<"L+S+L+">(), WordHeadings{pair.angle, pair.angle, 0, pair.distance});
}

/// The same in both gears.
template <class Take>
void same_side_lines(const CirclePair& pair, Take&& take) {
  same_side_line_ahead(pair, take);
  const double back = pair.angle + kPi;
  take(CurveWord<"L-S-L-">(), WordHeadings{back, back, 0, pair.distance});
}

/// From a left circle to a right one: arc, line, arc. The line crosses the line of centres, at the angle `slant`.
template <class Take>
void other_side_line_ahead(const CirclePair& pair, double line, double slant, Take&& take) {
  const double ahead = pair.angle + slant;
  take(CurveWord<"L+S+R+">(), WordHeadings{ahead, ahead, 0, line});
}

/// The same in both gears.
template <class Take>
void other_side_lines(const CirclePair& pair, double line, double slant, Take&& take) {
  other_side_line_ahead(pair, line, slant, take);
  const double back = pair.angle + kPi - slant;
  take(CurveWord<"L-S-R-">(), WordHeadings{back, back, 0, line});
}

/// Three arcs: the middle circle is to the right of both, on one side of them or the other.
template <class Take>
void three_arcs(const CirclePair& pair, Take&& take) {
  const double lean = arc_cosine(pair.distance / 4);
  const double middle = kPi - 2 * lean;
  const double quarter = pair.angle + kPi / 2;
  const WordHeadings back{quarter + lean, quarter + kPi - lean, middle, 0};
  take(CurveWord<"L+R-L+">(), back);
  take(CurveWord<"L+R-L-">(), back);
  take(CurveWord<"L-R-L+">(), back);
  const WordHeadings ahead{quarter - lean, quarter - kPi + lean, middle, 0};
  take(CurveWord<"L-R+L-">(), ahead);
  take(CurveWord<"L-R+L+">(), ahead);
  take(CurveWord<"L+R+L-">(), ahead);
}

/// Dubins' three arcs: the middle one turns by more than half a turn.
template <class Take>
void three_arcs_ahead(const CirclePair& pair, Take&& take) {
  const double lean = arc_cosine(pair.distance / 4);
  const double quarter = pair.angle + kPi / 2;
  take(CurveWord<"L+R+L+">(),
       WordHeadings{quarter + lean, quarter - kPi - lean, kPi + 2 * lean, 0});
}

/// Between two left circles by a quarter circle to the right and a line, in either order.
template <class Take>
void same_side_quarters(const CirclePair& pair, double line, double slant, Take&& take) {
  const double theta = pair.angle;
  constexpr double kQuarter = kPi / 2;
  const double rest = std::max(0.0, line - 2);
  take(CurveWord<"L+R-S-L-">(),
       WordHeadings{theta + kQuarter + slant, theta + kPi + slant, kQuarter, rest});
  take(CurveWord<"L-R+S+L+">(),
       WordHeadings{theta + kQuarter - slant, theta - slant, kQuarter, rest});
  take(CurveWord<"L+S+R+L-">(),
       WordHeadings{theta + slant, theta + slant - kQuarter, kQuarter, rest});
  take(CurveWord<"L-S-R-L+">(),
       WordHeadings{theta + kPi - slant, theta + 3 * kQuarter - slant, kQuarter, rest});
}

/// From a left circle to a right one by a quarter circle and a line, in either order.
template <class Take>
void other_side_quarters(const CirclePair& pair, Take&& take) {
  const double theta = pair.angle;
  constexpr double kQuarter = kPi / 2;
  const double rest = std::max(0.0, pair.distance - 2);
  take(CurveWord<"L+R-S-R-">(), WordHeadings{theta + kQuarter, theta + kPi, kQuarter, rest});
  take(CurveWord<"L-R+S+R+">(), WordHeadings{theta + kQuarter, theta, kQuarter, rest});
  take(CurveWord<"L+S+L+R-">(), WordHeadings{theta, theta + kQuarter, kQuarter, rest});
  take(CurveWord<"L-S-L-R+">(), WordHeadings{theta + kPi, theta + kQuarter, kQuarter, rest});
}

/// Four arcs with one change of gear in the middle. The distance is at most 2.
template <class Take>
void four_arcs_near(const CirclePair& pair, Take&& take) {
  const double arc = arc_cosine((2 + pair.distance) / 4);
  const double middle = pair.angle + kPi / 2;
  take(CurveWord<"L+R+L-R-">(), WordHeadings{middle + arc, middle - arc, arc, 0});
  take(CurveWord<"L-R-L+R+">(), WordHeadings{middle - arc, middle + arc, arc, 0});
}

/// Four arcs, the two in the middle with the other gear. The square of the distance is in [4, 20].
template <class Take>
void four_arcs_far(const CirclePair& pair, Take&& take) {
  const double cosine = (20 - pair.squared) / 16;
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double arc = arc_tangent(sine, cosine);
  const double lean = arc_tangent(sine, 2 - cosine);
  const double back = pair.angle + kPi / 2 + lean;
  const double ahead = pair.angle + kPi / 2 - lean;
  take(CurveWord<"L+R-L-R+">(), WordHeadings{back, back, arc, 0});
  take(CurveWord<"L-R+L+R-">(), WordHeadings{ahead, ahead, arc, 0});
}

/// Five pieces: a line between two quarter circles. The line of other_side_lines() is at least 4 long.
template <class Take>
void five_pieces(const CirclePair& pair, double line, double slant, Take&& take) {
  const double rest = std::max(0.0, line - 4);
  const double back = pair.angle + kPi / 2 + slant;
  const double ahead = pair.angle + kPi / 2 - slant;
  take(CurveWord<"L+R-S-L-R+">(), WordHeadings{back, back, kPi / 2, rest});
  take(CurveWord<"L-R+S+L+R-">(), WordHeadings{ahead, ahead, kPi / 2, rest});
}

}  // namespace wend
