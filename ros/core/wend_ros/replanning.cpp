#include "wend_ros/replanning.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "wend/control/nearest_ahead.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/path/path_collision.hpp"
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

wend::Path rest_of(const wend::Path& path, const std::optional<wend::Pose>& robot) {
  return robot ? wend::remaining(path, *robot).path : path;
}

}  // namespace

bool touches_ahead(const wend::SpaceChange& change, const wend::Path& path,
                   const std::optional<wend::Pose>& robot) {
  if (change.everything) return true;
  if (change.boxes.empty()) return false;
  const wend::Polyline line = wend::polyline_of(rest_of(path, robot));
  // Rounded corners leave the path by less than a cell.
  return std::ranges::any_of(change.boxes, [&](const wend::CellBox& box) {
    return meets(line.points(), box.grown_by(1));
  });
}

bool spoils_ahead(const wend::SpaceChange& change, const wend::FreeSpace& space,
                  const wend::Path& path, const std::optional<wend::Pose>& robot) {
  if (!touches_ahead(change, path, robot)) return false;
  return !space.uniform_terrain() || wend::first_collision(rest_of(path, robot), space);
}

void Replanning::begin() { searching_ = true; }

bool Replanning::end(wend::Path path, std::uint64_t version) {
  searching_ = false;
  version_ = version;
  path_ = std::move(path);
  const std::vector<Change> changes = std::exchange(meanwhile_, {});
  if (when_ == ReplanOnChange::never) return false;
  return std::ranges::any_of(changes, [&](const Change& each) {
    if (each.version <= version_ || each.cells.none()) return false;
    return when_ == ReplanOnChange::always || path_.empty() ||
           touches_ahead(each.cells, path_, std::nullopt);
  });
}

bool Replanning::change(Change change, const wend::FreeSpace& space,
                        const std::optional<wend::Pose>& robot) {
  if (searching_) {
    meanwhile_.push_back(std::move(change));
    return false;
  }
  if (when_ == ReplanOnChange::never || change.version <= version_ || change.cells.none()) {
    return false;
  }
  return when_ == ReplanOnChange::always || path_.empty() ||
         spoils_ahead(change.cells, space, path_, robot);
}

}  // namespace wend_ros
