#include "wend/io/load_map.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "wend/io/grey_image.hpp"
#include "wend/io/image_map.hpp"
#include "wend/io/lower_case.hpp"
#include "wend/io/map_yaml.hpp"
#include "wend/io/moving_ai_map.hpp"
#include "wend/io/read_file.hpp"
#include "wend/io/text_grid.hpp"

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
  if (bytes.starts_with("type ")) return MapFormat::moving_ai;
  if (bytes.starts_with("image:") || bytes.find("\nimage:") != std::string_view::npos) {
    return MapFormat::ros_yaml;
  }
  return std::nullopt;
}

Expected<LoadedMap, IoError> load_bare_image(std::string_view bytes, const std::string& file,
                                             std::optional<double> resolution) {
  auto image = decode_image(bytes);
  if (!image) return io_failure(file, 0, image.error());
  Frame frame;
  frame.resolution = resolution.value_or(1);
  frame.metric = resolution.has_value();
  return LoadedMap{map_from_image(*image, {}, frame), MapFormat::image, std::move(image->notes)};
}

Expected<LoadedMap, IoError> load_format(MapFormat format, const std::filesystem::path& file,
                                         const std::string& bytes, const LoadOptions& options) {
  switch (format) {
    case MapFormat::ros_yaml:
      return load_map_yaml(bytes, file, options.scale_factor);
    case MapFormat::moving_ai:
      return parse_moving_ai_map(bytes, file.string());
    case MapFormat::text_grid:
      return parse_text_grid(bytes, file.string());
    case MapFormat::image:
      break;
  }
  return load_bare_image(bytes, file.string(), options.resolution);
}

Expected<LoadedMap, IoError> load(const std::filesystem::path& file, const LoadOptions& options) {
  if (options.resolution && !(*options.resolution > 0 && std::isfinite(*options.resolution))) {
    return io_failure(file.string(), 0, "the resolution given must be finite and above 0");
  }
  if (!(options.scale_factor >= 0 && options.scale_factor <= kLargestScaleFactor)) {
    return io_failure(file.string(), 0, "the scale factor given must be in 0..1e6");
  }
  const auto bytes = read_file(file);
  if (!bytes) return Unexpected<IoError>(bytes.error());
  std::optional<MapFormat> format = format_of_name(file);
  if (!format) format = format_of_content(*bytes);
  if (!format) {
    return io_failure(file.string(), 0, fmt::format("unknown map format; {} read", kSupported));
  }
  auto loaded = load_format(*format, file, *bytes, options);
  if (loaded && options.resolution && loaded->format != MapFormat::image) {
    loaded->notes.emplace_back("the resolution given is not used: only a bare image takes one");
  }
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
    auto loaded = load(file, options);
    if (loaded) loaded->files.insert(loaded->files.begin(), file);
    return loaded;
  } catch (const std::bad_alloc&) {
    return io_failure(file.string(), 0, "not enough memory for this map");
  }
}

}  // namespace wend
