#include "wend_ros/replanning.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "wend/control/nearest_ahead.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/path/polyline.hpp"

namespace wend_ros {
namespace {

/// Leaves of the share [from, to] of a line, along one axis, what lies between two limits. False: nothing.
bool clip(double begin, double end, double least, double most, double& from, double& to) {
  const double length = end - begin;
  if (length == 0) return begin >= least && begin <= most;
  const double first = (least - begin) / length;
  const double second = (most - begin) / length;
  from = std::max(from, std::min(first, second));
  to = std::min(to, std::max(first, second));
  return from <= to;
}

bool meets(wend::Point a, wend::Point b, const wend::CellBox& box) {
  double from = 0;
  double to = 1;
  return clip(a.x, b.x, box.begin.x, box.end.x, from, to) &&
         clip(a.y, b.y, box.begin.y, box.end.y, from, to);
}

bool meets(std::span<const wend::Point> line, const wend::CellBox& box) {
  if (line.size() == 1) return meets(line[0], line[0], box);
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (meets(line[i - 1], line[i], box)) return true;
  }
  return false;
}

}  // namespace

bool touches_ahead(const wend::SpaceChange& change, const wend::Path& path,
                   const std::optional<wend::Pose>& robot) {
  if (change.everything) return true;
  if (change.boxes.empty()) return false;
  const wend::Polyline line = wend::polyline_of(robot ? wend::remaining(path, *robot).path : path);
  // Rounded corners leave the path by less than a cell.
  return std::ranges::any_of(change.boxes, [&](const wend::CellBox& box) {
    return meets(line.points(), box.grown_by(1));
  });
}

void Replanning::begin() { searching_ = true; }

bool Replanning::end(wend::Path path, std::uint64_t version) {
  searching_ = false;
  version_ = version;
  path_ = std::move(path);
  const std::vector<Change> changes = std::exchange(meanwhile_, {});
  return std::ranges::any_of(changes, [&](const Change& each) {
    return each.version > version_ && is_reason(each.change, std::nullopt);
  });
}

bool Replanning::change(std::uint64_t version, wend::SpaceChange change,
                        const std::optional<wend::Pose>& robot) {
  if (searching_) {
    meanwhile_.push_back({version, std::move(change)});
    return false;
  }
  return version > version_ && is_reason(change, robot);
}

bool Replanning::is_reason(const wend::SpaceChange& change,
                           const std::optional<wend::Pose>& robot) const {
  if (when_ == ReplanOnChange::never || change.none()) return false;
  return when_ == ReplanOnChange::always || path_.empty() || touches_ahead(change, path_, robot);
}

}  // namespace wend_ros
