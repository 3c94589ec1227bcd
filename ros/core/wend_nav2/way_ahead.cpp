// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/way_ahead.hpp"

#include <algorithm>
#include <cstddef>

#include "wend/geometry/arc.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"

namespace wend_nav2 {
namespace {

bool is_on_map(wend::Point point, const wend::FreeSpace& space) {
  return point.x >= 0 && point.y >= 0 && point.x <= space.width() && point.y <= space.height();
}

}  // namespace

bool is_free_ahead(const wend::RouteLeg& leg, double along, double length,
                   const FrameChange& to_costmap, const wend::FreeSpace& space) {
  const wend::Frame& frame = space.map().frame();
  const double end = std::min(along + length, leg.line.length());
  const double radius = space.footprint().inscribed_radius() / frame.resolution - 0.5;
  const auto in_cells = [&](double at) {
    return frame.to_grid(to_costmap(leg.line.at(at).point()));
  };
  wend::Point from = in_cells(along);
  for (std::size_t i = leg.line.piece_at(along) + 1;; ++i) {
    const bool is_last = i >= leg.line.along().size() || leg.line.along()[i] >= end;
    const wend::Point to = in_cells(is_last ? end : leg.line.along()[i]);
    if (!is_on_map(from, space) || !is_on_map(to, space)) return true;
    const wend::Arc line{{from.x, from.y, wend::Line{from, to}.heading()}, distance(from, to), 0};
    if (arc_clearance(space, line) <= std::max(radius, 0.0)) return false;
    if (is_last) return true;
    from = to;
  }
}

}  // namespace wend_nav2
