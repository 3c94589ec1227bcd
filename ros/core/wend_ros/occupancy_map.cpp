#include "wend_ros/occupancy_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "wend/base/parse.hpp"
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

/// The cell that contains a place, if the map does.
std::optional<wend::Cell> cell_at(const OccupancyLayout& layout, wend::MapPoint place) {
  const wend::Point at = layout.frame.to_grid(place);
  const auto column = std::floor(at.x);
  const auto row = std::floor(at.y);
  if (!(column >= 0 && row >= 0 && column < layout.width && row < layout.height)) {
    return std::nullopt;
  }
  return wend::Cell{static_cast<int>(column), static_cast<int>(row)};
}

std::size_t index_of(const OccupancyLayout& layout, wend::Cell cell) {
  return static_cast<std::size_t>(cell.y) * layout.width + static_cast<std::size_t>(cell.x);
}

std::string seconds_between(Stamp from, Stamp to) {
  constexpr double kNanosecond = 1e-9;
  return wend::format_number(kNanosecond * static_cast<double>(to - from));
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

/// Lays the updates that are newer than a whole map over its values, and says which they are.
CellStamps OccupancyMap::keep_newer(const OccupancyLayout& layout, std::span<std::int8_t> values,
                                    Stamp stamp) const {
  CellStamps kept(layout.width, layout.height);
  if (empty() || stamp == 0 || layout.frame_id != layout_.frame_id) return kept;
  updates_.for_each_newer(stamp, [&](wend::Cell cell, Stamp at) {
    const wend::Point middle{cell.x + 0.5, cell.y + 0.5};
    const auto there = cell_at(layout, layout_.frame.to_metres(middle));
    if (!there) return;
    values[index_of(layout, *there)] = values_[index_of(layout_, cell)];
    kept.put({*there, {there->x + 1, there->y + 1}}, at);
  });
  return kept;
}

wend::Expected<OccupancyMap::Change, wend::Error> OccupancyMap::take(
    OccupancyLayout layout, std::span<const std::int8_t> given, Stamp stamp) {
  std::string fault = fault_of(layout, given.size());
  if (!fault.empty()) {
    clear();
    return wend::failure(wend::Status::invalid_map, std::move(fault));
  }
  std::vector<std::int8_t> values(given.begin(), given.end());
  updates_ = keep_newer(layout, values, stamp);
  whole_stamp_ = stamp;
  stamp_ = std::max(stamp, updates_.newest());
  Change change{.whole = {}, .edit = {}, .keeps_newer = updates_.newest() > 0};
  if (!empty() && layout == layout_) {
    const ValueRows rows(values, layout.width);
    change.edit = edit_to(rows, wend::CellBox::of(rows));
    values_ = std::move(values);
    return change;
  }
  auto made = map_from(layout, values, reading_);
  if (!made) {
    clear();
    return wend::Unexpected<wend::Error>(std::move(made.error()));
  }
  layout_ = std::move(layout);
  values_ = std::move(values);
  change.whole = *std::move(made);
  return change;
}

std::string OccupancyMap::fault_of_update(const OccupancyUpdate& update, Stamp stamp) const {
  if (empty()) return "there is no map yet";
  std::string fault = fault_of(update, layout_);
  if (!fault.empty() || stamp == 0 || stamp >= whole_stamp_) return fault;
  return "its stamp is " + seconds_between(stamp, whole_stamp_) + " s older than that of the map";
}

wend::Expected<wend::MapEdit, wend::Error> OccupancyMap::take(const OccupancyUpdate& update,
                                                              Stamp stamp) {
  std::string fault = fault_of_update(update, stamp);
  if (!fault.empty()) return wend::failure(wend::Status::invalid_map, std::move(fault));
  stamp_ = std::max(stamp_, stamp);
  if (update.values.empty()) return wend::MapEdit{};
  const ValueRows rows(update.values, update.width);
  const wend::CellBox box{{update.x, update.y},
                          {update.x + rows.width(), update.y + rows.height()}};
  wend::MapEdit edit = edit_to(rows, box);
  if (!is_empty(edit)) store(rows, box);
  updates_.put(box, stamp);
  return edit;
}

bool OccupancyMap::read_as(const MapReading& reading) {
  if (reading == reading_) return false;
  reading_ = reading;
  return !empty();
}

wend::GridMap OccupancyMap::whole() const { return *map_from(layout_, values_, reading_); }

}  // namespace wend_ros
