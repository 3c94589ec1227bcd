#include "wend/map/grid_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

/// Eight states, one in each byte, as eight bits that say which of them are `state`. (occupied and unknown are
/// different bits.)
std::uint64_t bits_of(std::uint64_t states, CellState state) {
  static_assert(static_cast<int>(CellState::occupied) == 1 &&
                static_cast<int>(CellState::unknown) == 2);
  constexpr std::uint64_t kLowest = 0x0101010101010101U;
  // The product has bit 8 i of the factor at 56 + i, for each i.
  constexpr std::uint64_t kGather = 0x0102040810204080U;
  return ((states >> (state == CellState::occupied ? 0U : 1U)) & kLowest) * kGather >> 56U;
}

/// Sets the cells of one state, occupied or unknown, in a row of a bit plane that is all false.
void set_state(std::span<std::uint64_t> words, std::span<const CellState> row, CellState state) {
  std::size_t x = 0;
  for (; x + 8 <= row.size(); x += 8) {
    std::uint64_t states = 0;
    std::memcpy(&states, row.data() + x, sizeof states);
    if (states == 0) continue;
    const std::uint64_t bits = bits_of(states, state);
    const std::size_t bit = x + 1;
    words[bit / 64] |= bits << (bit % 64);
    if (bit % 64 > 56) words[bit / 64 + 1] |= bits >> (64 - bit % 64);
  }
  for (; x < row.size(); ++x) {
    words[(x + 1) / 64] |= std::uint64_t{row[x] == state} << ((x + 1) % 64);
  }
}

BitGrid plane(const Grid<CellState>& cells, CellState state) {
  BitGrid bits(cells.width(), cells.height());
  for (int y = 0; y < cells.height(); ++y) set_state(bits.row_words(y), cells.row(y), state);
  return bits;
}

void turn_over(BitGrid& plane) {
  for (int y = 0; y < plane.height() / 2; ++y) {
    const auto row = plane.row_words(y);
    std::swap_ranges(row.begin(), row.end(), plane.row_words(plane.height() - 1 - y).begin());
  }
}

std::string text_of(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

std::string size_fault(const BitGrid& occupied, const BitGrid& unknown) {
  const int width = occupied.width();
  const int height = occupied.height();
  if (width < 1 || height < 1) return "the map has no cells";
  if (static_cast<std::size_t>(width) > GridMap::kMaxCells / static_cast<std::size_t>(height)) {
    return "the map has " + text_of(width, height) + " cells, more than " +
           std::to_string(GridMap::kMaxCells);
  }
  if (unknown.width() != width || unknown.height() != height) {
    return "the map has " + text_of(width, height) + " occupied cells, but " +
           text_of(unknown.width(), unknown.height()) + " unknown cells";
  }
  for (int y = 0; y < height; ++y) {
    const auto words = occupied.row_words(y);
    const auto others = unknown.row_words(y);
    for (std::size_t i = 0; i < words.size(); ++i) {
      if ((words[i] & others[i]) != 0) {
        return "a cell in row " + std::to_string(y) + " is both occupied and unknown";
      }
    }
  }
  return {};
}

constexpr double kLeastResolution = 1e-9;   // metres a cell
constexpr double kLargestResolution = 1e9;  // as the radius of the largest robot

/// Metres tell places on the map that are a ten-thousandth of a cell apart.
bool tells_places(const Frame& frame, int width, int height) {
  constexpr double kMost = 1e12;  // cells: 2^52 of them have no fractions
  const double farthest = std::max(std::abs(frame.origin.x), std::abs(frame.origin.y));
  return farthest / frame.resolution + width + height <= kMost;
}

std::string frame_fault(const Frame& frame, int width, int height) {
  if (!(frame.resolution > 0) || !std::isfinite(frame.resolution)) {
    return "the resolution " + format_number(frame.resolution) +
           " is not a positive number of metres a cell";
  }
  if (frame.resolution < kLeastResolution || frame.resolution > kLargestResolution) {
    return "the resolution " + format_number(frame.resolution) + " is not in " +
           format_number(kLeastResolution) + ".." + format_number(kLargestResolution) +
           " metres a cell";
  }
  const MapPose& origin = frame.origin;
  const bool finite =
      std::isfinite(origin.x) && std::isfinite(origin.y) && std::isfinite(origin.heading);
  if (!finite) return "the origin contains NaN or infinity";
  if (tells_places(frame, width, height)) return {};
  return "the origin (" + format_number(origin.x) + ',' + format_number(origin.y) +
         ") is so far away that numbers do not tell cells of " + format_number(frame.resolution) +
         " m from each other";
}

std::string terrain_fault(const Grid<double>& terrain, int width, int height) {
  if (terrain.empty()) return {};
  if (terrain.width() != width || terrain.height() != height) {
    return "the terrain has " + text_of(terrain.width(), terrain.height()) +
           " multipliers for a map of " + text_of(width, height) + " cells";
  }
  const auto values = terrain.values();
  const auto wrong = std::ranges::find_if(
      values, [](double multiplier) { return !(multiplier >= 1) || !std::isfinite(multiplier); });
  if (wrong == values.end()) return {};
  const int at = static_cast<int>(wrong - values.begin());
  return "the terrain of cell (" + std::to_string(at % width) + ',' + std::to_string(at / width) +
         ") is " + format_number(*wrong) + ": a multiplier is at least 1 and finite";
}

Unexpected<Error> invalid_map(std::string message, std::string where) {
  return failure(Status::invalid_map, std::move(message), std::move(where));
}

}  // namespace

