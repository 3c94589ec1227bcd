#include "wend/tour/tour_path.hpp"

#include <string>
#include <utility>

#include "wend/base/deadline.hpp"

namespace wend {
namespace {

/// Adds what follows the first cell, waypoint or pose, which the path already has.
class JoinedLegs {
 public:
  void add(const Path& leg) {
    const std::size_t skipped = size() == 0 ? 0 : 1;
    over_cells_ = over_cells_ || leg.leads_over_cells();
    leg.visit([&](std::span<const Cell> cells) { append(cells_, cells, skipped); },
              [&](std::span<const Point> points) { append(points_, points, skipped); },
              [&](const JoinedPoses& joined) { append(poses_, joined.poses(), skipped); });
  }

  std::size_t size() const { return cells_.size() + points_.size() + poses_.size(); }

  Path take() {
    if (!poses_.empty()) return Path::through(std::move(poses_));
    if (points_.empty()) return Path(std::move(cells_));
    return over_cells_ ? Path::over_cells(std::move(points_)) : Path::along(std::move(points_));
  }

 private:
  template <class Joint>
  static void append(std::vector<Joint>& all, std::span<const Joint> more, std::size_t skipped) {
    all.insert(all.end(), more.begin() + static_cast<std::ptrdiff_t>(skipped), more.end());
  }

  std::vector<Cell> cells_;
  std::vector<Point> points_;
  std::vector<Pose> poses_;
  bool over_cells_ = false;
};

}  // namespace

Expected<TourPath, Error> tour_path(Session& session, const Session::View& view,
                                    std::span<const MapPose> stops, std::span<const int> order,
                                    bool closed, const StopCostOptions& options) {
  const Deadline deadline(options.limits);
  auto planner = session.planner(options.planner, deadline);
  if (!planner) return Unexpected<Error>(planner.error());
  const PlannerInfo* info = planners().find(options.planner.name);
  const bool headings = info != nullptr && info->capabilities.headings;
  const Frame& frame = view.space.map().frame();
  const auto stop = [&](int row) { return frame.to_grid(stops[static_cast<std::size_t>(row)]); };
  TourPath tour;
  JoinedLegs joined;
  Plan plan;
  const std::size_t legs = order.size() < 2 ? 0 : order.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < legs; ++i) {
    const int from = order[i];
    const int to = order[(i + 1) % order.size()];
    Query query{stop(from), {}, deadline.left()};
    query.goals.push_back(headings ? Goal(stop(to)) : Goal(stop(to).point()));
    const Status status = (*planner)->plan(query, plan);
    if (status != Status::found) {
      const std::string where = "leg " + std::to_string(i);
      return failure(status,
                     where + ", from stop " + std::to_string(from) + " to stop " +
                         std::to_string(to) + ": " + std::string(describe(status)),
                     where);
    }
    const std::size_t first = joined.size() == 0 ? 0 : joined.size() - 1;
    joined.add(plan.path);
    tour.legs.push_back({from, to, plan.cost, first, joined.size() - 1});
  }
  tour.path = joined.take();
  return tour;
}

}  // namespace wend
