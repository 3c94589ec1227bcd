#include "wend/cover/joined_strokes.hpp"

#include <memory>
#include <string>
#include <utility>

#include "wend/path/smoothing/simplification.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

/// Adds ways and strokes to a path.
class Joiner {
 public:
  Joiner(const CoverageArea& area, std::unique_ptr<Planner> planner, const Deadline& deadline)
      : area_(area), planner_(std::move(planner)), deadline_(deadline) {}

  Expected<void, Error> go_to(Point place) {
    if (path_.empty()) {
      path_.push_back(place);
      return {};
    }
    const Point from = path_.back();
    if (from == place) return {};
    if (!area_.free_along(from, place)) {
      if (auto added = add_way(from, place); !added) return added;
    }
    if (path_.back() != place) path_.push_back(place);
    return {};
  }

  Expected<void, Error> drive(const Stroke& stroke) {
    if (auto there = go_to(stroke.front()); !there) return there;
    path_.insert(path_.end(), stroke.begin() + 1, stroke.end());
    return {};
  }

  Stroke take() { return std::move(path_); }

 private:
  /// A line to an end that is not in the middle of a cell may touch an obstacle that the planner, which knows cells,
  /// does not see. Then the way leads over the middles of the cells of both ends.
  Expected<void, Error> add_way(Point from, Point to) {
    const Query direct{{from.x, from.y, 0}, {Goal(to)}};
    const Query over_middles = Query::between(cell_at(from), cell_at(to));
    for (const Query& query : {direct, over_middles}) {
      auto way = way_of(query);
      if (!way) return Unexpected<Error>(std::move(way.error()));
      way->insert(way->begin(), from);
      way->push_back(to);
      if (!is_free(*way)) continue;
      for (const Point point : *way) {
        if (path_.back() != point) path_.push_back(point);
      }
      return {};
    }
    return failure(Status::unreachable, "no free way between two strokes of a coverage");
  }

  Expected<Stroke, Error> way_of(Query query) {
    query.limits = deadline_.left();
    const Status status = planner_->plan(query, plan_);
    if (status != Status::found) {
      return failure(status,
                     "no way between two strokes of a coverage: " + std::string(describe(status)));
    }
    if (plan_.path.cells().empty()) return plan_.path.points();
    const auto taut = string_pulled(plan_.path, area_.space(), Adjacency::edges, deadline_);
    if (!taut) return Unexpected<Error>(taut.error());
    return taut->points();
  }

  /// The corners of a way may lie on the border of a cell in whose middle the robot does not fit.
  bool is_free(const Stroke& way) const {
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (!disc_fits_along(area_.space(), Line{way[i - 1], way[i]})) return false;
    }
    return true;
  }

  const CoverageArea& area_;
  std::unique_ptr<Planner> planner_;
  const Deadline& deadline_;
  Plan plan_;
  Stroke path_;
};

}  // namespace

Expected<Stroke, Error> joined(const CoverageArea& area, std::span<const Stroke> strokes,
                               std::optional<Point> start, std::optional<Point> end,
                               const Deadline& deadline) {
  const bool uniform = area.space().uniform_terrain();
  auto planner = make_planner(uniform ? "any_angle" : "astar", area.space());
  if (!planner) return Unexpected<Error>(planner.error());
  Joiner joiner(area, std::move(*planner), deadline);
  if (start) {
    if (const auto there = joiner.go_to(*start); !there) return Unexpected<Error>(there.error());
  }
  for (const Stroke& stroke : strokes) {
    const auto there = joiner.drive(stroke);
    // What cannot be reached along free lines, by a hair's breadth, is left out.
    if (!there && there.error().status != Status::unreachable) {
      return Unexpected<Error>(there.error());
    }
  }
  if (end) {
    if (const auto there = joiner.go_to(*end); !there) return Unexpected<Error>(there.error());
  }
  return joiner.take();
}

}  // namespace wend
