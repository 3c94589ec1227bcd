#include "wend/map/occupancy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

constexpr double kLargestFactor = 1e6;
constexpr int kMostOccupancy = 100;
constexpr int kInscribed = 253;
constexpr int kNoInformation = 255;

/// What a byte of a grid means.
struct ByteMeaning {
  CellState state = CellState::unknown;
  double multiplier = 1;
};

using ByteTable = std::array<ByteMeaning, 256>;

std::optional<Error> fault_of_factor(double factor) {
  if (factor >= 0 && factor <= kLargestFactor) return std::nullopt;
  return Error{Status::invalid_option,
               "the cost factor is " + format_number(factor) + ": 0 to 1e6 expected",
               "cost_factor"};
}

std::optional<Error> fault_of(const OccupancyScale& scale) {
  if (scale.occupied_from >= 1 && scale.occupied_from <= kMostOccupancy) {
    return fault_of_factor(scale.cost_factor);
  }
  return Error{
      Status::invalid_option,
      "occupied_from is " + std::to_string(scale.occupied_from) + ": a value of 1 to 100 expected",
      "occupied_from"};
}

std::optional<Error> fault_of(const SpeedScale& scale) {
  const auto wrong = [](std::string name, double value, const std::string& expected) {
    std::string message =
        "the speed mask's " + name + " is " + format_number(value) + ": " + expected + " expected";
    return Error{Status::invalid_option, std::move(message), std::move(name)};
  };
  if (!std::isfinite(scale.base)) return wrong("base", scale.base, "a finite number");
  if (!std::isfinite(scale.multiplier)) {
    return wrong("multiplier", scale.multiplier, "a finite number");
  }
  const double top = scale.top_speed.value_or(1);
  if (!(top > 0) || !std::isfinite(top)) {
    return wrong("top_speed", top, "a finite number of m/s above 0");
  }
  return std::nullopt;
}

std::size_t index_of(int value) { return static_cast<unsigned char>(value); }

ByteTable table_of(const OccupancyScale& scale) {
  ByteTable table{};
  for (int v = 0; v <= kMostOccupancy; ++v) {
    const bool occupied = v >= scale.occupied_from;
    table[index_of(v)] = occupied ? ByteMeaning{CellState::occupied}
                                  : ByteMeaning{CellState::free, 1 + scale.cost_factor * v / 100};
  }
  return table;
}

ByteTable table_of(const CostmapScale& scale) {
  ByteTable table{};
  for (int v = 0; v <= kNoInformation; ++v) {
    const CellMeaning meaning = meaning_of_cost(static_cast<std::uint8_t>(v), scale);
    table[index_of(v)] = {meaning.state, meaning.terrain.value_or(1)};
  }
  return table;
}

ByteTable table_of(const SpeedScale& scale) {
  constexpr double kPercent = 100;
  const double top = scale.top_speed.value_or(kPercent);
  ByteTable table{};
  table[index_of(0)] = {CellState::free};
  for (int v = 1; v <= kMostOccupancy; ++v) {
    const double limit = scale.base + scale.multiplier * v;
    const bool limits = limit > 0 && limit < top;
    table[index_of(v)] = {CellState::free, limits ? top / limit : 1};
  }
  return table;
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

std::optional<Error> fault_of_size(std::size_t values, int width, int height) {
  std::string wrong;
  if (width < 1 || height < 1) {
    wrong = "the map is empty: " + size_text(width, height) + " cells";
  } else if (static_cast<std::size_t>(width) >
             GridMap::kMaxCells / static_cast<std::size_t>(height)) {
    wrong = "the map has " + size_text(width, height) + " cells, more than " +
            std::to_string(GridMap::kMaxCells);
  } else if (values != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    wrong = "the map has " + std::to_string(values) + " values, " + size_text(width, height) +
            " expected";
  }
  if (wrong.empty()) return std::nullopt;
  return Error{Status::invalid_map, std::move(wrong), "cells"};
}

template <class Byte>
Expected<GridMap, Error> map_of(std::span<const Byte> values, int width, int height,
                                const Frame& frame, const ByteTable& table) {
  if (auto fault = fault_of_size(values.size(), width, height)) {
    return Unexpected<Error>(*std::move(fault));
  }
  const auto meaning_of = [&](Byte value) -> const ByteMeaning& { return table[index_of(value)]; };
  BitGrid occupied(width, height);
  BitGrid unknown(width, height);
  const auto columns = static_cast<std::size_t>(width);
  for (int y = 0; y < height; ++y) {
    const auto row = values.subspan(static_cast<std::size_t>(y) * columns, columns);
    const auto is = [&](CellState state) {
      return [&, state](Byte value) { return meaning_of(value).state == state; };
    };
    set_row(occupied.row_words(y), row, is(CellState::occupied));
    set_row(unknown.row_words(y), row, is(CellState::unknown));
  }
  std::vector<double> multipliers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double multiplier = meaning_of(values[i]).multiplier;
    if (multipliers.empty() && multiplier == 1) continue;
    if (multipliers.empty()) multipliers.resize(values.size(), 1);
    multipliers[i] = multiplier;
  }
  Grid<double> terrain;
  if (!multipliers.empty()) terrain = {width, height, std::move(multipliers)};
  return make_grid_map(std::move(occupied), std::move(unknown), frame, std::move(terrain));
}

}  // namespace

Expected<GridMap, Error> map_from_occupancy(std::span<const std::int8_t> values, int width,
                                            int height, const Frame& frame,
                                            const OccupancyScale& scale) {
  if (auto fault = fault_of(scale)) return Unexpected<Error>(*std::move(fault));
  return map_of(values, width, height, frame, table_of(scale));
}

Expected<GridMap, Error> map_from_costmap(std::span<const std::uint8_t> costs, int width,
                                          int height, const Frame& frame,
                                          const CostmapScale& scale) {
  if (auto fault = fault_of_factor(scale.cost_factor)) return Unexpected<Error>(*std::move(fault));
  return map_of(costs, width, height, frame, table_of(scale));
}

CellMeaning meaning_of_cost(std::uint8_t cost, const CostmapScale& scale) {
  constexpr int kDearest = kInscribed - 1;
  if (cost == kNoInformation) return {CellState::unknown};
  if (cost > kInscribed || (cost == kInscribed && scale.inscribed_blocked)) {
    return {CellState::occupied};
  }
  return {CellState::free, 1 + scale.cost_factor * std::min<int>(cost, kDearest) / kDearest};
}

Expected<GridMap, Error> map_from_speed_mask(std::span<const std::int8_t> values, int width,
                                             int height, const Frame& frame,
                                             const SpeedScale& scale) {
  if (auto fault = fault_of(scale)) return Unexpected<Error>(*std::move(fault));
  return map_of(values, width, height, frame, table_of(scale));
}

}  // namespace wend
