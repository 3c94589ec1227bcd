#pragma once

// Session: a map, a robot, and warm planners; what every front end shares. It plans in metres, refines and
// times paths, explains why there is none, and finds the nearest free pose.
//
//   const auto map = wend::load_map("office.yaml");
//   wend::Session session(map->map, {.footprint = wend::Footprint::disc(0.2)});
//   const auto answer = session.plan({{1, 1, 0}, {{{15, 9}}}});
//   if (!answer) return report(answer.error().message);
//   for (const wend::MapPose& pose : answer->poses()) drive_to(pose);
//
// All threads may call everything. A plan is made on the map and for the robot of the moment when it
// began. Setting a map or a robot is O(1); the first call that needs the free space makes it, in O(cells)
// (a robot on obstacles that another robot had before shares their distance field).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/workers.hpp"
#include "wend/index/index_building.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/map_edit.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/explainer.hpp"
#include "wend/session/plan_request.hpp"
#include "wend/session/search_run.hpp"
#include "wend/session/warm_planners.hpp"

namespace wend {

/// What a session keeps, and what its messages say.
struct SessionOptions {
  std::size_t idle_planners = 2;  // that are kept warm
  Hints hints = {};               // for explanations
  Clock clock = {};               // measures PlanAnswer::search_seconds; null: the steady clock
};

class WEND_API Session {
 public:
  /// The map and the robot at one moment.
  struct View {
    FreeSpace space;        // the map with the robot
    std::string frame_id;   // as set with the map
    std::uint64_t version;  // grows with every map, edit and robot
  };

  /// A field of costs, and the work of this call.
  struct Field {
    std::shared_ptr<const CostToGo> costs;  // shared with the session; never null
    SearchMetrics metrics;                  // 0 if the field was kept
  };

