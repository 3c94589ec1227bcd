#include "wend/io/map/load_map.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "wend/io/image/grey_image.hpp"
#include "wend/io/lower_case.hpp"
#include "wend/io/map/image_map.hpp"
#include "wend/io/map/map_yaml.hpp"
#include "wend/io/map/moving_ai_map.hpp"
#include "wend/io/map/text_grid.hpp"
#include "wend/io/read_file.hpp"
#include "wend/io/utf8.hpp"

namespace wend {
namespace {

constexpr double kLargestScaleFactor = 1e6;

constexpr std::string_view kSupported =
    "ROS map.yaml (.yaml .yml), MovingAI (.map), text grids (.txt .grid) and images "
    "(.png .pgm .pbm .ppm .pnm) are";

std::optional<MapFormat> format_of_name(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".yaml" || extension == ".yml") return MapFormat::ros_yaml;
  if (extension == ".map") return MapFormat::moving_ai;
  if (extension == ".txt" || extension == ".grid") return MapFormat::text_grid;
  for (const std::string_view image : {".png", ".pgm", ".pbm", ".ppm", ".pnm"}) {
    if (extension == image) return MapFormat::image;
  }
  return std::nullopt;
}

std::optional<MapFormat> format_of_content(std::string_view bytes) {
  if (looks_like_image(bytes)) return MapFormat::image;
  bytes = without_byte_order_mark(bytes);
  if (bytes.starts_with("type ")) return MapFormat::moving_ai;
  if (bytes.starts_with("image:") || bytes.find("\nimage:") != std::string_view::npos) {
    return MapFormat::ros_yaml;
  }
  if (looks_like_text_grid(bytes)) return MapFormat::text_grid;
  return std::nullopt;
}

Expected<LoadedMap, IoError> load_bare_image(std::string_view bytes, const std::string& file,
                                             std::optional<double> resolution) {
  ImageMapRows rows({});
  auto notes = decode_image(bytes, rows);
  if (!notes) return io_failure(file, 0, notes.error());
  Frame frame;
  frame.resolution = resolution.value_or(1);
  frame.metric = resolution.has_value();
  return LoadedMap{rows.finish(frame), MapFormat::image, *std::move(notes)};
}

/// A file's bytes, and in which folder the files lie that it names.
struct Source {
  std::filesystem::path file;
  std::filesystem::path folder;
  const std::string& bytes;
};

Expected<LoadedMap, IoError> load_format(MapFormat format, const Source& source,
                                         const LoadOptions& options) {
  const auto& [file, folder, bytes] = source;
  switch (format) {
    case MapFormat::ros_yaml:
      return load_map_yaml(bytes, file.string(), folder, options.scale_factor);
    case MapFormat::moving_ai:
      return parse_moving_ai_map(bytes, file.string());
    case MapFormat::text_grid:
      return parse_text_grid(bytes, file.string());
    case MapFormat::image:
      break;
  }
  return load_bare_image(bytes, file.string(), options.resolution);
}

/// What is wrong with the options, empty if nothing is.
std::string wrong_options(const LoadOptions& options) {
  if (options.resolution && !(*options.resolution > 0 && std::isfinite(*options.resolution))) {
    return "the resolution given must be finite and above 0";
  }
  if (!(options.scale_factor >= 0 && options.scale_factor <= kLargestScaleFactor)) {
    return "the scale factor given must be in 0..1e6";
  }
  return {};
}

void note_resolution(Expected<LoadedMap, IoError>& loaded, const LoadOptions& options) {
  if (!loaded || !options.resolution || loaded->format == MapFormat::image) return;
  loaded->notes.emplace_back("the resolution given is not used: only a bare image takes one");
}

Expected<LoadedMap, IoError> load(const Source& source, const LoadOptions& options) {
  const auto& [file, folder, bytes] = source;
  const std::string wrong = wrong_options(options);
  if (!wrong.empty()) return io_failure(file.string(), 0, wrong);
  std::optional<MapFormat> format = format_of_name(file);
  if (!format) format = format_of_content(bytes);
  if (!format && bytes.empty()) return io_failure(file.string(), 0, "empty, a map expected");
  if (!format) {
    return io_failure(file.string(), 0, fmt::format("unknown map format; {} read", kSupported));
  }
  auto loaded = load_format(*format, source, options);
  note_resolution(loaded, options);
  return loaded;
}

/// Of a format with a letter for each cell, which takes more bytes than the map does.
Expected<LoadedMap, IoError> load_letters(MapFormat format, const std::filesystem::path& file) {
  auto pieces = FilePieces::open(file);
  if (!pieces) return Unexpected<IoError>(pieces.error());
  LineReader lines([&pieces] { return pieces->next(); }, pieces->size());
  auto loaded = format == MapFormat::moving_ai
                    ? parse_moving_ai_map(std::move(lines), file.string())
                    : parse_text_grid(std::move(lines), file.string());
  if (pieces->failed()) return io_failure(file.string(), 0, "cannot be read");
  return loaded;
}

Expected<LoadedMap, IoError> load_file(const std::filesystem::path& file,
                                       const LoadOptions& options) {
  const auto format = format_of_name(file);
  if (format != MapFormat::moving_ai && format != MapFormat::text_grid) {
    const auto bytes = read_file(file);
    if (!bytes) return Unexpected<IoError>(bytes.error());
    return load({file, file.parent_path(), *bytes}, options);
  }
  const std::string wrong = wrong_options(options);
  if (!wrong.empty()) return io_failure(file.string(), 0, wrong);
  auto loaded = load_letters(*format, file);
  note_resolution(loaded, options);
  return loaded;
}

}  // namespace

std::string_view to_string(MapFormat format) {
  switch (format) {
    case MapFormat::ros_yaml:
      return "ROS map.yaml";
    case MapFormat::moving_ai:
      return "MovingAI";
    case MapFormat::text_grid:
      return "text grid";
    case MapFormat::image:
      break;
  }
  return "image";
}

Expected<LoadedMap, IoError> load_map(const std::filesystem::path& file,
                                      const LoadOptions& options) {
  try {
    auto loaded = load_file(file, options);
    if (loaded) loaded->files.insert(loaded->files.begin(), file);
    return loaded;
  } catch (const std::bad_alloc&) {
    return io_failure(file.string(), 0, "not enough memory for this map");
  }
}

Expected<LoadedMap, IoError> parse_map(const std::string& bytes, const std::string& name,
                                       const LoadOptions& options) {
  try {
    return load({name, {}, bytes}, options);
  } catch (const std::bad_alloc&) {
    return io_failure(name, 0, "not enough memory for this map");
  }
}

}  // namespace wend
