#include "wend_ros/occupancy_map.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "wend/map/value_edit.hpp"

namespace wend_ros {
namespace {

/// What a value says of its cell, for an edit: without rough ground the terrain stays as it is.
auto reader_of(const MapReading& reading) {
  return [&reading](std::int8_t value) {
    const CellReading read = read_cell(value, reading);
    return wend::CellMeaning{read.state,
                             reading.rough ? std::optional(read.terrain) : std::nullopt};
  };
}

}  // namespace

bool is_empty(const wend::MapEdit& edit) { return edit.box().empty() && edit.cells.empty(); }

/// The edit that makes the values of this box these ones.
wend::MapEdit OccupancyMap::edit_to(const ValueRows& values, const wend::CellBox& box) const {
  const ValueRows before = ValueRows(values_, layout_.width).part(box);
  return wend::edit_between(before, values, box.begin, reader_of(reading_));
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
