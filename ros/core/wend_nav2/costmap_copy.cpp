// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/costmap_copy.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "wend/map/value_edit.hpp"
#include "wend/map/value_rows.hpp"

namespace wend_nav2 {
namespace {

using Costs = wend::ValueRows<std::uint8_t>;

void copy_rows(const Costs& from, std::vector<std::uint8_t>& to, std::size_t first,
               std::size_t stride) {
  for (int y = 0; y < from.height(); ++y) {
    const std::size_t begin = first + static_cast<std::size_t>(y) * stride;
    std::ranges::copy(from.row(y), to.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

}  // namespace

wend::Frame CostmapLayout::frame() const {
  return {
      .resolution = resolution, .origin = {origin.x, origin.y, 0}, .y_up = true, .metric = true};
}

void CostmapCopy::read(const CostmapLayout& layout, std::span<const std::uint8_t> costs) {
  patch_box_ = {};
  if (layout != layout_ || costs.size() != costs_.size()) {
    layout_ = layout;
    costs_.assign(costs.begin(), costs.end());
    whole_ = true;
    return;
  }
  if (costs.empty()) return;
  const auto width = static_cast<std::size_t>(layout.width);
  const Costs now(costs, width);
  patch_box_ = wend::difference(Costs(costs_, width), now).box;
  if (patch_box_.empty()) return;
  const Costs part = now.part(patch_box_);
  patch_.resize(static_cast<std::size_t>(patch_box_.size()));
  copy_rows(part, patch_, 0, static_cast<std::size_t>(part.width()));
}

wend::Expected<void, wend::Error> CostmapCopy::bring_to(wend::Session& session,
                                                        const wend::CostmapScale& scale) {
  if (whole_ || scale != scale_) {
    store_patch();
    return give_whole(session, scale);
  }
  if (patch_box_.empty()) return {};
  return give_change(session, scale);
}

wend::Expected<void, wend::Error> CostmapCopy::give_whole(wend::Session& session,
                                                          const wend::CostmapScale& scale) {
  whole_ = true;
  auto map = wend::map_from_costmap(costs_, layout_.width, layout_.height, layout_.frame(), scale);
  if (!map) {
    session.clear_map(map.error().message);
    return wend::Unexpected<wend::Error>(std::move(map.error()));
  }
  session.set_map(*std::move(map), layout_.frame_id);
  scale_ = scale;
  whole_ = false;
  ++given_.maps;
  return {};
}

wend::Expected<void, wend::Error> CostmapCopy::give_change(wend::Session& session,
                                                           const wend::CostmapScale& scale) {
  std::array<wend::CellMeaning, 256> meanings;
  for (std::size_t cost = 0; cost < meanings.size(); ++cost) {
    meanings[cost] = wend::meaning_of_cost(static_cast<std::uint8_t>(cost), scale);
  }
  const auto read = [&](std::uint8_t cost) { return meanings[cost]; };
  const Costs before = Costs(costs_, static_cast<std::size_t>(layout_.width)).part(patch_box_);
  const Costs after(patch_, static_cast<std::size_t>(patch_box_.width()));
  const wend::MapEdit edit = wend::edit_between(before, after, patch_box_.begin, read);
  store_patch();
  const auto change = session.edit(edit);
  if (!change) {
    whole_ = true;
    return wend::Unexpected<wend::Error>(change.error());
  }
  ++given_.edits;
  return {};
}

void CostmapCopy::store_patch() {
  if (patch_box_.empty()) return;
  const auto width = static_cast<std::size_t>(layout_.width);
  const Costs part(patch_, static_cast<std::size_t>(patch_box_.width()));
  copy_rows(part, costs_,
            static_cast<std::size_t>(patch_box_.begin.y) * width +
                static_cast<std::size_t>(patch_box_.begin.x),
            width);
  patch_box_ = {};
}

}  // namespace wend_nav2
