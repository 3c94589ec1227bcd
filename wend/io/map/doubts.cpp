#include "wend/io/map/doubts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kRounding = 1e-3;  // of a full turn that was written with few digits

// Of cells in metres, as robots use them.
constexpr double kLeastCell = 1e-3;
constexpr double kGreatestCell = 10;

/// Of black and white in a byte. An image that reaches only this share of its white has values of fewer bits.
constexpr int kGreys = 255;

std::optional<std::string> almost_black(const GreyRange& greys, ImageMode mode) {
  const bool dark = greys.brightest > 0 && greys.brightest <= greys.maximum / kGreys;
  if (!dark || (mode == ImageMode::raw && greys.maximum <= kGreys)) return std::nullopt;
  return fmt::format(
      "the brightest pixel is {} where white is {}, so the whole image is almost black; it was "
      "probably made from "
      "values of fewer bits",
      greys.brightest, greys.maximum);
}

std::string_view word_of(CellState state) { return state == CellState::free ? "free" : "occupied"; }

/// The occupancy of a grey value.
double occupancy(int value, int maximum, bool negate) {
  const double shade = static_cast<double>(value) / maximum;
  return negate ? shade : 1 - shade;
}

std::optional<std::string> known_unknown(const ImageMapRows& rows, const ImageMeaning& meaning) {
  const GreyRange& greys = rows.greys();
  if (greys.saved_unknown == 0 || meaning.mode != ImageMode::trinary) return std::nullopt;
  const CellState state = rows.state_of(kSavedUnknown * (greys.maximum / kGreys));
  if (state == CellState::unknown) return std::nullopt;
  const double p = occupancy(kSavedUnknown, kGreys, meaning.negate);
  const std::string why =
      state == CellState::free
          ? fmt::format("free_thresh {} is not below its occupancy of {:.4f}",
                        format_number(meaning.free_threshold), p)
          : fmt::format("occupied_thresh {} is not above its occupancy of {:.4f}{}",
                        format_number(meaning.occupied_threshold), p,
                        meaning.negate ? " with negate: 1" : "");
  return fmt::format("grey {}, which map savers write for unknown, counts as {} here ({} {}): {}",
                     kSavedUnknown, word_of(state), greys.saved_unknown,
                     greys.saved_unknown == 1 ? "cell" : "cells", why);
}

/// One state that no cell has, although the image has more than one grey.
std::optional<std::string> missing_state(const GreyRange& greys, const ImageMeaning& meaning,
                                         const GridMap& map) {
  if (meaning.mode != ImageMode::trinary || greys.darkest >= greys.brightest) return std::nullopt;
  const double dark = occupancy(greys.darkest, greys.maximum, meaning.negate);
  const double bright = occupancy(greys.brightest, greys.maximum, meaning.negate);
  const std::size_t occupied = map.occupied().count();
  const std::string range = fmt::format("the occupancies of its pixels are {:.4f} to {:.4f}",
                                        std::min(dark, bright), std::max(dark, bright));
  if (occupied + map.unknown().count() == map.size()) {
    return fmt::format("no cell is free: {}, and free ones are up to free_thresh {}{}", range,
                       format_number(meaning.free_threshold),
                       meaning.negate ? " (negate: 1 makes white occupied)" : "");
  }
  if (occupied > 0) return std::nullopt;
  return fmt::format("no cell is occupied: {}, and occupied ones begin at occupied_thresh {}",
                     range, format_number(meaning.occupied_threshold));
}

}  // namespace

std::vector<std::string> doubts_about(const Frame& frame) {
  std::vector<std::string> doubts;
  const double yaw = frame.origin.heading;
  if (std::abs(yaw) > kFullTurn + kRounding) {
    doubts.push_back(fmt::format(
        "the yaw of the origin is read in radians: {} is more than a full turn; {} degrees are "
        "{:.4f} radians",
        format_number(yaw), format_number(yaw), std::remainder(yaw, 360.0) * kFullTurn / 360));
  }
  if (frame.resolution < kLeastCell || frame.resolution > kGreatestCell) {
    doubts.push_back(
        fmt::format("the resolution is read in metres a cell: {} is unusual for a robot",
                    format_number(frame.resolution)));
  }
  return doubts;
}

std::vector<std::string> doubts_about(const ImageMapRows& rows, const ImageMeaning& meaning,
                                      const GridMap& map) {
  std::vector<std::string> doubts;
  const auto black = almost_black(rows.greys(), meaning.mode);
  const auto grey = known_unknown(rows, meaning);
  const auto missing = missing_state(rows.greys(), meaning, map);
  if (black) doubts.push_back(*black);
  if (grey) doubts.push_back(*grey);
  // An image that is almost black has given its reason.
  if (missing && !black) doubts.push_back(*missing);
  return doubts;
}

}  // namespace wend
