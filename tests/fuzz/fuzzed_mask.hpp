#pragma once

// A mask with its image, as fuzzed_map_yaml.hpp has them, read as keep-out zones, as speed limits, as arrows and as
// heights, and laid over two maps: one in metres and one in cells.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "checks.hpp"
#include "fuzzed_map_yaml.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/map/direction_map.hpp"
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
    if (made->directions() == nullptr) continue;
    for (int i = 0; i < kDirections; ++i) {
      const std::uint32_t factor = made->directions()->factor(cell, static_cast<Direction>(i));
      const bool right = factor == DirectionMap::kForbidden || factor >= DirectionMap::kOne;
      if (!right) return "a direction that makes a step cheaper";
    }
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
  for (const MaskKind kind :
       {MaskKind::keepout, MaskKind::speed, MaskKind::oneway, MaskKind::height}) {
    const auto mask = load_mask(file, {.kind = kind, .slope = {.climb = 3, .descend = 1}});
    if (!mask) {
      if (std::string wrong = check_error(mask.error(), file); !wrong.empty()) return wrong;
      continue;
    }
    if (kind != MaskKind::keepout && mask->map.occupied().count() != 0)
      return "a mask that blocks though it is none to keep out";
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
  } else if (spec->reading.kind == MaskKind::oneway) {
    const ArrowOptions& arrow = spec->reading.arrow;
    text = "oneway:tolerance=" + format_number(degrees_from(arrow.tolerance)) + ":";
    if (!std::isinf(arrow.factor)) text += "factor=" + format_number(arrow.factor) + ":";
  } else if (spec->reading.kind == MaskKind::height) {
    text = "height:climb=" + format_number(spec->reading.slope.climb) +
           ":descend=" + format_number(spec->reading.slope.descend) +
           ":step=" + format_number(spec->reading.height_step) + ":";
  }
  const auto again = parse_mask_spec(text + spec->file.string());
  const bool same =
      again && again->file == spec->file && again->reading.kind == spec->reading.kind &&
      again->reading.speed.base == speed.base &&
      again->reading.speed.multiplier == speed.multiplier &&
      again->reading.speed.top_speed == speed.top_speed &&
      std::abs(again->reading.arrow.tolerance - spec->reading.arrow.tolerance) < 1e-9 &&
      again->reading.arrow.factor == spec->reading.arrow.factor &&
      again->reading.slope.climb == spec->reading.slope.climb &&
      again->reading.slope.descend == spec->reading.slope.descend &&
      again->reading.height_step == spec->reading.height_step;
  return same ? "" : "another mask comes back";
}

}  // namespace wend::test
