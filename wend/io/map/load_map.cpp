#include "wend/io/map/load_map.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>

#include "wend/io/files.hpp"

namespace wend {
namespace {

constexpr double kLargestScaleFactor = 1e6;

/// The error in the options, empty if they are valid.
std::string wrong_options(const LoadOptions& options) {
  if (options.resolution && !(*options.resolution > 0 && std::isfinite(*options.resolution))) {
    return "the resolution given must be finite and above 0";
  }
  if (!(options.scale_factor >= 0 && options.scale_factor <= kLargestScaleFactor)) {
    return "the scale factor given must be in 0..1e6";
  }
  return {};
}

const MapFormatInfo* recognised_format(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  for (const MapFormatInfo& info : map_formats()) {
    if (info.recognises(bytes)) return &info;
  }
  return nullptr;
}

Expected<LoadedMap, Error> load(const std::string& bytes, const MapSource& source,
                                const LoadOptions& options) {
  const MapFormatInfo* format = map_format_of(source.file, MapUse::load);
  if (format == nullptr) format = recognised_format(bytes);
  if (format != nullptr) return format->load(bytes, source, options);
  return file_failure(source.file, 0,
                      bytes.empty() ? "the file is empty; expected a map"
                                    : fmt::format("unknown map format; expected {}",
                                                  map_formats_text(MapUse::load)));
}

Expected<LoadedMap, Error> load(const std::filesystem::path& file, const LoadOptions& options) {
  const MapFormatInfo* format = map_format_of(file, MapUse::load);
  if (format == nullptr || format->load_lines == nullptr) {
    const auto bytes = read_file(file);
    if (!bytes) return Unexpected<Error>(bytes.error());
    return load(*bytes, {file.string(), file.parent_path()}, options);
  }
  auto pieces = FilePieces::open(file);
  if (!pieces) return Unexpected<Error>(pieces.error());
  LineReader lines([&pieces] { return pieces->next(); }, pieces->size());
  auto loaded = format->load_lines(std::move(lines), file.string());
  if (pieces->failed()) return file_failure(file.string(), 0, "cannot be read");
  return loaded;
}

/// Calls `load_it` with checked options, and adds a note for an option that it does not use.
template <class LoadIt>
Expected<LoadedMap, Error> load_checked(const std::string& file, const LoadOptions& options,
                                        const LoadIt& load_it) {
  try {
    if (const std::string wrong = wrong_options(options); !wrong.empty()) {
      return file_failure(file, 0, wrong);
    }
    Expected<LoadedMap, Error> loaded = load_it();
    if (loaded && options.resolution && !info_of(loaded->format).takes_resolution) {
      loaded->notes.emplace_back("resolution option ignored: it applies only to bare images");
    }
    return loaded;
  } catch (const std::bad_alloc&) {
    return file_failure(file, 0, "not enough memory for this map");
  }
}

}  // namespace

Expected<LoadedMap, Error> load_map(const std::filesystem::path& file, const LoadOptions& options) {
  auto loaded = load_checked(file.string(), options, [&] { return load(file, options); });
  if (loaded) loaded->files.insert(loaded->files.begin(), file);
  return loaded;
}

Expected<LoadedMap, Error> parse_map(const std::string& bytes, const std::string& name,
                                     const LoadOptions& options) {
  return load_checked(name, options, [&] { return load(bytes, {name}, options); });
}

}  // namespace wend
