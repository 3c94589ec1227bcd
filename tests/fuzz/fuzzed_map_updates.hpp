#pragma once

// Map messages and updates of them with any bytes at all as sizes, places, frames and values, one after the other.
// What does not fit is refused and changes nothing; the edits of what fits make the map of all values.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "fuzzed_bytes.hpp"
#include "wend/map/grid_map.hpp"
#include "wend_ros/occupancy_map.hpp"

namespace wend::test {

/// The map of all messages so far, kept value by value.
class FuzzedMapMessages {
 public:
  explicit FuzzedMapMessages(FuzzedBytes& bytes)
      : bytes_(bytes),
        reading_{.occupied_from = bytes.byte(), .rough = bytes.byte() % 2 == 1},
        messages_(reading_) {}

  /// The next message; what is wrong with what was made of it.
  std::string next() { return bytes_.byte() % 4 == 0 ? whole() : update(); }

 private:
  std::vector<std::int8_t> values(std::uint64_t fitting) {
    constexpr std::uint64_t kMost = 4096;
    // Often as many as there should be.
    const std::uint64_t count = bytes_.byte() < 200 ? fitting : bytes_.integer<std::uint16_t>();
    std::vector<std::int8_t> made(static_cast<std::size_t>(std::min(count, kMost)));
    for (std::int8_t& each : made) each = static_cast<std::int8_t>(bytes_.byte());
    return made;
  }

  std::string whole() {
    wend_ros::OccupancyLayout layout = layout_;
    if (layout_.size() == 0 || bytes_.byte() % 4 == 0) {
      layout = {.frame_id = bytes_.text(),
                .width = bytes_.integer<std::uint32_t>(),
                .height = bytes_.integer<std::uint32_t>(),
                .frame = {.resolution = bytes_.number(),
                          .origin = {bytes_.number(), bytes_.number(), bytes_.number()},
                          .y_up = true,
                          .metric = true}};
    }
    const auto given = values(layout.size());
    auto change = messages_.take(layout, given);
    if (!change) {
      layout_ = {};
      values_.clear();
      return messages_.empty() ? check_text(change.error().message) : "an invalid map stays";
    }
    if (given.size() != layout.size() || given.empty()) return "a map of other values than cells";
    if (!(layout.frame.resolution > 0)) return "a map without a resolution";
    const bool same_layout = !values_.empty() && layout == layout_;
    if (same_layout == change->whole.has_value()) return "an edit of another map";
    layout_ = std::move(layout);
    values_ = given;
    if (!change->whole) return applied(change->edit);
    map_ = *std::move(change->whole);
    return check_whole();
  }

  std::string update() {
    const std::string frame_id = bytes_.byte() < 200 ? layout_.frame_id : bytes_.text();
    wend_ros::OccupancyUpdate update{.frame_id = frame_id,
                                     .x = bytes_.integer<std::int32_t>(),
                                     .y = bytes_.integer<std::int32_t>(),
                                     .width = bytes_.integer<std::uint32_t>(),
                                     .height = bytes_.integer<std::uint32_t>(),
                                     .values = {}};
    const auto given = values(std::uint64_t{update.width} * update.height);
    update.values = given;
    const auto edit = messages_.take(update);
    if (edit.has_value() != fits(update)) return "an update fits, or it does not";
    if (!edit) {
      const std::string wrong = check_text(edit.error().message);
      return wrong.empty() ? check_whole() : wrong;
    }
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::size_t x = static_cast<std::size_t>(update.x) + i % update.width;
      const std::size_t y = static_cast<std::size_t>(update.y) + i / update.width;
      values_.at(y * layout_.width + x) = given[i];
    }
    return applied(*edit);
  }

  /// By real numbers, which do not overflow.
  bool fits(const wend_ros::OccupancyUpdate& update) const {
    if (values_.empty()) return false;
    if (!update.frame_id.empty() && update.frame_id != layout_.frame_id) return false;
    const double width = update.width;
    const double height = update.height;
    if (static_cast<double>(update.values.size()) != width * height) return false;
    return width * height == 0 ||
           (update.x >= 0 && update.y >= 0 && update.x + width <= layout_.width &&
            update.y + height <= layout_.height);
  }

  std::string applied(const MapEdit& edit) {
    if (!wend_ros::is_empty(edit)) {
      const auto edited = map_.edit(edit);
      if (!edited) return "an edit that does not fit: " + edited.error().message;
    }
    return check_whole();
  }

  std::string check_whole() const {
    if (values_.empty()) return messages_.empty() ? "" : "a map out of nothing";
    const GridMap whole = messages_.whole();
    if (!same_map(whole, map_)) return "the edits make another map";
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const Cell cell{static_cast<int>(i % layout_.width), static_cast<int>(i / layout_.width)};
      const auto read = wend_ros::read_cell(values_[i], reading_);
      if (whole.state(cell) != read.state) return "another state than the value says";
      if (whole.terrain(cell) != read.terrain) return "another terrain than the value says";
    }
    return {};
  }

  FuzzedBytes& bytes_;
  wend_ros::MapReading reading_;
  wend_ros::OccupancyMap messages_;
  wend_ros::OccupancyLayout layout_;
  std::vector<std::int8_t> values_;  // empty without a map
  GridMap map_ = *make_grid_map(Grid<CellState>(1, 1, CellState::free));
};

inline std::string fuzz_map_updates(std::string_view input) {
  FuzzedBytes bytes(input);
  FuzzedMapMessages messages(bytes);
  while (!bytes.empty()) {
    std::string wrong = messages.next();
    if (!wrong.empty()) return wrong;
  }
  return {};
}

}  // namespace wend::test
