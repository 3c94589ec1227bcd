#include "wend/io/map/load_mask.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/files.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/map_yaml.hpp"

namespace wend {
namespace {

constexpr std::string_view kKeepout = "keepout:";
constexpr std::string_view kSpeed = "speed:";
constexpr std::string_view kRightSpeedMask =
    "a speed mask is a ROS map.yaml with mode: scale or mode: raw";

/// Why a loaded file has no values in between; empty if it may have some.
Expected<std::string, Error> why_no_values(const std::filesystem::path& file, MapFormat format) {
  if (format != MapFormat::map_yaml) {
    return fmt::format("{} has no speed limits; {}", info_of(format).noun, kRightSpeedMask);
  }
  const auto text = read_file(file);
  if (!text) return Unexpected<Error>(text.error());
  const auto yaml = parse_map_yaml(*text, file.string());
  if (!yaml) return Unexpected<Error>(yaml.error());
  if (yaml->meaning.mode != ImageMode::trinary) return std::string();
  return fmt::format("mode: trinary has no speed limits; {}", kRightSpeedMask);
}

/// The values -1 to 100 of a map whose multipliers are 1 + v.
std::vector<std::int8_t> values_of(const GridMap& map) {
  std::vector<std::int8_t> values;
  values.reserve(map.size());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const CellState state = map.state({x, y});
      const double value = state == CellState::free       ? map.terrain({x, y}) - 1
                           : state == CellState::occupied ? 100
                                                          : -1;
      values.push_back(static_cast<std::int8_t>(std::lround(value)));
    }
  }
  return values;
}

Expected<LoadedMap, Error> load_speed_mask(const std::filesystem::path& file,
                                           const SpeedScale& scale) {
  constexpr double kValuesAsTerrain = 100;
  auto loaded = load_map(file, {.resolution = {}, .scale_factor = kValuesAsTerrain});
  if (!loaded) return loaded;
  const auto why = why_no_values(file, loaded->format);
  if (!why) return Unexpected<Error>(why.error());
  if (!why->empty()) return file_failure(file.string(), 0, *why);
  const GridMap& map = loaded->map;
  auto mask = map_from_speed_mask(values_of(map), map.width(), map.height(), map.frame(), scale);
  if (!mask) return Unexpected<Error>(std::move(mask.error()));
  loaded->map = *std::move(mask);
  return loaded;
}

Unexpected<Error> wrong_spec(std::string message) {
  return failure(Status::invalid_option, std::move(message), "mask");
}

/// Takes "name=number:" from the front of a text, if it begins with it.
Expected<std::optional<double>, Error> take_option(std::string_view name, std::string_view& text) {
  if (!text.starts_with(name) || !text.substr(name.size()).starts_with('=')) return std::nullopt;
  const std::string_view rest = text.substr(name.size() + 1);
  const std::size_t end = rest.find(':');
  const std::string_view word = rest.substr(0, end);
  const auto number = parse_number(word);
  if (!number || !std::isfinite(*number)) {
    return wrong_spec(
        fmt::format("{} of a speed mask is {}: a finite number expected", name, quote(word)));
  }
  text = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return number;
}

/// Takes all options of a speed mask from the front of a text. Of two of the same name, the last counts.
Expected<SpeedScale, Error> take_speed_scale(std::string_view& text) {
  constexpr std::array<std::string_view, 3> kNames{"base", "multiplier", "top_speed"};
  std::array<std::optional<double>, kNames.size()> values;
  for (std::size_t before = 0; before != text.size();) {
    before = text.size();
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      auto taken = take_option(kNames[i], text);
      if (!taken) return Unexpected<Error>(std::move(taken.error()));
      if (taken->has_value()) values[i] = *taken;
    }
  }
  const SpeedScale usual;
  return SpeedScale{values[0].value_or(usual.base), values[1].value_or(usual.multiplier),
                    values[2]};
}

}  // namespace

Expected<LoadedMap, Error> load_mask(const std::filesystem::path& file,
                                     const MaskReading& reading) {
  if (reading.kind == MaskKind::speed) return load_speed_mask(file, reading.speed);
  auto loaded = load_map(file);
  if (!loaded) return loaded;
  BitGrid zone = loaded->map.occupied();
  if (zone.count() > 0) loaded->map.add_zone({file.string(), std::move(zone)});
  return loaded;
}

Expected<MaskSpec, Error> parse_mask_spec(std::string_view text) {
  MaskSpec spec;
  if (text.starts_with(kKeepout)) {
    text.remove_prefix(kKeepout.size());
  } else if (text.starts_with(kSpeed)) {
    text.remove_prefix(kSpeed.size());
    spec.reading.kind = MaskKind::speed;
    auto scale = take_speed_scale(text);
    if (!scale) return Unexpected<Error>(std::move(scale.error()));
    spec.reading.speed = *scale;
  }
  if (text.empty()) return wrong_spec("a mask needs a file: keepout:FILE or speed:FILE");
  if (text.find('\0') != std::string_view::npos) {
    return wrong_spec("the file name of a mask contains a zero byte");
  }
  spec.file = text;
  return spec;
}

}  // namespace wend
