#include "wend/io/map/save_map.hpp"

#include <fmt/format.h>

#include <new>
#include <system_error>

#include "wend/io/files.hpp"
#include "wend/io/map/losses.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

/// The second file of a map that is saved under this name; nothing if its format has none.
std::optional<fs::path> companion_of(const fs::path& file) {
  const MapFormatInfo* format = map_format_of(file, MapUse::save);
  if (format == nullptr || format->companion.empty()) return std::nullopt;
  return fs::path(file).replace_extension(format->companion);
}

}  // namespace

Expected<void, Error> save_map(const GridMap& map, const fs::path& file) {
  try {
    const auto format = saved_format(file);
    if (!format) return Unexpected<Error>(format.error());
    const auto files = encode_map(map, *format, file);
    if (!files) return file_failure(file.string(), 0, files.error().message);
    if (const auto companion = companion_of(file)) {
      if (auto written = write_file(*companion, files->companion); !written) return written;
    }
    return write_file(file, files->bytes);
  } catch (const std::bad_alloc&) {
    return file_failure(file.string(), 0, "not enough memory to save this map");
  }
}

Expected<MapFiles, Error> encode_map(const GridMap& map, MapFormat format, const fs::path& file) {
  const std::string wrong = cells_not_held(map, format);
  if (!wrong.empty()) {
    return failure(Status::unsupported_map, wrong, std::string(info_of(format).name));
  }
  return info_of(format).save(map, file);
}

Expected<MapFormat, Error> saved_format(const fs::path& file) {
  if (const MapFormatInfo* format = map_format_of(file, MapUse::save)) return format->format;
  return file_failure(
      file.string(), 0,
      fmt::format("unknown map extension {}; expected {}", quote(file.extension().string()),
                  either_of(map_extensions(MapUse::save))));
}

std::vector<fs::path> saved_files(const fs::path& file) {
  if (const auto companion = companion_of(file)) return {*companion, file};
  return {file};
}

std::optional<fs::path> unrelated_picture(const fs::path& file) {
  auto picture = companion_of(file);
  std::error_code error;  // of files that do not exist
  if (!picture || !fs::exists(*picture, error)) return std::nullopt;
  if (const auto text = read_file(file)) {
    const auto named = map_format_of(file, MapUse::save)->companion_in(*text);
    if (named && fs::equivalent(file.parent_path() / *named, *picture, error)) return std::nullopt;
  }
  return picture;
}

}  // namespace wend
