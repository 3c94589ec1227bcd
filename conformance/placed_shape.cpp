#include "conformance/placed_shape.hpp"

namespace wend::test {
namespace {

/// Do an edge and a square, by its centre and half its width, overlap? They do unless one of the axes of the
/// square, or the normal of the edge, separates them.
bool crosses(Point from, Point to, Point centre, double half) {
  const Point middle{(from.x + to.x) / 2 - centre.x, (from.y + to.y) / 2 - centre.y};
  const Point reach{(to.x - from.x) / 2, (to.y - from.y) / 2};
  if (std::abs(middle.x) >= half + std::abs(reach.x)) return false;
  if (std::abs(middle.y) >= half + std::abs(reach.y)) return false;
  return std::abs(reach.x * middle.y - reach.y * middle.x) <
         half * (std::abs(reach.x) + std::abs(reach.y));
}

/// Does a ray from the point to +x cross the outline an odd number of times?
bool encloses(const std::vector<Point>& corners, Point point) {
  bool odd = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % corners.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
  }
  return odd;
}

}  // namespace

PlacedShape::PlacedShape(const FreeSpace& space, double depth)
    : map_(space.map()),
      unknown_blocked_(space.options().unknown == UnknownPolicy::blocked),
      outside_blocked_(space.outside() == OutsidePolicy::blocked),
      depth_(depth),
      radius_(space.footprint().circumscribed_radius() / space.map().frame().resolution) {
  const Polygon* const outline = space.footprint().outline();
  if (outline == nullptr) return;
  for (const Point corner : outline->corners()) {
    const double resolution = map_.frame().resolution;
    corners_.push_back({corner.x / resolution, corner.y / resolution});
  }
}

bool PlacedShape::is_blocked(Cell cell) const {
  if (!map_.contains(cell)) return outside_blocked_;
  const CellState state = map_.state(cell);
  return state == CellState::occupied || (state == CellState::unknown && unknown_blocked_);
}

bool PlacedShape::is_inside_obstacles(Point point) const {
  for (const double y : {point.y - depth_, point.y + depth_}) {
    for (const double x : {point.x - depth_, point.x + depth_}) {
      const Cell cell{static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
      if (!is_blocked(cell)) return false;
    }
  }
  return true;
}

bool PlacedShape::overlaps(const Pose& pose, Cell cell) const {
  const double half = 0.5 - depth_;
  const Point centre{cell.x + 0.5, cell.y + 0.5};
  if (corners_.empty()) {
    const double dx = std::max(std::abs(pose.x - centre.x) - 0.5, 0.0);
    const double dy = std::max(std::abs(pose.y - centre.y) - 0.5, 0.0);
    return std::hypot(dx, dy) < radius_ - depth_;
  }
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    if (crosses(placed_[i], placed_[(i + 1) % placed_.size()], centre, half)) return true;
  }
  return encloses(placed_, centre);
}

std::optional<Cell> PlacedShape::overlapped_at(const Pose& pose) {
  const double cosine = std::cos(pose.heading);
  const double sine = std::sin(pose.heading);
  placed_.clear();
  for (const Point corner : corners_) {
    placed_.push_back({pose.x + cosine * corner.x - sine * corner.y,
                       pose.y + sine * corner.x + cosine * corner.y});
  }
  const auto floor = [](double value) { return static_cast<int>(std::floor(value)); };
  const bool on_map = pose.x >= -depth_ && pose.y >= -depth_ && pose.x <= map_.width() + depth_ &&
                      pose.y <= map_.height() + depth_;
  const Cell under{floor(pose.x), floor(pose.y)};
  if (!on_map || (radius_ == 0 && is_inside_obstacles(pose.point()))) return under;
  for (int y = floor(pose.y - radius_); y <= floor(pose.y + radius_); ++y) {
    for (int x = floor(pose.x - radius_); x <= floor(pose.x + radius_); ++x) {
      if (is_blocked({x, y}) && overlaps(pose, {x, y})) return Cell{x, y};
    }
  }
  return std::nullopt;
}

}  // namespace wend::test