  /// Without a map: everything fails with invalid_map until there is one.
  explicit Session(SessionOptions options = {});
  /// With a map and a robot. O(1): the first call that needs the free space makes it.
  explicit Session(GridMap map, FreeSpaceOptions robot = {}, SessionOptions options = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// `frame_id` is a name for the map's frame; the session only keeps it.
  void set_map(GridMap map, std::string frame_id = "map");

  /// Changes cells of the map. The free space is repaired around them, in place unless a view or a planner
  /// that is in use shares it, and planners that are kept are updated, not made again. Returns what may have
  /// changed. A planner with an index that no longer matches fails with index_mismatch from then on, until
  /// build_index() or set_index(). Fails with invalid_map if there is no map or the edit does not fit it (see
  /// fault_of()), and as view() and FreeSpace::edit() do; nothing changes then.
  Expected<SpaceChange, Error> edit(const MapEdit& edit, const Deadline& deadline = {});

  /// There is no map, for this reason.
  void clear_map(std::string why);

  /// Plans that begin later are for this robot. An invalid one makes them fail with invalid_option.
  void set_robot(FreeSpaceOptions robot);

  /// The map and the robot, as plans that begin now see them. Fails with invalid_map if there is no
  /// map, with invalid_option for an invalid robot. The free space is made if nobody has; if that is not done before the
  /// deadline, it fails with time_limit or cancelled, and the next call begins anew. (Who waits for another thread that
  /// makes it waits as long as that takes.)
  Expected<View, Error> view(const Deadline& deadline = {}) const;

  /// Plans. The message of a failure says where and why, and what would help; its status is that of the
  /// view, of making the planner, or of the query. The limit on time and the cancel flag of the request are of the
  /// whole call: they also end the making of the free space and of a planner, an explanation, and the refinement of the
  /// path. To have space and planner ready, call view() and planner() without a limit before.
  Expected<PlanAnswer, RequestFailure> plan(const PlanRequest& request);
  /// The same on a view of this session.
  Expected<PlanAnswer, RequestFailure> plan(const View& view, const PlanRequest& request);

  /// Begins the search of plan(), for who wants to step it, to see its open list, or to have the paths of an anytime
  /// planner one by one. Fails where there is nothing to search: as view() and making the planner do, or because the
  /// request is invalid.
  Expected<SearchRun, RequestFailure> begin(const PlanRequest& request);
  /// The same on a view of this session.
  Expected<SearchRun, RequestFailure> begin(const View& view, const PlanRequest& request);
  /// The same with a limit on time that the caller counts: for what was done before belongs to the same call.
  Expected<SearchRun, RequestFailure> begin(const View& view, const PlanRequest& request,
                                            const Deadline& deadline);

  /// Why plan() or replan() failed on a view, at length: the message that it would have had with
  /// PlanRequest::explain, as far as it is known before the deadline. O(cells log cells).
  std::string explain(const View& view, const PlanRequest& request, const PlanFailure& failure,
                      const Deadline& deadline = {});

  /// Plans like plan(), for a robot that drives while its map changes. What is left of the path that the last call
  /// answered, from the robot's place on, is answered again unless another path is cheaper by more than the share
  /// PlanRequest::keep: if it is free on the present map, is for the same planner and goals on a map with the same
  /// frame, and the robot is no farther from it than two cells, or 0.3 m if that is more. It is also answered if a
  /// limit ended the search, or a planner that is not complete found nothing. Its cost is that of the present map.
  ///
  /// Planners from cell to cell that are optimal and need no index, such as `astar`, are replaced by `replanner` with
  /// the same moves, which keeps what it found for the next call and repairs it after edits: nothing was expanded if
  /// the rest of the last path is still the cheapest. Planners that resume (Capabilities) do so themselves; all others
  /// plan anew.
  ///
  ///   auto answer = session.replan(request);
  ///   while (answer && !arrived()) {
  ///     request.start = drive_along(answer->poses());
  ///     if (session.edit(what_the_robot_sees())) answer = session.replan(request);
  ///   }
  Expected<PlanAnswer, RequestFailure> replan(const PlanRequest& request);
  /// The same on a view of this session. What was found before serves only the present view.
  Expected<PlanAnswer, RequestFailure> replan(const View& view, const PlanRequest& request);

  /// Plans each of the requests as plan() does, but with this planner: one for each worker, which share
  /// what they prepare. Fails as making the planner does.
  Expected<std::vector<Expected<PlanAnswer, RequestFailure>>, Error> plan_all(
      std::span<const PlanRequest> requests, const PlannerSpec& planner, Workers& workers);

  /// A planner for queries in grid coordinates, for what plan() and begin() do not do. Fails as make_planner() does.
  Expected<WarmPlanner, Error> planner(const PlannerSpec& spec, const Deadline& deadline = {});

  /// One for each thread. They share what they prepare.
  Expected<std::vector<WarmPlanner>, Error> planners(const PlannerSpec& spec, std::size_t count,
                                                     const Deadline& deadline = {});

  /// The nearest pose with the same heading at which the robot fits, in metres; `pose` itself if it does.
  /// unsupported_query if there is none.
  Expected<MapPose, Error> nearest(const MapPose& pose) const;

  /// Why no path joins start and goal, as data: see explain_no_path(). start_outside or goal_outside if
  /// one is not on the map.
  Expected<NoPath, Error> why_no_path(MapPoint start, MapPoint goal, GridMoves moves = {}) const;

  /// The costs to the nearest goal from everywhere, for a planner with these moves. The last field is
  /// kept: the same goals on the same map cost nothing. Fails as CostToGo::make() does.
  Expected<Field, PlanFailure> cost_to_go(const View& view, std::vector<Cell> goals,
                                          GridMoves moves = {}, const Limits& limits = {});

  /// Builds the index of a planner on the current view and uses it from now on. invalid_option if the
  /// planner has none.
  Expected<void, Error> build_index(std::string_view planner, const IndexBuilding& building = {});

  /// Uses an index that exists. Planners fail with index_mismatch if it is not that of the map.
  void set_index(std::string_view planner, IndexBytes index);

 private:
  struct State;

  Expected<PlanAnswer, RequestFailure> replan(const View& view, const PlanRequest& request,
                                              const Deadline& deadline);

  std::unique_ptr<State> state_;
};

}  // namespace wend
