#pragma once

// A mask with its image, as fuzzed_map_yaml.hpp has them, read as keep-out zones and as speed limits and laid
// over two maps: one in metres and one in cells.

#include <array>
#include <string>
#include <string_view>

#include "checks.hpp"
#include "fuzzed_map_yaml.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/map/masked.hpp"

namespace wend::test {

/// A small map of all states and some costs.
inline GridMap map_under_masks(const Frame& frame) {
  Grid<CellState> cells(4, 3, CellState::free);
  cells[{1, 1}] = CellState::occupied;
  cells[{2, 0}] = CellState::unknown;
  Grid<double> terrain(4, 3, 1);
  terrain[{3, 2}] = 2;
  return *make_grid_map(cells, frame, terrain);
}

/// A mask blocks and makes dearer, and changes nothing else.
inline std::string check_masked(const GridMap& map, const GridMap& mask) {
  const auto made = masked(map, mask);
  if (!made) return check_text(made.error().message);
  if (made->frame() != map.frame()) return "a mask that moves the map";
  for (const Cell cell : every_cell(map)) {
    const CellState state = made->state(cell);
    if (state != map.state(cell) && state != CellState::occupied) return "a mask that frees a cell";
    if (!(made->terrain(cell) >= map.terrain(cell))) return "a mask that makes a cell cheaper";
  }
  return {};
}

inline std::string fuzz_mask(std::string_view bytes) {
  static const FuzzedFolder folder;
  static const std::array kMaps{
      map_under_masks({}),
      map_under_masks({.resolution = 0.5, .origin = {-1, -1, 0.3}, .y_up = true, .metric = true})};
  const std::size_t end = bytes.find('\0');
  const bool own_image = end != std::string_view::npos;
  const std::string file = folder / "map.yaml";
  folder.write("map.yaml", bytes.substr(0, end));
  folder.write("image.pgm", own_image ? bytes.substr(end + 1) : FuzzedFolder::kGoodImage);
  for (const MaskKind kind : {MaskKind::keepout, MaskKind::speed}) {
    const auto mask = load_mask(file, {.kind = kind, .speed = {}});
    if (!mask) {
      if (std::string wrong = check_error(mask.error(), file); !wrong.empty()) return wrong;
      continue;
    }
    if (kind == MaskKind::speed && mask->map.occupied().count() != 0) return "speed that blocks";
    for (const GridMap& map : kMaps) {
      if (std::string wrong = check_masked(map, mask->map); !wrong.empty()) return wrong;
    }
  }
  return {};
}

/// A mask that was read from a text comes back from the text that says the same in full.
inline std::string fuzz_mask_spec(std::string_view bytes) {
  const auto spec = parse_mask_spec(bytes);
  if (!spec) return check_text(spec.error().message);
  if (spec->file.empty()) return "a mask without a file";
  const SpeedScale& speed = spec->reading.speed;
  std::string text = "keepout:";
  if (spec->reading.kind == MaskKind::speed) {
    text = "speed:base=" + format_number(speed.base) +
           ":multiplier=" + format_number(speed.multiplier) + ":";
    if (speed.top_speed) text += "top_speed=" + format_number(*speed.top_speed) + ":";
  }
  const auto again = parse_mask_spec(text + spec->file.string());
  const bool same = again && again->file == spec->file &&
                    again->reading.kind == spec->reading.kind &&
                    again->reading.speed.base == speed.base &&
                    again->reading.speed.multiplier == speed.multiplier &&
                    again->reading.speed.top_speed == speed.top_speed;
  return same ? "" : "another mask comes back";
}

}  // namespace wend::test
