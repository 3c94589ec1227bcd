#include "wend_ros/occupancy_map.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace wend_ros {
namespace {

/// Far apart, cells are edited one by one: a box around them would repair all that lies between.
bool is_sparse(const Difference& found) {
  constexpr std::int64_t kShare = 8;
  return found.cells * kShare <= found.box.size();
}

std::vector<wend::CellEdit> cell_edits(const ValueRows& before, const ValueRows& after,
                                       wend::Cell corner, const MapReading& reading) {
  std::vector<wend::CellEdit> edits;
  for (int y = 0; y < after.height(); ++y) {
    const auto old_row = before.row(y);
    const auto row = after.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      if (row[x] == old_row[x]) continue;
      const CellReading read = read_cell(row[x], reading);
      edits.push_back({{corner.x + static_cast<int>(x), corner.y + y}, read.state});
      if (reading.rough) edits.back().terrain = read.terrain;
    }
  }
  return edits;
}

wend::MapEdit box_edit(const ValueRows& after, wend::Cell corner, const MapReading& reading) {
  wend::MapEdit edit{.corner = corner};
  edit.states = {after.width(), after.height(), wend::CellState::free};
  if (reading.rough) edit.terrain = {after.width(), after.height(), 1.0};
  for (int y = 0; y < after.height(); ++y) {
    for (int x = 0; x < after.width(); ++x) {
      const CellReading read = read_cell(after.row(y)[static_cast<std::size_t>(x)], reading);
      edit.states[{x, y}] = read.state;
      if (reading.rough) edit.terrain[{x, y}] = read.terrain;
    }
  }
  return edit;
}

}  // namespace

bool is_empty(const wend::MapEdit& edit) { return edit.box().empty() && edit.cells.empty(); }

/// The edit that makes the values of this box these ones.
wend::MapEdit OccupancyMap::edit_to(const ValueRows& values, const wend::CellBox& box) const {
  const ValueRows before = ValueRows(values_, layout_.width).part(box);
  const Difference found = difference(before, values);
  if (found.cells == 0) return {};
  const wend::Cell corner{box.begin.x + found.box.begin.x, box.begin.y + found.box.begin.y};
  const ValueRows after = values.part(found.box);
  if (!is_sparse(found)) return box_edit(after, corner, reading_);
  return {.cells = cell_edits(before.part(found.box), after, corner, reading_)};
}

void OccupancyMap::store(const ValueRows& values, const wend::CellBox& box) {
  for (int y = 0; y < values.height(); ++y) {
    const auto first = static_cast<std::size_t>(box.begin.y + y) * layout_.width +
                       static_cast<std::size_t>(box.begin.x);
    std::ranges::copy(values.row(y), values_.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

wend::Expected<OccupancyMap::Change, wend::Error> OccupancyMap::take(
    OccupancyLayout layout, std::span<const std::int8_t> values) {
  std::string fault = fault_of(layout, values.size());
  if (!fault.empty()) {
    values_ = {};
    return wend::failure(wend::Status::invalid_map, std::move(fault));
  }
  if (!empty() && layout == layout_) {
    const ValueRows rows(values, layout.width);
    const wend::CellBox all = wend::CellBox::of(rows);
    Change change{.whole = {}, .edit = edit_to(rows, all)};
    if (!is_empty(change.edit)) store(rows, all);
    return change;
  }
  layout_ = std::move(layout);
  values_.assign(values.begin(), values.end());
  return Change{.whole = whole(), .edit = {}};
}

wend::Expected<wend::MapEdit, wend::Error> OccupancyMap::take(const OccupancyUpdate& update) {
  std::string fault = empty() ? "there is no map yet" : fault_of(update, layout_);
  if (!fault.empty()) return wend::failure(wend::Status::invalid_map, std::move(fault));
  if (update.values.empty()) return wend::MapEdit{};
  const ValueRows rows(update.values, update.width);
  const wend::CellBox box{{update.x, update.y},
                          {update.x + rows.width(), update.y + rows.height()}};
  wend::MapEdit edit = edit_to(rows, box);
  if (!is_empty(edit)) store(rows, box);
  return edit;
}

bool OccupancyMap::read_as(const MapReading& reading) {
  if (reading == reading_) return false;
  reading_ = reading;
  return !empty();
}

wend::GridMap OccupancyMap::whole() const { return *map_from(layout_, values_, reading_); }

}  // namespace wend_ros
