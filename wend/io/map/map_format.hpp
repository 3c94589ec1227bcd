#pragma once

// The map formats. A new one takes one file and one line in formats.def: loading, saving, help, errors,
// `wend convert` and its messages about losses all use its MapFormatInfo.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/registry.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/text.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// The formats: map_yaml, moving_ai_map, text_grid, image_map.
enum class MapFormat {
#define WEND_MAP_FORMAT(name) name,
#include "wend/io/map/formats.def"
#undef WEND_MAP_FORMAT
};

/// A map from a file.
struct LoadedMap {
  GridMap map;                          // its cells, terrain and frame
  MapFormat format;                     // of the file
  std::vector<std::string> notes = {};  // what is unusual or probably not meant in the file
  std::vector<std::filesystem::path> files = {};  // files read: the map, and a map.yaml's image
  std::string image_note = {};  // the one of the notes that says where the image was found instead
};

/// What a file does not say about its map.
struct LoadOptions {
  std::optional<double> resolution;  // metres a cell, > 0, for a bare image
  double scale_factor = 4;           // terrain of `mode: scale`, in 0..1e6: 1 + factor * v / 100
};

/// Where the bytes of a map come from.
struct MapSource {
  std::string file;                // the name for errors
  std::filesystem::path folder{};  // folder of the files that it names
};

/// The bytes to be written for a map.
struct MapFiles {
  std::string bytes;        // the content of the file
  std::string companion{};  // the second file, for a format that has one
};

/// A format: its names, what it can hold, and the functions that load and save it.
struct WEND_API MapFormatInfo {
  /// A map, or why the bytes are not one.
  using Loaded = Expected<LoadedMap, Error>;

  MapFormat format;                                // the format that this describes
  std::string_view name;                           // in reports: "text grid"
  std::string_view noun;                           // in sentences: "a text grid"
  std::vector<std::string_view> extensions;        // of files that are loaded: ".txt"
  std::vector<std::string_view> saved_extensions;  // of files that are saved
  std::string_view companion{};  // extension of the second file of a saved map: ".png"

  // What the format can hold. Without a frame, cells are the unit and y points down.
  bool holds_unknown_cells = true;    // else cells are free or occupied
  bool holds_frame = false;           // resolution, y up; an origin where y is up
  double largest_terrain = 1;         // 1: every cell costs the same
  std::string_view terrain_values{};  // "whole numbers"
  /// The value nearest to `terrain` that the format can hold; null if it holds no terrain.
  double (*nearest_terrain)(double terrain) = nullptr;

  /// Whether bytes are of this format; for files whose name does not tell.
  bool (*recognises)(std::string_view bytes);

  // A format is loaded in one of two ways: line by line, with only the memory of the map, or as a whole.
  /// Loads line by line; `file` is the name for errors. Null if the format is loaded as a whole.
  Loaded (*load_lines)(LineReader lines, const std::string& file) = nullptr;
  /// Loads all bytes; null if the format is loaded line by line.
  Loaded (*load_bytes)(const std::string& bytes, const MapSource& source,
                       const LoadOptions& options) = nullptr;
  bool takes_resolution = false;  // whether it uses LoadOptions::resolution

  /// The files of a map whose cells the format can hold; null if maps are never saved in it. `file` is the
  /// name that the map will have. An error says what else the format cannot hold.
  Expected<MapFiles, Error> (*save)(const GridMap& map,
                                    const std::filesystem::path& file) = nullptr;

  /// The second file as a saved map names it; nothing if the text is not a map.
  std::optional<std::filesystem::path> (*companion_in)(const std::string& text) = nullptr;

  /// Loads bytes in the way of this format.
  Loaded load(const std::string& bytes, const MapSource& source,
              const LoadOptions& options = {}) const;
};

/// All formats, in the order in which help lists them.
WEND_API const Registry<MapFormatInfo>& map_formats();
/// The description of a format.
WEND_API const MapFormatInfo& info_of(MapFormat format);

/// "ROS map.yaml", "MovingAI", "text grid", "image"
inline std::string_view to_string(MapFormat format) { return info_of(format).name; }

/// What a file name is for: some extensions are loaded, but not saved.
enum class MapUse {
  load,  // reading a map
  save   // writing a map
};

/// The format of a file of this name, by its extension in any case; null if no format has it.
WEND_API const MapFormatInfo* map_format_of(const std::filesystem::path& file, MapUse use);

/// All extensions: ".yaml", ".yml", ".map", ...
WEND_API std::vector<std::string> map_extensions(MapUse use);

/// For help: "a ROS map.yaml (.yaml, .yml), a MovingAI map (.map), ... or an image (.png, .pgm)".
WEND_API std::string map_formats_text(MapUse use);

/// The numbers of the rows in the order in which a map is drawn, from the top one down.
WEND_API std::vector<int> rows_from_top(const GridMap& map);

}  // namespace wend
