// Maps of the C interface.

#include <limits>
#include <span>

#include "wend/base/parse.hpp"
#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"
#include "wend/io/map/load_map.hpp"

namespace wend::c {
namespace {

using Bytes = std::span<const std::uint8_t>;
using MapResult = Expected<std::unique_ptr<wend_map>, Failure>;

constexpr int kMostOccupied = 100;  // of WEND_CELLS_ROS

constexpr wend_map_options kMapDefaults{
    sizeof(wend_map_options), 1, {0, 0, 0}, WEND_CELLS_STATE, 65, nullptr, 0};

std::string size_text(std::int32_t width, std::int32_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

Expected<void, Failure> check_size(std::size_t size, std::int32_t width, std::int32_t height) {
  if (width < 1 || height < 1) {
    return refused("the map has " + size_text(width, height) + " cells: at least 1 x 1 expected");
  }
  const auto columns = static_cast<std::size_t>(width);
  if (columns > GridMap::kMaxCells / static_cast<std::size_t>(height)) {
    return refused("the map has " + size_text(width, height) + " cells, more than " +
                   std::to_string(GridMap::kMaxCells));
  }
  if (size != columns * static_cast<std::size_t>(height)) {
    return refused("there are " + std::to_string(size) + " bytes for a map of " +
                   size_text(width, height) + " cells");
  }
  return {};
}

Expected<void, Failure> check_options(const wend_map_options& options, std::size_t size) {
  if (options.cells < WEND_CELLS_STATE || options.cells > WEND_CELLS_ROS) {
    return refused("wend_map_options.cells is " + std::to_string(options.cells) +
                   ", not a value of wend_cells");
  }
  if (options.occupied_from < 1 || options.occupied_from > kMostOccupied) {
    return refused("wend_map_options.occupied_from is " + std::to_string(options.occupied_from) +
                   ": 1 to " + std::to_string(kMostOccupied) + " expected");
  }
  if (options.terrain == nullptr && options.terrain_count != 0) {
    return refused("wend_map_options.terrain is null, but terrain_count is not 0");
  }
  if (options.terrain != nullptr && options.terrain_count != size) {
    return refused("there are " + std::to_string(options.terrain_count) +
                   " terrain multipliers for " + std::to_string(size) + " cells");
  }
  return {};
}

/// The cells of one state, as a plane of bits.
template <class Predicate>
BitGrid plane(Bytes cells, int width, int height, const Predicate& is_set) {
  BitGrid bits(width, height);
  const auto columns = static_cast<std::size_t>(width);
  for (int y = 0; y < height; ++y) {
    set_row(bits.row_words(y), cells.subspan(static_cast<std::size_t>(y) * columns, columns),
            is_set);
  }
  return bits;
}

/// What one byte says.
CellState state_of(std::uint8_t byte, const wend_map_options& options) {
  switch (options.cells) {
    case WEND_CELLS_STATE:
      return static_cast<CellState>(byte);
    case WEND_CELLS_MASK:
      return byte == 0 ? CellState::free : CellState::occupied;
    default:
      if (byte > kMostOccupied) return CellState::unknown;
      return byte < options.occupied_from ? CellState::free : CellState::occupied;
  }
}

MapResult make_map(Bytes cells, int width, int height, const wend_map_options& options) {
  if (options.cells == WEND_CELLS_STATE) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i] <= static_cast<std::uint8_t>(CellState::unknown)) continue;
      const auto columns = static_cast<std::size_t>(width);
      return refused("cell (" + std::to_string(i % columns) + ',' + std::to_string(i / columns) +
                     ") is " + std::to_string(cells[i]) +
                     ": 0 (free), 1 (occupied) or 2 (unknown) expected");
    }
  }
  const auto cells_that_are = [&](CellState state) {
    return plane(cells, width, height,
                 [&](std::uint8_t byte) { return state_of(byte, options) == state; });
  };
  Grid<double> terrain;
  if (options.terrain != nullptr) {
    terrain = {width, height, std::vector(options.terrain, options.terrain + cells.size())};
  }
  const auto& [x, y, heading] = options.origin;
  const Frame frame{
      .resolution = options.resolution, .origin = {x, y, heading}, .y_up = true, .metric = true};
  auto map = make_grid_map(cells_that_are(CellState::occupied), cells_that_are(CellState::unknown),
                           frame, std::move(terrain));
  if (!map) return failed(std::move(map.error()));
  return std::make_unique<wend_map>(*std::move(map));
}

MapResult loaded_map(Expected<LoadedMap, Error> loaded) {
  if (!loaded) return failed(std::move(loaded.error()));
  return std::make_unique<wend_map>(std::move(loaded->map), std::move(loaded->notes));
}

}  // namespace
}  // namespace wend::c

using namespace wend::c;

wend_status wend_map_options_init(wend_map_options* options, size_t struct_size) {
  return init(options, struct_size, kMapDefaults);
}

wend_status wend_map_create(const uint8_t* cells, size_t size, int32_t width, int32_t height,
                            const wend_map_options* options, wend_map** map, wend_error* error) {
  return made("map", map, error, [&]() -> MapResult {
    if (cells == nullptr) return refused("cells is null");
    const auto chosen = wend::c::options_of("wend_map_options", options, kMapDefaults);
    if (!chosen) return wend::Unexpected<Failure>(chosen.error());
    if (const auto sound = check_size(size, width, height); !sound) {
      return wend::Unexpected<Failure>(sound.error());
    }
    if (const auto sound = check_options(*chosen, size); !sound) {
      return wend::Unexpected<Failure>(sound.error());
    }
    return make_map({cells, size}, width, height, *chosen);
  });
}

wend_status wend_map_load(const char* file, wend_map** map, wend_error* error) {
  return made("map", map, error, [&]() -> MapResult {
    if (file == nullptr) return refused("file is null");
    return loaded_map(wend::load_map(file));
  });
}

wend_status wend_map_parse(const void* bytes, size_t size, const char* name, wend_map** map,
                           wend_error* error) {
  return made("map", map, error, [&]() -> MapResult {
    if (bytes == nullptr) return refused("bytes is null");
    if (name == nullptr) return refused("name is null");
    if (size > std::numeric_limits<std::ptrdiff_t>::max()) {
      return refused("size is " + std::to_string(size) + ", more than any memory");
    }
    return loaded_map(wend::parse_map({static_cast<const char*>(bytes), size}, name));
  });
}

int32_t wend_map_width(const wend_map* map) { return map == nullptr ? 0 : map->map.width(); }

int32_t wend_map_height(const wend_map* map) { return map == nullptr ? 0 : map->map.height(); }

double wend_map_resolution(const wend_map* map) {
  return map == nullptr ? 0 : map->map.frame().resolution;
}

wend_status wend_map_origin(const wend_map* map, wend_pose* origin, wend_error* error) {
  return guarded(error, [&]() -> wend::Expected<void, Failure> {
    if (map == nullptr) return refused("map is null");
    if (origin == nullptr) return refused("origin is null");
    const auto& [x, y, heading] = map->map.frame().origin;
    *origin = {x, y, heading};
    return {};
  });
}

size_t wend_map_note_count(const wend_map* map) { return map == nullptr ? 0 : map->notes.size(); }

const char* wend_map_note(const wend_map* map, size_t index) {
  return index < wend_map_note_count(map) ? map->notes[index].c_str() : nullptr;
}

void wend_map_free(wend_map* map) { delete map; }
