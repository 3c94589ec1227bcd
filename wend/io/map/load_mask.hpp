#pragma once

// Masks from files, to be laid over a map by masked(): keep-out zones and speed limits, as Nav2 has them.
//
//   keepout   a map file of any format. Occupied cells are zones that block the robot; costs of free cells
//             multiply those of the map: in a map.yaml with `mode: scale` or `raw`, 1 + 4 v / 100
//   speed     a map.yaml with `mode: scale` or `raw`. The value v of 1 to 100 limits the speed to that many
//             percent of the top speed, and the cost of a cell is the time that it takes: 100 / v. 0 and
//             unknown: no limit
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
#include "wend/map/occupancy.hpp"

namespace wend {

/// What a mask says about cells.
enum class MaskKind {
  keepout,  // where the robot must not be
  speed     // how fast it may drive
};

/// How to read a mask.
struct MaskReading {
  MaskKind kind = MaskKind::keepout;  // of the mask
  SpeedScale speed = {};              // what the values of a speed mask mean
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

/// Reads "FILE", "keepout:FILE" or "speed:FILE". A speed mask may have options before the file, as
/// "speed:base=100:multiplier=-1:FILE" or "speed:top_speed=1.5:FILE": those of SpeedScale. Fails with
/// invalid_option; the file is not opened.
WEND_API Expected<MaskSpec, Error> parse_mask_spec(std::string_view text);

}  // namespace wend
