#include "wend/io/save_map.hpp"

#include <new>
#include <string>

#include "wend/io/image_map.hpp"
#include "wend/io/lower_case.hpp"
#include "wend/io/map_yaml.hpp"
#include "wend/io/moving_ai_map.hpp"
#include "wend/io/png.hpp"
#include "wend/io/pnm.hpp"
#include "wend/io/text_grid.hpp"
#include "wend/io/write_file.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

Expected<std::string, std::string> picture(const GridMap& map, bool png) {
  const auto image = trinary_image(map);
  if (!image) return Unexpected<std::string>(image.error() + "; .txt and .yaml can");
  if (png) return encode_png(*image);
  return encode_pgm(*image);
}

Expected<void, IoError> write_or_fail(const fs::path& file,
                                      const Expected<std::string, std::string>& bytes) {
  if (!bytes) return io_failure(file.string(), 0, bytes.error());
  return write_file(file, *bytes);
}

Expected<void, IoError> save_yaml(const GridMap& map, const fs::path& file) {
  MapYaml yaml;
  yaml.image = file.filename().replace_extension(".png");
  yaml.frame = map.frame();
  if (!map.frame().y_up && map.frame().origin != Pose{}) {
    return io_failure(file.string(), 0, "a map.yaml cannot hold an origin with y down");
  }
  if (!map.uniform_terrain()) yaml.meaning = kScaleMeaning;
  const auto image = map.uniform_terrain() ? trinary_image(map) : scale_image(map);
  if (!image) return io_failure(file.string(), 0, image.error());
  auto written = write_or_fail(file.parent_path() / yaml.image, encode_png(*image));
  if (written) written = write_file(file, format_map_yaml(yaml));
  return written;
}

Expected<void, IoError> save(const GridMap& map, const fs::path& file) {
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".map") return write_or_fail(file, format_moving_ai_map(map));
  if (extension == ".txt" || extension == ".grid") {
    return write_or_fail(file, format_text_grid(map));
  }
  if (extension == ".png") return write_or_fail(file, picture(map, true));
  if (extension == ".pgm") return write_or_fail(file, picture(map, false));
  if (extension == ".yaml" || extension == ".yml") return save_yaml(map, file);
  return io_failure(file.string(), 0,
                    "maps are saved as .map, .txt, .grid, .png, .pgm, .yaml or .yml");
}

}  // namespace

Expected<void, IoError> save_map(const GridMap& map, const fs::path& file) {
  try {
    return save(map, file);
  } catch (const std::bad_alloc&) {
    return io_failure(file.string(), 0, "not enough memory to save this map");
  }
}

}  // namespace wend
