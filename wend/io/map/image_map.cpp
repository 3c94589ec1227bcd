#include "wend/io/map/image_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "wend/io/map/doubts.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/map/count_bits.hpp"

namespace wend {
namespace {

constexpr int kOccupied = 100;

/// The value v whose terrain is nearest to this one, with kScaleMeaning.
int nearest_scale_value(double terrain) {
  const double v = std::round((terrain - 1) * 100 / kScaleMeaning.scale_factor);
  return static_cast<int>(std::clamp(v, 0.0, 100.0));
}

/// The grey value that kScaleMeaning reads as v. By its threshold 0 is occupied; 1 is the darkest free
/// value and rounds to v = 100.
std::uint16_t grey_of(int v) {
  return static_cast<std::uint16_t>(std::max(1.0, 255 - std::round(2.55 * v)));
}

/// An image of the map's size, with `value_of(cell)` for each pixel.
template <class ValueOf>
GreyImage image_of(const GridMap& map, const ValueOf& value_of) {
  GreyImage image;
  image.width = map.width();
  image.height = map.height();
  image.values.reserve(map.size());
  for (const int y : rows_from_top(map)) {
    for (int x = 0; x < map.width(); ++x) image.values.push_back(value_of(Cell{x, y}));
  }
  return image;
}

Expected<LoadedMap, Error> load_bare_image(const std::string& bytes, const MapSource& source,
                                           const LoadOptions& options) {
  ImageMapRows rows({});
  auto notes = decode_image(bytes, rows);
  if (!notes) return file_failure(source.file, 0, notes.error().message);
  const Frame frame{.resolution = options.resolution.value_or(1),
                    .metric = options.resolution.has_value()};
  auto map = rows.finish(frame);
  if (!map) return file_failure(source.file, 0, map.error().message);
  for (std::string& doubt : doubts_about(rows, {}, *map)) notes->push_back(std::move(doubt));
  return LoadedMap{*std::move(map), MapFormat::image_map, *std::move(notes)};
}

Expected<MapFiles, Error> save_bare_image(const GridMap& map, const std::filesystem::path& file) {
  const GreyImage image = trinary_image(map);
  if (lower_case(file.extension().string()) != ".png") return MapFiles{encode_pgm(image)};
  return encode_png(image).map([](std::string bytes) { return MapFiles{std::move(bytes)}; });
}

}  // namespace

ImageMapRows::PixelMeaning ImageMapRows::raw_meaning(double shade, double scale_factor) {
  const int v = static_cast<int>(std::lround(shade * 255));
  if (v > kOccupied) return {CellState::unknown};
  if (v == kOccupied) return {CellState::occupied};
  return {CellState::free, scaled_terrain(scale_factor, v)};
}

ImageMapRows::PixelMeaning ImageMapRows::meaning_of(int value, int maximum) const {
  const double shade = static_cast<double>(value) / maximum;
  if (meaning_.mode == ImageMode::raw) return raw_meaning(shade, meaning_.scale_factor);
  // One division, so that p is the double nearest to the true fraction.
  const double p = meaning_.negate ? shade : static_cast<double>(maximum - value) / maximum;
  if (p <= meaning_.free_threshold) return {CellState::free};
  if (p >= meaning_.occupied_threshold) return {CellState::occupied};
  if (meaning_.mode == ImageMode::trinary) return {CellState::unknown};
  const double between =
      (p - meaning_.free_threshold) / (meaning_.occupied_threshold - meaning_.free_threshold);
  const int v = static_cast<int>(std::lround(100 * between));
  return {CellState::free, scaled_terrain(meaning_.scale_factor, v)};
}

/// In every mode these lie side by side.
ImageMapRows::ByteRange ImageMapRows::bytes_of(CellState state) const {
  const auto first = std::ranges::find(state_table_, state);
  if (first == state_table_.end()) return {};
  const auto behind =
      std::find_if(first, state_table_.end(), [state](CellState other) { return other != state; });
  return {static_cast<unsigned char>(first - state_table_.begin()),
          static_cast<unsigned char>(behind - state_table_.begin() - 1)};
}

void ImageMapRows::begin(int width, int height, int maximum) {
  greys_.maximum = maximum;
  for (int value = 0; value <= maximum; ++value) {
    table_.push_back(meaning_of(value, maximum));
    state_table_.push_back(table_.back().state);
  }
  occupied_bytes_ = bytes_of(CellState::occupied);
  unknown_bytes_ = bytes_of(CellState::unknown);
  rows_.emplace(width).reserve(height);
  states_.resize(static_cast<std::size_t>(width));
  if (meaning_.mode != ImageMode::trinary) terrain_.resize(states_.size());
}

void ImageMapRows::look_at(std::span<const std::uint16_t> values) {
  const int grey = saved_unknown();
  int darkest = greys_.darkest;
  int brightest = greys_.brightest;
  std::size_t count = 0;
  for (const int value : values) {
    darkest = std::min(darkest, value);
    brightest = std::max(brightest, value);
    count += value == grey ? 1U : 0U;
  }
  greys_.darkest = darkest;
  greys_.brightest = brightest;
  greys_.saved_unknown += count;
}

bool ImageMapRows::add_bytes(std::span<const unsigned char> values) {
  if (!terrain_.empty() || greys_.maximum > 255) return false;
  assert(rows_);  // begin() comes first
  const auto occupied = rows_->append_free();
  const int grey = saved_unknown();
  Bytes darkest = Bytes{} + values.front();
  Bytes brightest = darkest;
  for_each_block(values, values.front(), [&](std::size_t x, const unsigned char* block) {
    const std::uint64_t on_map =
        ~std::uint64_t{0} >> (kBlock - std::min(kBlock, values.size() - x));
    const auto cells = [&](auto&& question) { return on_map & bits_of(block, question); };
    set_block(occupied, x, cells([&](Bytes bytes) {
                darkest = bytes < darkest ? bytes : darkest;
                brightest = bytes > brightest ? bytes : brightest;
                return occupied_bytes_.holds(bytes);
              }));
    const std::uint64_t unknown = cells([&](Bytes bytes) { return unknown_bytes_.holds(bytes); });
    if (unknown != 0) set_block(rows_->last_unknown(), x, unknown);
    if (grey > 255) return;
    const auto is_grey = [&](Bytes bytes) { return bytes == static_cast<unsigned char>(grey); };
    greys_.saved_unknown += static_cast<std::size_t>(count_bits(cells(is_grey)));
  });
  for (std::size_t i = 0; i < sizeof darkest; ++i) {
    greys_.darkest = std::min<int>(greys_.darkest, darkest[i]);
    greys_.brightest = std::max<int>(greys_.brightest, brightest[i]);
  }
  return true;
}

void ImageMapRows::add(std::span<const std::uint16_t> values,
                       std::span<const unsigned char> transparent) {
  const std::span<CellState> states = states_;
  const std::span<const CellState> state_table = state_table_;
  for (std::size_t x = 0; x < values.size(); ++x) states[x] = state_table[values[x]];
  for (std::size_t x = 0; x < terrain_.size(); ++x) terrain_[x] = table_[values[x]].terrain;
  if (meaning_.mode != ImageMode::raw) {
    for (std::size_t x = 0; x < transparent.size(); ++x) {
      if (transparent[x] == 0) continue;
      states_[x] = CellState::unknown;
      if (!terrain_.empty()) terrain_[x] = 1;
    }
  }
  look_at(values);
  assert(rows_);  // begin() comes first
  rows_->append(states_, terrain_);
}

GreyImage trinary_image(const GridMap& map) {
  return image_of(map, [&](Cell cell) -> std::uint16_t {
    if (map.occupied()[cell]) return 0;
    return map.unknown()[cell] ? kSavedUnknown : 254;
  });
}

double nearest_scaled_terrain(double terrain) {
  return scaled_terrain(kScaleMeaning.scale_factor, nearest_scale_value(terrain));
}

GreyImage scale_image(const GridMap& map) {
  std::vector<unsigned char> transparent;
  transparent.reserve(map.size());
  GreyImage image = image_of(map, [&](Cell cell) -> std::uint16_t {
    const CellState state = map.state(cell);
    transparent.push_back(state == CellState::unknown ? 1 : 0);
    return state == CellState::occupied ? 0 : grey_of(nearest_scale_value(map.terrain(cell)));
  });
  if (map.unknown().count() > 0) image.transparent = std::move(transparent);
  return image;
}

MapFormatInfo image_map_format() {
  return {.format = MapFormat::image_map,
          .name = "image",
          .noun = "an image",
          .extensions = {".png", ".pgm", ".pbm", ".ppm", ".pnm", ".bmp", ".jpg", ".jpeg"},
          .saved_extensions = {".png", ".pgm", ".pnm"},
          .recognises = looks_like_image,
          .load_bytes = load_bare_image,
          .takes_resolution = true,
          .save = save_bare_image};
}

}  // namespace wend
