#pragma once

// Masks from files, to be laid over a map by masked(): keep-out zones and speed limits, as Nav2 has them.
//
//   keepout   a map file of any format. Occupied cells are zones that block the robot; costs of free cells
//             multiply those of the map: in a map.yaml with `mode: scale` or `raw`, 1 + 4 v / 100
//   speed     a map.yaml with `mode: scale` or `raw`. The value v of 1 to 100 limits the speed to that many
//             percent of the top speed, and the cost of a cell is the time that it takes: 100 / v. 0 and
//             unknown: no limit
//   oneway    an image, bare or of a map.yaml, whose colours are headings (wend/map/direction_map.hpp): the hue of a
//             pixel of a PNG is the angle on the page, counter-clockwise: red leads right, yellow-green (90 degrees) up,
//             cyan left, violet (270 degrees) down. Greys and transparent pixels have no arrow. In an image without
//             colours (PNG or PGM), a grey v of 1 to 240, of 255, leads to 1.5 (v - 1) degrees; others have no arrow
//   height    an image, bare or of a map.yaml, whose greys are heights: slopes cost. Of a 16-bit image, a 257th of a
//             grey counts, too. Transparent pixels are unknown: flat
//
//   const auto mask = wend::load_mask("zones.yaml");
//   if (!mask) return report(mask.error().message);
//   const auto map = wend::masked(office, mask->map);

#include <filesystem>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/map/direction_map.hpp"
#include "wend/map/occupancy.hpp"

namespace wend {

/// What a mask says about cells.
enum class MaskKind {
  keepout,  // where the robot must not be
  speed,    // how fast it may drive
  oneway,   // where it may drive to
  height    // what slopes cost
};

/// How to read a mask.
struct MaskReading {
  MaskKind kind = MaskKind::keepout;  // of the mask
  SpeedScale speed = {};              // what the values of a speed mask mean
  ArrowOptions arrow = {};            // how strict the arrows of a one-way mask are
  SlopeOptions slope = {};            // what the slopes of a height mask cost
  double height_step = 0.1;           // height of a grey value, of 255, in the map's unit of length
};

/// A mask as a map of its own. Fails with invalid_file as load_map() does, and if a speed mask is in a format or
/// mode that has no values in between; with invalid_option if the scale is invalid.
WEND_API Expected<LoadedMap, Error> load_mask(const std::filesystem::path& file,
                                              const MaskReading& reading = {});

/// A mask as people write it.
struct MaskSpec {
  std::filesystem::path file;  // not empty
  MaskReading reading;         // how to read it
};

/// Reads "FILE", "keepout:FILE", "speed:FILE", "oneway:FILE" or "height:FILE". Options stand before the file, or of the
/// last two also behind it, as in "speed:base=100:multiplier=-1:FILE", "speed:top_speed=1.5:FILE",
/// "oneway:tolerance=45:factor=5:FILE" (degrees, and the factor against an arrow) or
/// "height:FILE:climb=20:descend=5:step=0.1". Fails with invalid_option; the file is not opened.
WEND_API Expected<MaskSpec, Error> parse_mask_spec(std::string_view text);

}  // namespace wend
