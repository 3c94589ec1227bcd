#include "wend/io/map/save_map.hpp"

#include <new>
#include <string>
#include <system_error>

#include "wend/io/image/png.hpp"
#include "wend/io/image/pnm.hpp"
#include "wend/io/lower_case.hpp"
#include "wend/io/map/image_map.hpp"
#include "wend/io/map/map_yaml.hpp"
#include "wend/io/map/moving_ai_map.hpp"
#include "wend/io/map/text_grid.hpp"
#include "wend/io/read_file.hpp"
#include "wend/io/write_file.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

Expected<std::string, std::string> picture(const GridMap& map, bool png) {
  const auto image = trinary_image(map);
  if (!image) return Unexpected<std::string>(image.error() + "; .txt and .yaml have terrain");
  if (png) return encode_png(*image);
  return encode_pgm(*image);
}

Expected<void, IoError> write_or_fail(const fs::path& file,
                                      const Expected<std::string, std::string>& bytes) {
  if (!bytes) return io_failure(file.string(), 0, bytes.error());
  return write_file(file, *bytes);
}

std::string extension_of(const fs::path& file) { return lower_case(file.extension().string()); }

fs::path picture_beside(const fs::path& file) { return fs::path(file).replace_extension(".png"); }

Expected<void, IoError> save_yaml(const GridMap& map, const fs::path& file) {
  const fs::path image_file = picture_beside(file);
  MapYaml yaml;
  yaml.image = image_file.filename();
  yaml.frame = map.frame();
  if (!map.frame().y_up && map.frame().origin != Pose{}) {
    return io_failure(file.string(), 0, "a map.yaml cannot hold an origin with y down");
  }
  if (!map.uniform_terrain()) yaml.meaning = kScaleMeaning;
  const auto image = map.uniform_terrain() ? trinary_image(map) : scale_image(map);
  if (!image) return io_failure(file.string(), 0, image.error());
  auto written = write_or_fail(image_file, encode_png(*image));
  if (written) written = write_file(file, format_map_yaml(yaml));
  return written;
}

Expected<void, IoError> save(const GridMap& map, const fs::path& file) {
  const auto format = saved_format(file);
  if (!format) return Unexpected<IoError>(format.error());
  switch (*format) {
    case MapFormat::ros_yaml:
      return save_yaml(map, file);
    case MapFormat::moving_ai:
      return write_or_fail(file, format_moving_ai_map(map));
    case MapFormat::text_grid:
      return write_or_fail(file, format_text_grid(map));
    case MapFormat::image:
      break;
  }
  return write_or_fail(file, picture(map, extension_of(file) == ".png"));
}

}  // namespace

Expected<MapFormat, IoError> saved_format(const fs::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".yaml" || extension == ".yml") return MapFormat::ros_yaml;
  if (extension == ".map") return MapFormat::moving_ai;
  if (extension == ".txt" || extension == ".grid") return MapFormat::text_grid;
  if (extension == ".png" || extension == ".pgm" || extension == ".pnm") return MapFormat::image;
  return io_failure(file.string(), 0,
                    "maps are saved as .map, .txt, .grid, .png, .pgm, .pnm, .yaml or .yml");
}

std::vector<fs::path> saved_files(const fs::path& file) {
  const auto format = saved_format(file);
  if (format && *format == MapFormat::ros_yaml) return {picture_beside(file), file};
  return {file};
}

std::optional<fs::path> unrelated_picture(const fs::path& file) {
  const auto format = saved_format(file);
  if (!format || *format != MapFormat::ros_yaml) return std::nullopt;
  fs::path picture = picture_beside(file);
  std::error_code error;  // of files that are not there
  if (!fs::exists(picture, error)) return std::nullopt;
  if (const auto text = read_file(file)) {
    const auto yaml = parse_map_yaml(*text, file.string());
    if (yaml && fs::equivalent(file.parent_path() / yaml->image, picture, error)) {
      return std::nullopt;
    }
  }
  return picture;
}

Expected<void, IoError> save_map(const GridMap& map, const fs::path& file) {
  try {
    return save(map, file);
  } catch (const std::bad_alloc&) {
    return io_failure(file.string(), 0, "not enough memory to save this map");
  }
}

}  // namespace wend
