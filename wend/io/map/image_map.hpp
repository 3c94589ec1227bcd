#pragma once

// Converts grey values to a map and back like ROS map servers; where ROS 1 and Nav2 differ, like Nav2.
//
// A pixel's occupancy p is 1 for black and 0 for white, or the other way round with `negate`.
//
//   mode      p <= free threshold   p >= occupied threshold   between the two
//   trinary   free                  occupied                  unknown
//   scale     free                  occupied                  free, v = 1..100 by p, rounded
//
//   raw: the grey value itself (0..255) is v: 100 is occupied, above it unknown, below it free.
//   Thresholds, negate and alpha do not matter.
//
// A free cell with the value v has the terrain multiplier 1 + scale_factor v / 100. In trinary and
// scale mode a pixel that is not fully opaque is unknown.

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/frame.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/map/byte_bits.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

enum class ImageMode { trinary, scale, raw };

/// The defaults are those of bare images and of most map savers.
struct ImageMeaning {
  ImageMode mode = ImageMode::trinary;
  bool negate = false;
  double occupied_threshold = 0.65;  // in 0..1
  double free_threshold = 0.196;     // in 0..1, below the occupied one
  double scale_factor = 4;           // in 0..1e6
};

/// The cost of a unit of length in a cell with the value v, 0..100.
inline double scaled_terrain(double scale_factor, int v) { return 1 + scale_factor * v / 100; }

/// The grey that map savers write for unknown cells, of 255.
inline constexpr int kSavedUnknown = 205;

/// The grey values of an image.
struct GreyRange {
  int maximum = 255;              // the value of white
  int darkest = 65535;            // the least value in it
  int brightest = 0;              // the greatest value in it
  std::size_t saved_unknown = 0;  // pixels of the grey kSavedUnknown
};

/// Makes the map of an image that is decoded row by row.
class ImageMapRows final : public ImageRows {
 public:
  explicit ImageMapRows(const ImageMeaning& meaning) : meaning_(meaning) {}

  void begin(int width, int height, int maximum) override;
  void add(std::span<const std::uint16_t> values,
           std::span<const unsigned char> transparent) override;
  bool add_bytes(std::span<const unsigned char> values) override;

  /// The state of a cell of this grey value. To be called after begin().
  CellState state_of(int value) const { return state_table_[static_cast<std::size_t>(value)]; }

  /// Of the rows so far.
  const GreyRange& greys() const { return greys_; }

  /// To be called after the last row. In a frame with y up, row 0 is the image's bottom row.
  Expected<GridMap, Error> finish(const Frame& frame) {
    assert(rows_);
    return std::move(*rows_).finish(frame);
  }

 private:
  struct PixelMeaning {
    CellState state = CellState::unknown;
    double terrain = 1;
  };

  /// Values from a first one to a last one; none at first.
  struct ByteRange {
    unsigned char first = 1;
    unsigned char last = 0;

    Answers holds(Bytes values) const { return (values >= first) & (values <= last); }
  };

  ByteRange bytes_of(CellState state) const;
  static PixelMeaning raw_meaning(double shade, double scale_factor);
  PixelMeaning meaning_of(int value, int maximum) const;
  void look_at(std::span<const std::uint16_t> values);
  /// The grey kSavedUnknown on the scale of the image; one that it cannot have if it lies between two values.
  int saved_unknown() const {
    constexpr int kNone = 65536;
    return greys_.maximum % 255 == 0 ? kSavedUnknown * (greys_.maximum / 255) : kNone;
  }

  ImageMeaning meaning_;
  GreyRange greys_;
  std::vector<PixelMeaning> table_;     // by value
  std::vector<CellState> state_table_;  // the same states, closer together
  ByteRange occupied_bytes_;            // of an image of bytes
  ByteRange unknown_bytes_;
  std::optional<GridMapBuilder> rows_;
  std::vector<CellState> states_;  // of the current row
  std::vector<double> terrain_;
};

/// The image that map savers write, in the orientation of the drawn map: 0 occupied, 254 free, 205
/// unknown. It reads back with the defaults of ImageMeaning. Terrain is left out.
GreyImage trinary_image(const GridMap& map);

/// The ImageMeaning of images from scale_image().
inline constexpr ImageMeaning kScaleMeaning = {ImageMode::scale, false, 1, 0, 4};

/// The nearest terrain value that kScaleMeaning can hold: scaled_terrain(4, 0..100).
double nearest_scaled_terrain(double terrain);

/// An image that reads back with kScaleMeaning: 0 is occupied, transparent is unknown, and 255 to 1 are
/// the nearest_scaled_terrain().
GreyImage scale_image(const GridMap& map);

}  // namespace wend
