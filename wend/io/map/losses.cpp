#include "wend/io/map/losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

double nearest_terrain(double terrain, CellState state, const MapFormatInfo& format) {
  if (state != CellState::free || format.nearest_terrain == nullptr) return 1;
  return format.nearest_terrain(terrain);
}

Frame nearest_frame(const Frame& frame, const MapFormatInfo& format) {
  if (!format.holds_frame) return {};
  return {frame.resolution, frame.y_up ? frame.origin : MapPose{}, true, true};
}

/// The numbers of cells that lose something, by the kind of loss.
struct Counts {
  std::size_t unknown = 0;       // states
  std::size_t blocked = 0;       // the terrain of cells that are not free
  std::size_t above = 0;         // terrain that is larger than the largest
  std::size_t rounded = 0;       // other terrain
  double greatest_rounding = 0;  // of these
};

Counts count_losses(const GridMap& map, const MapFormatInfo& format) {
  Counts counts;
  if (!format.holds_unknown_cells) counts.unknown = map.unknown().count();
  if (map.uniform_terrain()) return counts;
  for (const Cell cell : every_cell(map)) {
    const double terrain = map.terrain(cell);
    const CellState state = map.state(cell);
    const double off = std::abs(terrain - nearest_terrain(terrain, state, format));
    if (off == 0) continue;
    if (state != CellState::free) {
      ++counts.blocked;
    } else if (terrain > format.largest_terrain) {
      ++counts.above;
    } else {
      ++counts.rounded;
      counts.greatest_rounding = std::max(counts.greatest_rounding, off);
    }
  }
  return counts;
}

/// "a ROS map.yaml or a text grid": the formats with this property.
template <class Member>
std::string formats_with(Member MapFormatInfo::* member) {
  std::vector<std::string> nouns;
  for (const MapFormatInfo& format : map_formats()) {
    if (format.*member && format.save != nullptr) nouns.emplace_back(format.noun);
  }
  return either_of(nouns);
}

/// "; a text grid holds up to 9": where larger terrain than that of this format can go.
std::string larger_terrain(const MapFormatInfo& format) {
  for (const MapFormatInfo& other : map_formats()) {
    if (other.largest_terrain <= format.largest_terrain) continue;
    return fmt::format("; {} holds up to {}", other.noun, other.largest_terrain);
  }
  return {};
}

std::string cells(std::size_t count) {
  return fmt::format("{} cell{}", count, count == 1 ? "" : "s");
}

using Sentences = std::vector<std::string>;

void tell_cells(const Counts& counts, const MapFormatInfo& format, Sentences& told) {
  if (counts.unknown > 0) {
    told.push_back(fmt::format("unknown cells become occupied ({}): {} cannot hold unknown cells",
                               cells(counts.unknown), format.noun));
  }
  const std::size_t all = counts.blocked + counts.above + counts.rounded;
  if (all > 0 && format.nearest_terrain == nullptr) {
    told.push_back(
        fmt::format("terrain is lost ({}): {} cannot hold terrain, all cells cost the same",
                    cells(all), format.noun));
    return;
  }
  if (counts.above > 0) {
    told.push_back(fmt::format("terrain above {0} becomes {0} ({1}): the limit of {2}{3}",
                               format.largest_terrain, cells(counts.above), format.noun,
                               larger_terrain(format)));
  }
  if (counts.rounded > 0) {
    told.push_back(fmt::format("terrain is rounded, by at most {:.2g} ({}): {} holds {}",
                               counts.greatest_rounding, cells(counts.rounded), format.noun,
                               format.terrain_values));
  }
  if (counts.blocked > 0) {
    told.push_back(
        fmt::format("the terrain of occupied and unknown cells is lost ({}): {} holds terrain only "
                    "for free cells",
                    cells(counts.blocked), format.noun));
  }
}

void tell_frame(const Frame& before, const Frame& after, int height, const MapFormatInfo& format,
                Sentences& told) {
  if (before.metric && !after.metric) {
    told.push_back(fmt::format("the resolution of {} m a cell is lost: the unit of {} is the cell",
                               format_number(before.resolution), format.noun));
  } else if (before.resolution != after.resolution) {
    told.push_back(fmt::format("the cell size {} is lost: in {} it is 1",
                               format_number(before.resolution), format.noun));
  }
  if (!before.metric && after.metric) {
    told.push_back(fmt::format("the unit becomes the metre, as in {}: a cell is {} m wide",
                               format.noun, format_number(after.resolution)));
  }
  if (before.origin != after.origin) {
    told.push_back(fmt::format(
        "the origin [{}, {}, {}] is lost: {} holds {}", format_number(before.origin.x),
        format_number(before.origin.y), format_number(before.origin.heading), format.noun,
        format.holds_frame ? "an origin only where y was up before" : "no origin"));
  }
  if (before.y_up != after.y_up) {
    told.push_back(fmt::format("y points {}, as in every {}: cell (x, y) becomes (x, {} - y)",
                               after.y_up ? "up" : "down",
                               format.noun.substr(format.noun.find(' ') + 1), height - 1));
  }
}

}  // namespace

GridMap nearest_map(const GridMap& map, MapFormat wanted) {
  const MapFormatInfo& format = info_of(wanted);
  const Frame frame = nearest_frame(map.frame(), format);
  const bool terrain_held = format.nearest_terrain != nullptr && !map.uniform_terrain();
  Grid<CellState> states(map.width(), map.height());
  Grid<double> terrain = terrain_held ? Grid<double>(map.width(), map.height(), 1) : Grid<double>();
  const bool turned = map.frame().y_up != frame.y_up;
  for (const Cell cell : every_cell(map)) {
    const Cell before{cell.x, turned ? map.height() - 1 - cell.y : cell.y};
    const CellState state = map.state(before);
    const bool held = state != CellState::unknown || format.holds_unknown_cells;
    states[cell] = held ? state : CellState::occupied;
    if (terrain_held) terrain[cell] = nearest_terrain(map.terrain(before), state, format);
  }
  return *make_grid_map(states, frame, std::move(terrain));
}

std::vector<std::string> losses(const GridMap& map, MapFormat format) {
  const MapFormatInfo& info = info_of(format);
  Sentences told;
  tell_cells(count_losses(map, info), info, told);
  tell_frame(map.frame(), nearest_frame(map.frame(), info), map.height(), info, told);
  return told;
}

std::string cells_not_held(const GridMap& map, MapFormat wanted) {
  const MapFormatInfo& format = info_of(wanted);
  if (!format.holds_unknown_cells && map.unknown().count() > 0) {
    return fmt::format("{} cannot hold unknown cells ({}); {} can", format.noun,
                       cells(map.unknown().count()),
                       formats_with(&MapFormatInfo::holds_unknown_cells));
  }
  if (map.uniform_terrain()) return {};
  if (format.nearest_terrain == nullptr) {
    return fmt::format("{} cannot hold terrain; {} can", format.noun,
                       formats_with(&MapFormatInfo::nearest_terrain));
  }
  for (const Cell cell : every_cell(map)) {
    const CellState state = map.state(cell);
    const double terrain = map.terrain(cell);
    if (state == CellState::occupied) continue;
    if (terrain == nearest_terrain(terrain, state, format)) continue;
    return fmt::format(
        "{} cannot hold the terrain {} of cell ({},{}), only {} up to {} for free cells",
        format.noun, terrain, cell.x, cell.y, format.terrain_values, format.largest_terrain);
  }
  return {};
}

}  // namespace wend
