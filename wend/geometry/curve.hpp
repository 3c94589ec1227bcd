#pragma once

// Curve: a drive between two poses with a least turning radius: arcs of that radius and lines, ahead or in
// reverse. Its pieces are named as in the papers: L+ is an arc to the left driven ahead, S- a line driven in
// reverse. One sequence of such pieces is a word.
//
//   const wend::Pose from{2, 2, 0};
//   const wend::Pose aside{2, 5, 0};
//   const wend::CurveCosts costs{.reverse = 2, .gear_change = 0.5};
//   const wend::Curve parking = wend::cheapest_reeds_shepp(from, aside, 1, costs);
//   const wend::Curve ahead = wend::cheapest_dubins(from, aside, 1);
//   std::vector<wend::Pose> poses{from};
//   wend::append_poses(parking, from, 1, poses);
//
// - A car that only drives ahead: L+S+L+, R+S+R+, L+S+R+, R+S+L+, L+R+L+, R+L+R+. The shortest of these is the
//   shortest curve: L. E. Dubins, "On curves of minimal length with a constraint on average curvature", 1957.
// - A car that also reverses: 48 words in nine families, of at most five pieces. The shortest of these is the
//   shortest curve: J. A. Reeds, L. A. Shepp, "Optimal paths for a car that goes both forwards and backwards",
//   1990.
//
// Here words are compared by their cost: CurveCosts weighs lengths in reverse, arcs, and changes of gear. The
// cheapest word is not always the cheapest of all curves, unless the costs are lengths. An arc at the end of a
// word may turn by more than half a turn, which the shortest word never does but the cheapest may, where
// driving in reverse is expensive.
//
// O(1), without memory from the heap; the same bits on every platform. Poses are in grid coordinates, the
// radius in cells. (Poses in metres with a radius in metres work as well: nothing here depends on the unit.)
// Coordinates, headings and costs are finite, the radius is greater than 0. Errors grow with the coordinates:
// ends are exact up to about 1e-10 radii where coordinates are below 1e5 radii.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// What a curve costs: the sum over its pieces of length x `reverse` (if driven in reverse) x `turn` (if an arc),
/// and `gear_change` wherever one piece is driven ahead and the next in reverse, or the other way round. With
/// the defaults the cost is the length. None is negative.
struct CurveCosts {
  double reverse = 1;      // factor on lengths driven in reverse
  double turn = 1;         // factor on lengths of arcs
  double gear_change = 0;  // in the unit of the poses
};

/// To which side a piece turns when it is driven ahead. In reverse on a left arc, the heading falls.
enum class Turn : std::int8_t {
  right = -1,    // an arc around a centre to the right of the car
  straight = 0,  // a line
  left = 1       // an arc around a centre to the left of the car
};

/// An arc of the turning radius, or a line.
struct CurvePiece {
  double length = 0;           // in the unit of the poses; negative in reverse
  Turn turn = Turn::straight;  // to which side

  friend bool operator==(const CurvePiece&, const CurvePiece&) = default;
};

/// The pieces of a drive. A curve that does not exist has the cost infinity and no pieces; the one between equal
/// poses has the cost 0 and no pieces.
struct WEND_API Curve {
  std::array<CurvePiece, 5> pieces{};                     // the first `count`; none is of length 0
  int count = 0;                                          // number of pieces
  double cost = std::numeric_limits<double>::infinity();  // as CurveCosts says

  /// Is it a drive, and not the answer that there is none?
  bool exists() const { return cost < std::numeric_limits<double>::infinity(); }
  /// The pieces.
  std::span<const CurvePiece> driven() const {
    return std::span(pieces).first(static_cast<std::size_t>(count));
  }
  /// The sum of the absolute lengths.
  double length() const;
  /// How often the car changes its gear.
  int gear_changes() const;

  friend bool operator==(const Curve&, const Curve&) = default;
};

/// The sum that CurveCosts describes; 0 for no pieces. Curves that the functions below return have it as their
/// `cost`.
WEND_API double cost_of(std::span<const CurvePiece> pieces, const CurveCosts& costs);

/// No bound: every word counts.
inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// The cheapest Reeds-Shepp word that costs less than `bound`; a curve that does not exist if there is none.
/// About 0.3 us; a few nanoseconds if even a line from one pose to the other would cost that much.
WEND_API Curve cheapest_reeds_shepp(const Pose& from, const Pose& to, double radius,
                                    const CurveCosts& costs = {}, double bound = kNoBound);

/// Writes the cheapest Reeds-Shepp words below `bound` to `out`, the cheapest first, at most out.size() of them.
/// Returns how many. Between most poses fewer than 48 exist. Of two equal curves (words that differ in pieces of
/// length 0) both may be listed.
WEND_API int reeds_shepp_words(const Pose& from, const Pose& to, double radius,
                               const CurveCosts& costs, double bound, std::span<Curve> out);

/// The cheapest Dubins word that costs less than `bound`; `costs.reverse` and `costs.gear_change` do not matter.
WEND_API Curve cheapest_dubins(const Pose& from, const Pose& to, double radius,
                               const CurveCosts& costs = {}, double bound = kNoBound);

/// The same as reeds_shepp_words() for the six Dubins words.
WEND_API int dubins_words(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                          double bound, std::span<Curve> out);

/// The same for the words arc, line, arc with one gear, of which four drive ahead and four in reverse. Between
/// poses far from each other these are the only ones that matter, and they take less time.
WEND_API int simple_words(const Pose& from, const Pose& to, double radius, const CurveCosts& costs,
                          double bound, std::span<Curve> out);

/// The pose after driving a piece; its heading is not normalised.
WEND_API Pose end_of(const CurvePiece& piece, const Pose& from, double radius);

/// The pose after driving a curve; its heading is in (-pi, pi].
WEND_API Pose end_of(const Curve& curve, const Pose& from, double radius);

/// Appends the arcs and lines of a curve. Arcs that turn by more than a quarter turn are divided into equal
/// parts. Headings are in (-pi, pi].
WEND_API void append_arcs(const Curve& curve, const Pose& from, double radius,
                          std::vector<Arc>& arcs);

/// Appends the poses at the ends of these arcs: what Path::drive_to() takes behind `from`. segment_between() gives
/// the arcs back.
WEND_API void append_poses(const Curve& curve, const Pose& from, double radius,
                           std::vector<Pose>& poses);

}  // namespace wend
