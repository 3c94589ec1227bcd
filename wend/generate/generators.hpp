#pragma once

// Generators: maps made from a seed, for demos, tests and teaching. The same kind, size, options
// and seed give the same map on every platform.
//
//   const auto map = wend::make_map("maze", 41, 21, 7, {{"corridor_width", "1"}});
//   if (!map) report(map.error().message);

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/options.hpp"
#include "wend/base/registry.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// The largest number of columns or rows of a generated map.
inline constexpr int kMostGeneratedCells = 16384;

/// A map, or why it could not be made: a wrong option, or a size that is too small or too large.
using GeneratorResult = Expected<GridMap, Error>;

/// A kind of map, and the function that makes it.
struct GeneratorInfo {
  std::string name;     // as in `wend generate`
  std::string summary;  // one line
  int least_width;      // in cells, with default options; a car's yard can also be narrow and long
  int least_height;     // the same
  int default_width = 41;   // of `wend generate` without --size
  int default_height = 21;  // the same

  /// All free cells are connected by their edges.
  bool connected = true;

  /// A start and a goal for demos: the cells (free_corner, free_corner) and, counted from the
  /// opposite corner, (width-1-free_corner, height-1-free_corner) are free if the map has them.
  /// In the office, the warehouse and the car park, which are in metres, a robot with a radius of 0.3 m can
  /// drive from one (1 m, 1 m) to the other.
  int free_corner = 1;

  std::vector<OptionInfo> options;  // which `make` takes
  /// Makes a map of this size in cells. The same seed and options give the same map.
  std::function<GeneratorResult(int width, int height, std::uint64_t seed, const OptionValues&)>
      make;
};

/// The generators of generators.def; a new one takes one file and one line. The office, the warehouse and the
/// car park are in metres, 0.1 m a cell, y up, with the lower left corner at (0, 0) and unknown cells around the
/// building and inside obstacles; the others have a plain frame. `car` and the parking yard are for cars
/// that stand on corners of cells and turn with a radius of one cell; rough road costs 2.
WEND_API const Registry<GeneratorInfo>& generators();

/// Makes a map of that kind, of `width` x `height` cells; an unknown kind, a wrong option or a size that is too
/// small or too large is Status::invalid_option.
WEND_API GeneratorResult make_map(std::string_view kind, int width, int height, std::uint64_t seed,
                                  const OptionValues& options = {});

}  // namespace wend
