#include "wend/io/map/load_mask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/files.hpp"
#include "wend/io/map/direction_mask.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/map_yaml.hpp"

namespace wend {
namespace {

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

/// An option of a kind of mask: its name, and where its value goes.
struct MaskOption {
  std::string_view name;
  std::optional<double>* value;
};

/// The number of an option; nothing if a part of a text is not one of these options.
Expected<bool, Error> take_option(std::string_view part, std::span<const MaskOption> options,
                                  std::string_view kind) {
  const std::size_t equals = part.find('=');
  const auto option = std::ranges::find(options, part.substr(0, equals), &MaskOption::name);
  if (equals == std::string_view::npos || option == options.end()) return false;
  const std::string_view word = part.substr(equals + 1);
  const auto number = parse_number(word);
  if (!number || !std::isfinite(*number)) {
    return wrong_spec(fmt::format("{} of a {} mask is {}: a finite number expected", option->name,
                                  kind, quote(word)));
  }
  *option->value = *number;
  return true;
}

/// Takes all options from the front of a text. Of two of the same name, the last counts.
Expected<void, Error> take_front(std::string_view& text, std::span<const MaskOption> options,
                                 std::string_view kind) {
  while (!text.empty()) {
    const std::size_t end = text.find(':');
    const auto taken = take_option(text.substr(0, end), options, kind);
    if (!taken) return Unexpected<Error>(taken.error());
    if (!*taken) break;
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return {};
}

/// The same from its back.
Expected<void, Error> take_back(std::string_view& text, std::span<const MaskOption> options,
                                std::string_view kind) {
  for (std::size_t at = text.rfind(':'); at != std::string_view::npos; at = text.rfind(':')) {
    const auto taken = take_option(text.substr(at + 1), options, kind);
    if (!taken) return Unexpected<Error>(taken.error());
    if (!*taken) break;
    text = text.substr(0, at);
  }
  return {};
}

Expected<void, Error> take_speed(std::string_view& text, MaskReading& reading) {
  std::optional<double> base;
  std::optional<double> multiplier;
  const std::array options{MaskOption{"base", &base}, MaskOption{"multiplier", &multiplier},
                           MaskOption{"top_speed", &reading.speed.top_speed}};
  auto taken = take_front(text, options, "speed");
  reading.speed.base = base.value_or(reading.speed.base);
  reading.speed.multiplier = multiplier.value_or(reading.speed.multiplier);
  return taken;
}

Expected<void, Error> take_oneway(std::string_view& text, MaskReading& reading) {
  std::optional<double> tolerance;
  std::optional<double> factor;
  const std::array options{MaskOption{"tolerance", &tolerance}, MaskOption{"factor", &factor}};
  for (const auto take : {take_front, take_back}) {
    if (auto taken = take(text, options, "one-way"); !taken) return taken;
  }
  constexpr double kHalfTurn = 180;
  if (tolerance && !(*tolerance >= 0 && *tolerance <= kHalfTurn)) {
    return wrong_spec(fmt::format("tolerance of a one-way mask is {}: 0 to 180 degrees expected",
                                  format_number(*tolerance)));
  }
  constexpr double kMostFactor = 1e4;
  if (factor && !(*factor >= 1 && *factor <= kMostFactor)) {
    return wrong_spec(fmt::format(
        "factor of a one-way mask is {}: a number from 1 to 10000 expected; without it, moves "
        "against an arrow are not allowed",
        format_number(*factor)));
  }
  if (tolerance) reading.arrow.tolerance = radians_from(*tolerance);
  reading.arrow.factor = factor.value_or(reading.arrow.factor);
  return {};
}

Expected<void, Error> take_height(std::string_view& text, MaskReading& reading) {
  std::optional<double> climb;
  std::optional<double> descend;
  std::optional<double> step;
  const std::array options{MaskOption{"climb", &climb}, MaskOption{"descend", &descend},
                           MaskOption{"step", &step}};
  for (const auto take : {take_front, take_back}) {
    if (auto taken = take(text, options, "height"); !taken) return taken;
  }
  if (!climb && !descend) {
    return wrong_spec(
        "a height mask needs a cost: climb=N or descend=N, the units of way that a unit of height "
        "costs");
  }
  constexpr double kMost = 1e4;
  const auto wrong = [&](const char* name, double value, double least) -> Expected<void, Error> {
    return wrong_spec(fmt::format("{} of a height mask is {}: a number from {} to 10000 expected",
                                  name, format_number(value), format_number(least)));
  };
  constexpr double kLeastStep = 1e-6;
  reading.slope = {climb.value_or(0), descend.value_or(0)};
  reading.height_step = step.value_or(reading.height_step);
  const auto within = [](double value, double least) { return value >= least && value <= kMost; };
  if (!within(reading.slope.climb, 0)) return wrong("climb", reading.slope.climb, 0);
  if (!within(reading.slope.descend, 0)) return wrong("descend", reading.slope.descend, 0);
  if (!within(reading.height_step, kLeastStep)) return wrong("step", *step, kLeastStep);
  return {};
}

/// A kind of mask as a text names it, and how its options are read.
struct KindOfMask {
  std::string_view name;
  MaskKind kind;
  Expected<void, Error> (*take_options)(std::string_view& text, MaskReading& reading);
};

constexpr std::array kKinds{
    KindOfMask{"keepout:", MaskKind::keepout, nullptr},
    KindOfMask{"speed:", MaskKind::speed, take_speed},
    KindOfMask{"oneway:", MaskKind::oneway, take_oneway},
    KindOfMask{"height:", MaskKind::height, take_height},
};

}  // namespace

Expected<LoadedMap, Error> load_mask(const std::filesystem::path& file,
                                     const MaskReading& reading) {
  if (reading.kind == MaskKind::speed) return load_speed_mask(file, reading.speed);
  if (reading.kind != MaskKind::keepout) return load_direction_mask(file, reading);
  auto loaded = load_map(file);
  if (!loaded) return loaded;
  BitGrid zone = loaded->map.occupied();
  if (zone.count() > 0) loaded->map.add_zone({file.string(), std::move(zone)});
  return loaded;
}

Expected<MaskSpec, Error> parse_mask_spec(std::string_view text) {
  MaskSpec spec;
  const auto kind =
      std::ranges::find_if(kKinds, [&](const auto& each) { return text.starts_with(each.name); });
  if (kind != kKinds.end()) {
    text.remove_prefix(kind->name.size());
    spec.reading.kind = kind->kind;
    if (kind->take_options != nullptr) {
      auto taken = kind->take_options(text, spec.reading);
      if (!taken) return Unexpected<Error>(std::move(taken.error()));
    }
  }
  if (text.empty()) {
    return wrong_spec("a mask needs a file: keepout:FILE, speed:FILE, oneway:FILE or height:FILE");
  }
  if (text.find('\0') != std::string_view::npos) {
    return wrong_spec("the file name of a mask contains a zero byte");
  }
  spec.file = text;
  return spec;
}

}  // namespace wend
