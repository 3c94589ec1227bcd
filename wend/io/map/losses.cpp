#include "wend/io/map/losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/io/map/drawn_row.hpp"
#include "wend/io/map/image_map.hpp"
#include "wend/io/map/text_grid.hpp"

namespace wend {
namespace {

bool has_unknown_cells(MapFormat format) { return format != MapFormat::moving_ai; }

bool has_terrain(MapFormat format) {
  return format == MapFormat::ros_yaml || format == MapFormat::text_grid;
}

bool has_frame(MapFormat format) { return format == MapFormat::ros_yaml; }

double largest_terrain(MapFormat format) {
  if (format == MapFormat::ros_yaml) return scaled_terrain(kScaleMeaning.scale_factor, 100);
  return format == MapFormat::text_grid ? kLargestTextTerrain : 1;
}

CellState nearest_state(CellState state, MapFormat format) {
  const bool held = state != CellState::unknown || has_unknown_cells(format);
  return held ? state : CellState::occupied;
}

double nearest_terrain(double terrain, CellState state, MapFormat format) {
  if (state != CellState::free) return 1;
  if (format == MapFormat::ros_yaml) {
    return scaled_terrain(kScaleMeaning.scale_factor, nearest_scale_value(terrain));
  }
  return std::min(std::round(terrain), largest_terrain(format));
}

Frame nearest_frame(const Frame& frame, MapFormat format) {
  if (!has_frame(format)) return {};
  return {frame.resolution, frame.y_up ? frame.origin : Pose{}, true, true};
}

/// Calls `visit` with every cell.
template <class Visit>
void for_all_cells(const GridMap& map, const Visit& visit) {
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) visit(Cell{x, y});
  }
}

/// How many cells lose something, by what they lose.
struct Counts {
  std::size_t unknown = 0;       // states
  std::size_t blocked = 0;       // the terrain of cells that are not free
  std::size_t above = 0;         // terrain that is larger than the largest
  std::size_t rounded = 0;       // other terrain
  double greatest_rounding = 0;  // of these
};

Counts count_losses(const GridMap& map, MapFormat format) {
  Counts counts;
  if (!has_unknown_cells(format)) counts.unknown = map.unknown().count();
  if (map.uniform_terrain()) return counts;
  for_all_cells(map, [&](Cell cell) {
    const double terrain = map.terrain(cell);
    const CellState state = map.state(cell);
    const double off = std::abs(terrain - nearest_terrain(terrain, state, format));
    if (off == 0) return;
    if (state != CellState::free) {
      ++counts.blocked;
    } else if (terrain > largest_terrain(format)) {
      ++counts.above;
    } else {
      ++counts.rounded;
      counts.greatest_rounding = std::max(counts.greatest_rounding, off);
    }
  });
  return counts;
}

std::string a_map_of(MapFormat format) {
  switch (format) {
    case MapFormat::ros_yaml:
      return "a ROS map.yaml";
    case MapFormat::moving_ai:
      return "a MovingAI map";
    case MapFormat::text_grid:
      return "a text grid";
    case MapFormat::image:
      break;
  }
  return "an image";
}

std::string cells(std::size_t count) {
  return fmt::format("{} cell{}", count, count == 1 ? "" : "s");
}

using Sentences = std::vector<std::string>;

void tell_cells(const Counts& counts, MapFormat format, Sentences& told) {
  const std::string a_map = a_map_of(format);
  if (counts.unknown > 0) {
    told.push_back(fmt::format("unknown cells become occupied ({}): {} has no unknown ones",
                               cells(counts.unknown), a_map));
  }
  const std::size_t all = counts.blocked + counts.above + counts.rounded;
  if (all > 0 && !has_terrain(format)) {
    told.push_back(fmt::format("terrain is lost ({}): {} has none, all cells cost the same",
                               cells(all), a_map));
    return;
  }
  if (counts.above > 0) {
    told.push_back(fmt::format("terrain above {0} becomes {0} ({1}): {2} holds no more{3}",
                               largest_terrain(format), cells(counts.above), a_map,
                               format == MapFormat::ros_yaml ? ", a text grid up to 9" : ""));
  }
  if (counts.rounded > 0) {
    told.push_back(
        fmt::format("terrain is rounded, by {:.2g} at most ({}): {} holds {}",
                    counts.greatest_rounding, cells(counts.rounded), a_map,
                    format == MapFormat::ros_yaml ? "1 + 4 v/100 for whole v" : "whole numbers"));
  }
  if (counts.blocked > 0) {
    told.push_back(
        fmt::format("the terrain of occupied and unknown cells is lost ({}): {} holds "
                    "that of free ones",
                    cells(counts.blocked), a_map));
  }
}

void tell_frame(const Frame& before, const Frame& after, int height, MapFormat format,
                Sentences& told) {
  const std::string a_map = a_map_of(format);
  if (before.metric && !after.metric) {
    told.push_back(fmt::format("the resolution of {} m a cell is lost: {} counts in cells",
                               format_number(before.resolution), a_map));
  } else if (before.resolution != after.resolution) {
    told.push_back(fmt::format("the length of a cell, {}, is lost: in {} it is 1",
                               format_number(before.resolution), a_map));
  }
  if (!before.metric && after.metric) {
    told.push_back(fmt::format("cells are no longer the unit: {} counts in metres, here {} a cell",
                               a_map, format_number(after.resolution)));
  }
  if (before.origin != after.origin) {
    told.push_back(fmt::format("the origin [{}, {}, {}] is lost: {} has {}",
                               format_number(before.origin.x), format_number(before.origin.y),
                               format_number(before.origin.heading), a_map,
                               has_frame(format) ? "one only where y was up before" : "none"));
  }
  if (before.y_up != after.y_up) {
    told.push_back(fmt::format("y points {}, as in every {}: cell (x, y) becomes (x, {} - y)",
                               after.y_up ? "up" : "down", a_map.substr(a_map.find(' ') + 1),
                               height - 1));
  }
}

}  // namespace

GridMap nearest_map(const GridMap& map, MapFormat format) {
  const Frame frame = nearest_frame(map.frame(), format);
  const bool terrain_held = has_terrain(format) && !map.uniform_terrain();
  Grid<CellState> states(map.width(), map.height());
  Grid<double> terrain = terrain_held ? Grid<double>(map.width(), map.height(), 1) : Grid<double>();
  const bool turned = map.frame().y_up != frame.y_up;
  for_all_cells(map, [&](Cell cell) {
    const Cell before{cell.x, drawn_row(cell.y, map.height(), turned)};
    const CellState state = map.state(before);
    states[cell] = nearest_state(state, format);
    if (terrain_held) terrain[cell] = nearest_terrain(map.terrain(before), state, format);
  });
  return GridMap(states, frame, std::move(terrain));
}

std::vector<std::string> losses(const GridMap& map, MapFormat format) {
  Sentences told;
  tell_cells(count_losses(map, format), format, told);
  tell_frame(map.frame(), nearest_frame(map.frame(), format), map.height(), format, told);
  return told;
}

}  // namespace wend
