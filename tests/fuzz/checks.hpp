#pragma once

// What holds for every loader, whatever it is given. Each check returns what is wrong, empty if
// nothing is.

#include <cstddef>
#include <string>
#include <string_view>

#include "tests/testing/whole_image.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/map/image_map.hpp"
#include "wend/io/map/losses.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/io/map/save_map.hpp"

namespace wend::test {

/// The name that loaders are given for errors.
inline const std::string kFuzzedFile = "fuzzed";

/// Saving and loading larger maps would take too long.
inline constexpr std::size_t kLargestSavedMap = std::size_t{1} << 10;

/// An error's text is short, printable and says something.
inline std::string check_text(std::string_view what) {
  constexpr std::size_t kLongest = 1400;  // a file name in it may have 1000 bytes
  if (what.empty()) return "the error says nothing";
  if (what.size() > kLongest) return "the error is too long: " + std::string(what);
  for (const char letter : what) {
    if (static_cast<unsigned char>(letter) < ' ') return "the error is no line of text";
  }
  return {};
}

inline std::string check_error(const Error& error, const std::string& file = kFuzzedFile) {
  if (!error.where.starts_with(file)) return "the error is about another file: " + error.message;
  return check_text(error.message);
}

inline bool same_map(const GridMap& a, const GridMap& b) {
  return a.occupied() == b.occupied() && a.unknown() == b.unknown() && a.terrain() == b.terrain() &&
         a.frame() == b.frame();
}

/// The map in the bytes of a file of this format.
inline Expected<LoadedMap, Error> load_as(MapFormat format, std::string_view bytes) {
  return info_of(format).load(std::string(bytes), {kFuzzedFile});
}

/// Whether an image comes back from both picture formats, and its map from it.
inline std::string check_saved_image(const GridMap& map, const GreyImage& image,
                                     const ImageMeaning& meaning) {
  const auto png = encode_png(image);
  if (!png) return "no PNG of a map: " + png.error().message;
  const auto again = decode_image(*png);
  if (!again) return "the PNG of a map does not load: " + again.error().message;
  if (!same_map(map_from_image(*again, meaning, map.frame()), map))
    return "the PNG has another map";
  if (!image.transparent.empty()) return {};
  const auto pgm = decode_image(encode_pgm(image));
  if (!pgm) return "the PGM of a map does not load: " + pgm.error().message;
  if (!same_map(map_from_image(*pgm, meaning, map.frame()), map)) return "the PGM has another map";
  return {};
}

/// What nearest_map() makes of a map comes back from that format's file.
inline std::string check_saved_map(const GridMap& map, const MapFormatInfo& info) {
  const GridMap nearest = nearest_map(map, info.format);
  if (losses(map, info.format).empty() != same_map(map, nearest)) {
    return "losses() and nearest_map() disagree";
  }
  const auto files = encode_map(nearest, info.format, "m" + std::string(info.saved_extensions[0]));
  if (!files) return "a map that cannot be saved: " + files.error().message;
  if (info.load_lines == nullptr) {
    const bool scale = !nearest.uniform_terrain();
    return check_saved_image(nearest, scale ? scale_image(nearest) : trinary_image(nearest),
                             scale ? kScaleMeaning : ImageMeaning{});
  }
  const auto again = load_as(info.format, files->bytes);
  if (!again) return "a saved map does not load: " + again.error().message;
  return same_map(again->map, nearest) ? "" : "another map comes back";
}

/// A map has sound terrain and comes back from every format.
inline std::string check_map(const GridMap& map) {
  if (map.size() > GridMap::kMaxCells) return "the map is too large";
  for (const double multiplier : map.terrain().values()) {
    if (!(multiplier >= 1 && multiplier <= 5e6)) return "the terrain is out of range";
  }
  if (map.size() > kLargestSavedMap) return {};
  for (const MapFormatInfo& info : map_formats()) {
    if (info.save == nullptr) continue;
    const std::string wrong = check_saved_map(map, info);
    if (!wrong.empty()) return wrong + ", as " + std::string(info.name);
  }
  return {};
}

inline std::string check_map(const Expected<LoadedMap, Error>& loaded) {
  if (!loaded) return check_error(loaded.error());
  for (const std::string& note : loaded->notes) {
    const std::string wrong = check_text(note);
    if (!wrong.empty()) return wrong;
  }
  return check_map(loaded->map);
}

/// An image has a value for each pixel, none above its maximum, and is a map.
inline std::string check_image(const Expected<WholeImage, Error>& image) {
  if (!image) return check_text(image.error().message);
  const std::size_t pixels =
      static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height);
  if (image->width < 1 || image->height < 1 || image->values.size() != pixels) {
    return "the image has another size than its pixels";
  }
  if (!image->transparent.empty() && image->transparent.size() != pixels) {
    return "the image has another size than its alpha";
  }
  for (const int value : image->values) {
    if (value > image->maximum) return "a pixel is above the maximum";
  }
  if (pixels > kLargestSavedMap) return {};
  for (const ImageMode mode : {ImageMode::trinary, ImageMode::scale, ImageMode::raw}) {
    const std::string wrong = check_map(map_from_image(*image, {mode}, {}));
    if (!wrong.empty()) return wrong;
  }
  return {};
}

}  // namespace wend::test
