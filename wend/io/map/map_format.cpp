#include "wend/io/map/map_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace wend {

#define WEND_MAP_FORMAT(name) MapFormatInfo name##_format();
#include "wend/io/map/formats.def"

namespace {

const std::vector<std::string_view>& extensions_of(const MapFormatInfo& info, MapUse use) {
  return use == MapUse::load ? info.extensions : info.saved_extensions;
}

}  // namespace

MapFormatInfo::Loaded MapFormatInfo::load(const std::string& bytes, const MapSource& source,
                                          const LoadOptions& options) const {
  if (load_lines != nullptr) return load_lines(LineReader(bytes), source.file);
  return load_bytes(bytes, source, options);
}

const Registry<MapFormatInfo>& map_formats() {
  static const Registry<MapFormatInfo> registry({
#define WEND_MAP_FORMAT(name) name##_format(),
#include "wend/io/map/formats.def"
  });
  return registry;
}

const MapFormatInfo& info_of(MapFormat format) {
  const MapFormatInfo& info = *(map_formats().begin() + static_cast<std::ptrdiff_t>(format));
  assert(info.format == format);
  return info;
}

const MapFormatInfo* map_format_of(const std::filesystem::path& file, MapUse use) {
  const std::string extension = lower_case(file.extension().string());
  for (const MapFormatInfo& info : map_formats()) {
    const auto& known = extensions_of(info, use);
    if (std::ranges::find(known, extension) != known.end()) return &info;
  }
  return nullptr;
}

std::vector<std::string> map_extensions(MapUse use) {
  std::vector<std::string> all;
  for (const MapFormatInfo& info : map_formats()) {
    const auto& known = extensions_of(info, use);
    all.insert(all.end(), known.begin(), known.end());
  }
  return all;
}

std::string map_formats_text(MapUse use) {
  std::vector<std::string> formats;
  for (const MapFormatInfo& info : map_formats()) {
    const auto& known = extensions_of(info, use);
    if (known.empty()) continue;
    const bool has_companion = use == MapUse::save && !info.companion.empty();
    formats.push_back(fmt::format("{} ({}{}{})", info.noun, fmt::join(known, ", "),
                                  has_companion ? " and its picture " : "",
                                  has_companion ? info.companion : ""));
  }
  return either_of(formats);
}

std::vector<int> rows_from_top(const GridMap& map) {
  std::vector<int> rows(static_cast<std::size_t>(map.height()));
  std::iota(rows.begin(), rows.end(), 0);
  if (map.frame().y_up) std::ranges::reverse(rows);
  return rows;
}

}  // namespace wend