Expected<GridMap, Error> make_grid_map(const Grid<CellState>& cells, const Frame& frame,
                                       Grid<double> terrain) {
  return make_grid_map(plane(cells, CellState::occupied), plane(cells, CellState::unknown), frame,
                       std::move(terrain));
}

Expected<GridMap, Error> make_grid_map(BitGrid occupied, BitGrid unknown, const Frame& frame,
                                       Grid<double> terrain) {
  std::string fault = size_fault(occupied, unknown);
  if (!fault.empty()) return invalid_map(std::move(fault), "cells");
  fault = frame_fault(frame, occupied.width(), occupied.height());
  if (!fault.empty()) return invalid_map(std::move(fault), "frame");
  fault = terrain_fault(terrain, occupied.width(), occupied.height());
  if (!fault.empty()) return invalid_map(std::move(fault), "terrain");
  const auto values = terrain.values();
  const auto dear = std::ranges::count_if(values, [](double value) { return value != 1; });
  if (dear == 0) terrain = {};
  return GridMap(GridMap::Data{std::move(occupied), std::move(unknown), std::move(terrain), frame,
                               static_cast<std::size_t>(dear)});
}

GridMapBuilder::GridMapBuilder(int width)
    : occupied_(std::max(width, 0), 0), unknown_(std::max(width, 0), 0) {}

void GridMapBuilder::reserve(int height) {
  occupied_.reserve_rows(height);
  reserved_ = height;
}

void GridMapBuilder::append(std::span<const CellState> states, std::span<const double> terrain) {
  const auto cells = static_cast<std::size_t>(width());
  if (states.size() != cells || (!terrain.empty() && terrain.size() != cells)) {
    if (wrong_row_) return;
    const std::size_t values = states.size() != cells ? states.size() : terrain.size();
    const std::string row = "row " + std::to_string(height());
    wrong_row_ = Error{Status::invalid_map,
                       row + " has " + std::to_string(values) + " values, the map is " +
                           std::to_string(cells) + " cells wide",
                       row};
    return;
  }
  const bool uniform = std::all_of(terrain.begin(), terrain.end(),
                                   [](double multiplier) { return multiplier == 1; });
  set_state(append_free(), states, CellState::occupied);
  if (std::ranges::find(states, CellState::unknown) != states.end()) {
    set_state(last_unknown(), states, CellState::unknown);
  }
  if (uniform) return;
  terrain_.resize(static_cast<std::size_t>(height()) * cells, 1);
  std::ranges::copy_backward(terrain, terrain_.end());
}

std::span<std::uint64_t> GridMapBuilder::append_free() {
  terrain_.resize(terrain_.empty() ? 0 : terrain_.size() + static_cast<std::size_t>(width()), 1);
  return occupied_.append_row();
}

std::span<std::uint64_t> GridMapBuilder::last_unknown() {
  if (unknown_.height() == 0) unknown_.reserve_rows(std::max(reserved_, height()));
  unknown_.append_rows(height() - unknown_.height());
  return unknown_.row_words(height() - 1);
}

Expected<GridMap, Error> GridMapBuilder::finish(const Frame& frame) && {
  if (wrong_row_) return Unexpected<Error>(*std::move(wrong_row_));
  Grid<double> terrain;
  if (!terrain_.empty()) terrain = Grid<double>(width(), height(), std::move(terrain_));
  unknown_.append_rows(height() - unknown_.height());
  if (frame.y_up) {
    turn_over(occupied_);
    turn_over(unknown_);
    for (int y = 0; y < terrain.height() / 2; ++y) {
      const auto row = terrain.row(y);
      std::swap_ranges(row.begin(), row.end(), terrain.row(terrain.height() - 1 - y).begin());
    }
  }
  return make_grid_map(std::move(occupied_), std::move(unknown_), frame, std::move(terrain));
}

}  // namespace wend
