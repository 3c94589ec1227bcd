#include "wend/map/map_edit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {
namespace {

std::string text_of(Cell cell) {
  return "cell (" + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ')';
}

std::string not_on_the_map(Cell cell, const GridMap& map) {
  return text_of(cell) + " of the edit is not on the map of " + std::to_string(map.width()) +
         " x " + std::to_string(map.height()) + " cells";
}

bool is_multiplier(double value) { return value >= 1 && std::isfinite(value); }

std::string wrong_terrain(Cell cell, double value) {
  return "the terrain of " + text_of(cell) + " of the edit is " + format_number(value) +
         ": a multiplier is at least 1 and finite";
}

std::string box_fault(const MapEdit& edit, const GridMap& map) {
  const CellBox box = edit.box();
  if (box.empty()) return {};
  const bool both = !edit.states.empty() && !edit.terrain.empty();
  if (both && (edit.states.width() != edit.terrain.width() ||
               edit.states.height() != edit.terrain.height())) {
    return "the states and the terrain of the edit differ in size";
  }
  if (!map.contains(box.begin)) return not_on_the_map(box.begin, map);
  const Cell last{box.end.x - 1, box.end.y - 1};
  if (!map.contains(last)) return not_on_the_map(last, map);
  const auto values = edit.terrain.values();
  const auto wrong = std::ranges::find_if_not(values, is_multiplier);
  if (wrong == values.end()) return {};
  const auto at = static_cast<int>(wrong - values.begin());
  return wrong_terrain({box.begin.x + at % box.width(), box.begin.y + at / box.width()}, *wrong);
}

std::string cells_fault(const MapEdit& edit, const GridMap& map) {
  for (const CellEdit& each : edit.cells) {
    if (!map.contains(each.cell)) return not_on_the_map(each.cell, map);
    if (each.terrain && !is_multiplier(*each.terrain)) {
      return wrong_terrain(each.cell, *each.terrain);
    }
  }
  return {};
}

/// Cells are gathered by squares of this size.
constexpr int kSquare = 32;

/// Two boxes become one if that has at most a few more cells than the two have.
bool belong_together(const CellBox& a, const CellBox& b) {
  constexpr std::int64_t kFew = std::int64_t{kSquare} * kSquare;
  return a.joined_with(b).size() <= a.size() + b.size() + kFew;
}

}  // namespace

CellBox MapEdit::box() const {
  const bool by_states = !states.empty();
  const int width = by_states ? states.width() : terrain.width();
  const int height = by_states ? states.height() : terrain.height();
  if (width <= 0 || height <= 0) return {};
  constexpr int kFar = GridMap::kMaxCells;  // off every map, and not near the largest number
  const Cell begin{std::clamp(corner.x, -kFar, kFar), std::clamp(corner.y, -kFar, kFar)};
  return {begin, {begin.x + width, begin.y + height}};
}

std::optional<Error> fault_of(const MapEdit& edit, const GridMap& map) {
  std::string fault = box_fault(edit, map);
  if (fault.empty()) fault = cells_fault(edit, map);
  if (fault.empty()) return std::nullopt;
  return Error{Status::invalid_map, std::move(fault), "edit"};
}

std::vector<CellBox> boxes_around(std::vector<Cell> cells) {
  const auto square_of = [](Cell cell) { return std::pair(cell.y / kSquare, cell.x / kSquare); };
  std::ranges::sort(cells, {}, square_of);
  std::vector<CellBox> boxes;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto end = std::find_if(first, cells.end(),
                                  [&](Cell cell) { return square_of(cell) != square_of(*first); });
    CellBox box;
    for (; first != end; ++first) box = box.joined_with({*first, {first->x + 1, first->y + 1}});
    constexpr std::ptrdiff_t kLast = 8;  // neighbours in the order of squares
    const auto recent = boxes.end() - std::min<std::ptrdiff_t>(kLast, std::ssize(boxes));
    const auto other = std::find_if(
        recent, boxes.end(), [&](const CellBox& each) { return belong_together(each, box); });
    if (other == boxes.end()) {
      boxes.push_back(box);
    } else {
      *other = other->joined_with(box);
    }
  }
  return boxes;
}

}  // namespace wend
