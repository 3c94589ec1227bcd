// NaN, infinity, 1e300, 5e-324 and their like: every public function that takes a path, a pose, a length or a limit
// refuses them, or answers with finite numbers, within a bounded time. kDoors is the list; a public function that
// is added and takes numbers gets its line there.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tests/testing/absurd_numbers.hpp"
#include "tests/testing/share.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/no_drive.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/analysis/widest_path.hpp"
#include "wend/base/parse.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/explore/explorer.hpp"
#include "wend/explore/visible_cells.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/curve.hpp"
#include "wend/map/masked.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/map/own_costs.hpp"
#include "wend/path/dense_poses.hpp"
#include "wend/path/outline_poses.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/polyline.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/path/smoothing/curvature_smoother.hpp"
#include "wend/path/smoothing/drive_smoother.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/near_map.hpp"
#include "wend/robot/nearest_passable.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"
#include "wend/session/nearest_ends.hpp"
#include "wend/session/session.hpp"

namespace wend::test {
namespace {

constexpr double kMostSeconds = 10;  // of CPU time a call, also under sanitizers

// What is wrong with an answer; empty if nothing is.

std::string check(double number) { return std::isnan(number) ? "NaN" : ""; }

std::string check(const Pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading)
             ? ""
             : "a pose that is not finite";
}

std::string check(const std::vector<Pose>& poses) {
  for (const Pose& pose : poses) {
    if (const std::string wrong = check(pose); !wrong.empty()) return wrong;
  }
  return "";
}

std::string check(const Path& path) { return fault_of(path) ? fault_of(path)->message : ""; }

std::string check(const PathCollision& collision) {
  return check(Pose{collision.point.x, collision.point.y, collision.along});
}

std::string check(const PathMetrics& metrics) {
  for (const double number :
       {metrics.length, metrics.turning, metrics.smallest_turning_radius,
        metrics.rounded_turning_radius, metrics.smallest_clearance, metrics.mean_clearance}) {
    if (std::isnan(number)) return "a metric that is NaN";
  }
  return std::isfinite(metrics.length + metrics.turning) ? "" : "an infinite length";
}

std::string check(const Smoothed& smoothed) { return check(smoothed.path); }
std::string check(const Refined& refined) { return check(refined.path); }

std::string check(const TrajectoryState& state) {
  return std::isfinite(state.pose.x + state.pose.y + state.pose.heading + state.speed +
                       state.turn_rate)
             ? ""
             : "a state that is not finite";
}

std::string check(const Trajectory& trajectory) {
  if (!std::isfinite(trajectory.duration())) return "an infinite duration";
  for (const double share : {0.0, 0.3, 1.0}) {
    const std::string wrong = check(trajectory.at(share * trajectory.duration()));
    if (!wrong.empty()) return wrong;
  }
  return "";
}

std::string check(const Plan& plan) {
  return std::isfinite(plan.cost) ? check(plan.path) : "an infinite cost";
}
std::string check(const PlanAnswer& answer) { return check(answer.path()); }
std::string check(const MapPose& pose) { return check(Pose{pose.x, pose.y, pose.heading}); }
std::string check(const FreeSpace& space) { return space.width() > 0 ? "" : "an empty space"; }
std::string check(const GridMap& map) {
  return std::isfinite(map.frame().to_metres(Point{1, 1}).x) ? "" : "a map that is nowhere";
}

/// Or a refusal that says why.
template <class T, class E>
std::string check(const Expected<T, E>& answer) {
  if (answer) return check(*answer);
  return answer.error().message.empty() ? "a refusal without a reason" : "";
}
template <class T>
std::string check(const std::optional<T>& answer) {
  return answer ? check(*answer) : "";
}

/// A path with a number that fault_of() takes may be answered; one that it does not take must be refused.
template <class T>
std::string check_of(const Path& path, const FreeSpace& space, const Expected<T, Error>& answer) {
  if (answer && fault_of(path, space)) return "an answer to a path with a fault";
  return check(answer);
}

struct Door {
  std::string_view name;
  std::function<std::string(Random& random, const FreeSpace& space)> ask;
};

Path good_path(Random& random, const FreeSpace& space) {
  return random.chance(0.5) ? random_waypoint_path(random, space.width(), space.height())
                            : random_drive(random, space.width(), space.height());
}

/// A function of a path and a space.
template <class Function>
Door of_path(std::string_view name, const Function& function) {
  return {name, [function](Random& random, const FreeSpace& space) {
            const Path path = absurd_path(random, space);
            return check_of(path, space, function(path, space));
          }};
}

/// A function of a good path and an absurd number.
template <class Function>
Door of_number(std::string_view name, const Function& function) {
  return {name, [function](Random& random, const FreeSpace& space) {
            const Path path = good_path(random, space);
            return check(function(path, absurd_number(random), space));
          }};
}

Door of_smoother(std::string_view name, bool unsafe) {
  return of_path(name,
                 [name = std::string(name), unsafe](const Path& path, const FreeSpace& space) {
                   OptionValues options;
                   if (unsafe) options.emplace_back("unsafe", "true");
                   return (*make_smoother(name.substr(0, name.find(' ')), options))(path, space);
                 });
}

const std::vector<Door>& doors_of_paths() {
  static const std::vector<Door> doors{
      {"first_collision",
       [](Random& random, const FreeSpace& space) {
         const Path path = absurd_path(random, space);
         const auto collision = first_collision(path, space);
         if (!collision && fault_of(path, space)) return std::string("no collision");
         return check(collision);
       }},
      {"first_exit",
       [](Random& random, const FreeSpace& space) {
         const Path path = absurd_path(random, space);
         const auto exit = first_exit(path, space);
         if (!exit && fault_of(path, space)) return std::string("no exit");
         return check(exit);
       }},
      of_path("measure",
              [](const Path& path, const FreeSpace& space) { return measure(path, space); }),
      of_path("simplified",
              [](const Path& path, const FreeSpace& space) { return simplified(path, 1, space); }),
      of_path("string_pulled",
              [](const Path& path, const FreeSpace& space) { return string_pulled(path, space); }),
      of_path("resampled",
              [](const Path& path, const FreeSpace& space) { return resampled(path, 1, space); }),
      of_path("rounded_corners",
              [](const Path& path, const FreeSpace& space) {
                return rounded_corners(path, space, 0.2);
              }),
      {"without_collinear",
       [](Random& random, const FreeSpace& space) {
         return check(without_collinear(absurd_path(random, space)));
       }},
      of_path("refined: nothing",
              [](const Path& path, const FreeSpace& space) { return refined(path, space, {}); }),
      of_path("refined",
              [](const Path& path, const FreeSpace& space) {
                return refined(
                    path, space,
                    {.simplify = Simplification{}, .smoother = SmootherChoice{}, .spacing = 0.5});
              }),
      of_smoother("gradient", false),
      of_smoother("gradient unsafe", true),
      of_smoother("curvature", false),
      of_smoother("curvature unsafe", true),
      of_smoother("drive", false),
      of_path(
          "drive_roughness",
          [](const Path& path, const FreeSpace& space) { return drive_roughness(path, space); }),
      {"Trajectory::along",
       [](Random& random, const FreeSpace& space) {
         return check(Trajectory::along(absurd_path(random, space), space.map().frame()));
       }},
      of_path("timed_path",
              [](const Path& path, const FreeSpace& space) {
                return timed_path(path, space, Adjacency::edges, {});
              }),
      {"dense_poses",
       [](Random& random, const FreeSpace& space) {
         return check(dense_poses(absurd_path(random, space)));
       }},
      {"outline_poses", [](Random& random, const FreeSpace& space) {
         return check(outline_poses(absurd_path(random, space), 0.5));
       }}};
  return doors;
}

const std::vector<Door>& doors_of_numbers() {
  static const std::vector<Door> doors{
      of_number("measure: corner rounding",
                [](const Path& path, double number, const FreeSpace& space) {
                  return measure(path, space, number);
                }),
      of_number("simplified: tolerance",
                [](const Path& path, double number, const FreeSpace& space) {
                  return simplified(path, number, space);
                }),
      of_number("resampled: spacing",
                [](const Path& path, double number, const FreeSpace& space) {
                  return resampled(path, number, space);
                }),
      of_number("refined: spacing and tolerance",
                [](const Path& path, double number, const FreeSpace& space) {
                  return refined(path, space,
                                 {.simplify = Simplification{SimplifyBy::tolerance, number},
                                  .spacing = number});
                }),
      of_number("rounded_corners: window",
                [](const Path& path, double number, const FreeSpace& space) {
                  return rounded_corners(path, space, number);
                }),
      of_number("timed_path: window",
                [](const Path& path, double number, const FreeSpace& space) {
                  return timed_path(path, space, Adjacency::edges, {}, number);
                }),
      of_number("dense_poses: tolerance",
                [](const Path& path, double number, const FreeSpace&) {
                  return std::optional(dense_poses(path, number));
                }),
      of_number("outline_poses: radius",
                [](const Path& path, double number, const FreeSpace&) {
                  return std::optional(outline_poses(path, number));
                }),
      of_number("poses_along: spacing",
                [](const Path& path, double number, const FreeSpace&) {
                  return path.driven()
                             ? std::optional(poses_along(JoinedPoses(path.driven_poses()), number))
                             : std::optional(poses_along(polyline_of(path), number));
                }),
      of_number("polyline_of: tolerance",
                [](const Path& path, double number, const FreeSpace&) {
                  return std::optional(polyline_of(path, false, number).length());
                }),
      {"gradient: options",
       [](Random& random, const FreeSpace& space) {
         GradientOptions options{.max_sweeps = 20};
         spoil<3>(random, {&options.alpha, &options.beta, &options.epsilon});
         return check(smooth_by_gradient(good_path(random, space), space, options));
       }},
      {"drive: options",
       [](Random& random, const FreeSpace& space) {
         DriveSmootherOptions options{.max_sweeps = 2};
         spoil<6>(random, {&options.turning_radius, &options.alpha, &options.beta,
                           &options.clearance, &options.clearance_weight, &options.longer});
         return check(
             smooth_drive(random_drive(random, space.width(), space.height()), space, options));
       }},
      {"curvature: options",
       [](Random& random, const FreeSpace& space) {
         CurvatureOptions options{.max_sweeps = 20};
         spoil<3>(random, {&options.radius, &options.alpha, &options.beta});
         const auto smoother =
             make_smoother("curvature", {{"max_sweeps", "20"},
                                         {"radius", format_number(options.radius)},
                                         {"alpha", format_number(options.alpha)},
                                         {"beta", format_number(options.beta)}});
         if (!smoother) return check(Expected<double, Error>(Unexpected<Error>(smoother.error())));
         return check((*smoother)(good_path(random, space), space));
       }},
      {"Trajectory::along: limits",
       [](Random& random, const FreeSpace& space) {
         TrajectoryLimits limits;
         spoil<5>(random, {&limits.speed, &limits.turn_rate, &limits.acceleration,
                           &limits.turn_acceleration, &limits.lateral_acceleration});
         return check(Trajectory::along(good_path(random, space), space.map().frame(), limits));
       }},
      {"Trajectory::along: frame",
       [](Random& random, const FreeSpace& space) {
         Frame frame;
         spoil<4>(random,
                  {&frame.resolution, &frame.origin.x, &frame.origin.y, &frame.origin.heading});
         return check(Trajectory::along(good_path(random, space), frame));
       }},
      {"Trajectory::through",
       [](Random& random, const FreeSpace& space) {
         std::vector<TimedPose> poses;
         for (const Pose& pose : good_path(random, space).poses()) {
           poses.push_back({static_cast<double>(poses.size()), {pose.x, pose.y, pose.heading}});
         }
         TimedPose& wrong = poses[random.below(poses.size())];
         spoil<4>(random, {&wrong.time, &wrong.pose.x, &wrong.pose.y, &wrong.pose.heading});
         return check(Trajectory::through(poses));
       }},
      {"Trajectory: times and periods",
       [](Random& random, const FreeSpace& space) {
         const auto trajectory = Trajectory::along(good_path(random, space), space.map().frame());
         if (!trajectory) return check(trajectory);
         const double number = absurd_number(random);
         for (const TrajectoryState& state : trajectory->samples(number)) {
           if (const std::string wrong = check(state); !wrong.empty()) return wrong;
         }
         return check(trajectory->at(number));
       }},
      {"curves", [](Random& random, const FreeSpace& space) {
         const Pose from = random.chance(0.5) ? absurd_pose(random, space) : Pose{};
         const Pose to = absurd_pose(random, space);
         const double radius = random.chance(0.5) ? absurd_number(random) : 1;
         const Curve curve = cheapest_reeds_shepp(from, to, radius);
         return check(curve.cost) + check(cheapest_dubins(from, to, radius).cost);
       }}};
  return doors;
}

const std::vector<Door>& doors_of_poses() {
  static const std::vector<Door> doors{
      {"FreeSpace::fits",
       [](Random& random, const FreeSpace& space) {
         const Pose pose = absurd_pose(random, space);
         const bool fits = space.fits(pose);
         return std::string(fits && !near_map(space, pose.point()) ? "fits far off the map" : "");
       }},
      {"PlacedPolygon",
       [](Random& random, const FreeSpace& space) {
         if (space.outline() == nullptr) return std::string();
         const Pose pose = absurd_pose(random, space);
         const PlacedPolygon robot(*space.outline(), pose);
         if (!check(pose).empty() && !robot.overlaps({3, 3}))
           return std::string("overlaps nothing");
         return check(robot.distance_to({3, 3}));
       }},
      {"cell_under",
       [](Random& random, const FreeSpace& space) {
         const auto cell = cell_under(space, absurd_point(random, space));
         return std::string(cell && !space.contains(*cell) ? "a cell off the map" : "");
       }},
      {"Frame::cell_at",
       [](Random& random, const FreeSpace& space) {
         const Point point = absurd_point(random, space);
         space.map().frame().cell_at({point.x, point.y});
         return std::string();
       }},
      {"arc_clearance",
       [](Random& random, const FreeSpace& space) {
         Arc arc{{3, 3, 1}, 2, 0.5};
         spoil<5>(random,
                  {&arc.from.x, &arc.from.y, &arc.from.heading, &arc.length, &arc.curvature});
         return check(arc_clearance(space, arc));
       }},
      {"room_along",
       [](Random& random, const FreeSpace& space) {
         return check(room_along(space, {{1, 1}, absurd_point(random, space)})) +
                check(room_along(space, {absurd_point(random, space), {1, 1}}));
       }},
      {"way_clearance",
       [](Random& random, const FreeSpace& space) {
         return check(way_clearance(space, {1, 1}, absurd_cell(random, space)));
       }},
      {"nearest_pose",
       [](Random& random, const FreeSpace& space) {
         return check(nearest_pose(space, absurd_pose(random, space)));
       }},
      {"nearest_passable",
       [](Random& random, const FreeSpace& space) {
         const auto cell = nearest_passable(space, absurd_cell(random, space));
         return std::string(cell ? "" : "nothing is passable");
       }},
      {"nearest_ends",
       [](Random& random, const FreeSpace& space) {
         nearest_ends(space, absurd_cell(random, space), {1, 1}, Adjacency::edges);
         return std::string();
       }},
      {"explain_no_path, widest_path, component_of",
       [](Random& random, const FreeSpace& space) {
         const Cell cell = absurd_cell(random, space);
         const NoPath why = explain_no_path(space, {1, 1}, cell);
         const bool found = why.path_exists() || widest_path(space, cell, {1, 1}) ||
                            component_size(space, cell) > 0;
         return std::string(found ? "a way to nowhere" : "");
       }},
      {"explain_no_drive",
       [](Random& random, const FreeSpace& space) {
         Query query{{1.5, 1.5, 0}, {Goal(Pose{15.5, 6.5, 0})}};
         HybridAStarOptions options;
         Goal& goal = query.goals.front();
         spoil<7>(random, {&query.start.x, &query.start.heading, &goal.point.y, &*goal.heading,
                           &goal.tolerance, &goal.heading_tolerance, &options.turning_radius});
         const auto why = explain_no_drive(space, query, options, 50);
         return std::string(!why && why.error().message.empty() ? "no reason" : "");
       }},
      {"CostToGo",
       [](Random& random, const FreeSpace& space) {
         const std::array goals{absurd_cell(random, space)};
         if (CostToGo::make(space, goals)) return std::string("a goal off the map");
         const auto field = CostToGo::make(space, std::array{Cell{1, 1}});
         if (!field) return std::string();
         const Cell cell = absurd_cell(random, space);
         if (field->policy(cell)) return std::string("a way from nowhere");
         return check(field->cost(cell)) + check(field->path_from(cell));
       }},
      {"append_visible_cells",
       [](Random& random, const FreeSpace& space) {
         std::vector<Cell> cells;
         append_visible_cells(space.obstacles(), absurd_point(random, space), 5, cells);
         append_visible_cells(space.obstacles(), {1.5, 1.5}, absurd_number(random), cells);
         for (const Cell cell : cells) {
           if (!space.contains(cell)) return std::string("a cell off the map");
         }
         return std::string();
       }},
      {"Session",
       [](Random& random, const FreeSpace& space) {
         Session session(space.map(), space.options());
         const Pose at = absurd_pose(random, space);
         const MapPose pose{at.x, at.y, at.heading};
         session.why_no_path({1, 1}, pose.point());
         const auto field = session.cost_to_go(*session.view(), {absurd_cell(random, space)});
         if (field) return std::string("a field to nowhere");
         return check(session.nearest(pose));
       }},
      {"Session::plan", [](Random& random, const FreeSpace& space) {
         Session session(space.map(), space.options());
         const Frame& frame = space.map().frame();
         PlanRequest request{frame.to_metres(Pose{1.5, 1.5, 0}),
                             {{frame.to_metres(Point{15.5, 6.5}), 0.0}}};
         MapGoal& goal = request.goals.front();
         request.trajectory = TrajectoryLimits{};
         request.refinement.simplify = Simplification{SimplifyBy::tolerance, 0.5};
         request.refinement.spacing = 1;
         spoil<12>(random,
                   {&request.start.x, &request.start.y, &request.start.heading, &goal.point.x,
                    &goal.point.y, &*goal.heading, &goal.tolerance, &goal.heading_tolerance,
                    &request.corner_rounding, &request.limits.seconds,
                    &request.refinement.simplify->tolerance, &*request.refinement.spacing});
         return check(session.plan(request)) + check(session.replan(request));
       }}};
  return doors;
}

const std::vector<Door>& doors_of_robots_and_maps() {
  static const std::vector<Door> doors{
      {"make_free_space",
       [](Random& random, const FreeSpace& space) {
         double radius = 0.2;
         FreeSpaceOptions options;
         spoil<3>(random, {&radius, &options.clearance_distance, &options.clearance_cost});
         options.footprint = Footprint::disc(radius);
         return check(make_free_space(space.map(), options));
       }},
      {"Polygon::make, Footprint::polygon",
       [](Random& random, const FreeSpace&) {
         std::vector<Point> corners{{1, 1}, {1, -1}, {-1, 0}};
         Point& corner = corners[random.below(3)];
         spoil<2>(random, {&corner.x, &corner.y});
         const auto outline = Polygon::make(corners);
         if (!outline) return std::string(outline.error().message.empty() ? "no reason" : "");
         const auto footprint = Footprint::polygon(*outline);
         return footprint ? check(footprint->circumscribed_radius()) : std::string();
       }},
      {"MotionPrimitives",
       [](Random& random, const FreeSpace&) {
         const auto turning = MotionPrimitives::turning_circle(absurd_number(random));
         MotionPrimitives::Parts parts{
             0.1, {0, kPi / 2}, {{.by = {1, 0}, .poses = {{}, {1, 0, 0}}}}};
         Pose& pose = parts.primitives.front().poses[random.below(2)];
         spoil<6>(random, {&pose.x, &pose.y, &pose.heading, &parts.headings[0], &*parts.resolution,
                           &parts.primitives.front().cost_factor});
         const auto made = MotionPrimitives::make(std::move(parts));
         return std::string(!made && made.error().message.empty() ? "no reason" : "");
       }},
      {"make_grid_map: frame",
       [](Random& random, const FreeSpace&) {
         Frame frame;
         spoil<4>(random,
                  {&frame.resolution, &frame.origin.x, &frame.origin.y, &frame.origin.heading});
         return check(make_grid_map(Grid<CellState>(3, 2, CellState::free), frame));
       }},
      {"a map in an extreme frame",
       [](Random& random, const FreeSpace& space) {
         const Frame frame{.resolution = random.chance(0.5) ? 1e-9 : 1e9,
                           .origin = {random.chance(0.5) ? 1e3 : 0, 0, 0},
                           .metric = true};
         Grid<CellState> states(space.width(), space.height(), CellState::free);
         for (const Cell cell : every_cell(states)) states[cell] = space.map().state(cell);
         for (int y = 0; y < states.height(); ++y) states[{9, y}] = CellState::unknown;
         const auto map = make_grid_map(states, frame);
         if (!map) return check(map);
         Session session(*map, {.footprint = Footprint::disc(random.chance(0.5) ? 0.2 : 0)});
         return check(session.plan(
             {frame.to_metres(Pose{1.5, 1.5, 0}), {{frame.to_metres(Point{15.5, 6.5})}}}));
       }},
      {"terrain and edits",
       [](Random& random, const FreeSpace& space) {
         const double cost = absurd_number(random);
         const auto with_costs = with_terrain(space.map(), [&](Cell) { return cost; });
         FreeSpace edited = space;
         const Cell cell =
             random.chance(0.5) ? absurd_cell(random, space) : Cell{random.between(0, 9), 1};
         const auto change = edited.edit({.cells = {{cell, CellState::free, cost}}});
         if (!change && change.error().message.empty()) return std::string("no reason");
         return check(with_costs) + (with_costs ? check(make_free_space(*with_costs)) : "");
       }},
      {"map_from_occupancy, map_from_costmap, map_from_speed_mask",
       [](Random& random, const FreeSpace& space) {
         const std::vector<std::int8_t> values{0, 50, 100, -1};
         const std::vector<std::uint8_t> costs{0, 100, 254, 255};
         const Frame& frame = space.map().frame();
         SpeedScale scale{.base = 0, .multiplier = 1, .top_speed = 2.0};
         spoil<3>(random, {&scale.base, &scale.multiplier, &*scale.top_speed});
         const double factor = absurd_number(random);
         return check(map_from_occupancy(values, 2, 2, frame, {.cost_factor = factor})) +
                check(map_from_costmap(costs, 2, 2, frame, {.cost_factor = factor})) +
                check(map_from_speed_mask(values, 2, 2, frame, scale));
       }},
      {"masked",
       [](Random& random, const FreeSpace& space) {
         Frame frame = space.map().frame();
         spoil<4>(random,
                  {&frame.resolution, &frame.origin.x, &frame.origin.y, &frame.origin.heading});
         const auto mask = make_grid_map(Grid<CellState>(3, 2, CellState::occupied), frame);
         return mask ? check(masked(space.map(), *mask)) + check(masked(*mask, space.map()))
                     : check(mask);
       }},
      {"Explorer", [](Random& random, const FreeSpace& space) {
         const bool range = random.chance(0.5);
         const auto explorer = Explorer::make(
             space.map(), range ? Cell{1, 1} : absurd_cell(random, space), {15, 6},
             {.robot = space.options(), .sensor_range = range ? absurd_number(random) : 5});
         return std::string(!explorer && explorer.error().message.empty() ? "no reason" : "");
       }}};
  return doors;
}

class Doors : public testing::TestWithParam<const std::vector<Door>*> {};

TEST_P(Doors, RefuseAbsurdNumbersOrAnswerSoon) {
  for (const Door& door : *GetParam()) {
    Random random(7);
    for (int i = 0; i < share_of(200); ++i) {
      const FreeSpace space = any_space(random);
      const double began = thread_cpu_seconds();
      EXPECT_EQ(door.ask(random, space), "") << door.name << ", case " << i;
      ASSERT_LT(thread_cpu_seconds() - began, kMostSeconds) << door.name << ", case " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, Doors, testing::Values(&doors_of_paths()));
INSTANTIATE_TEST_SUITE_P(Numbers, Doors, testing::Values(&doors_of_numbers()));
INSTANTIATE_TEST_SUITE_P(Poses, Doors, testing::Values(&doors_of_poses()));
INSTANTIATE_TEST_SUITE_P(RobotsAndMaps, Doors, testing::Values(&doors_of_robots_and_maps()));

/// Every planner, with its default options, and every number of a query.
class PlannersAndAbsurdNumbers : public testing::TestWithParam<std::string> {};

TEST_P(PlannersAndAbsurdNumbers, RefuseQueriesOrAnswerSoon) {
  Random random(11);
  for (int i = 0; i < share_of(60); ++i) {
    const FreeSpace space = any_space(random);
    const auto planner = make_planner(GetParam(), space);
    if (!planner) continue;  // it needs an index, or another map
    Query query{{1.5, 1.5, 0}, {Goal(Pose{15.5, 6.5, 0})}};
    query.limits.expansions = 2000;
    Goal& goal = query.goals.front();
    spoil<9>(random,
             {&query.start.x, &query.start.y, &query.start.heading, &goal.point.x, &goal.point.y,
              &*goal.heading, &goal.tolerance, &goal.heading_tolerance, &query.limits.seconds});
    const double began = thread_cpu_seconds();
    EXPECT_EQ(check((*planner)->plan(query)), "") << i;
    if (const auto point = (*planner)->nearest_free(goal)) {
      EXPECT_TRUE(near_map(space, *point)) << i;
    }
    ASSERT_LT(thread_cpu_seconds() - began, kMostSeconds) << i;
  }
}

std::vector<std::string> names_of_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) names.push_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(, PlannersAndAbsurdNumbers, testing::ValuesIn(names_of_planners()),
                         [](const auto& name) { return name.param; });

/// As text, which is how front ends give options.
TEST(AbsurdOptions, OfPlannersSmoothersAndGeneratorsAreRefusedOrHarmless) {
  const FreeSpace space = open_space(20, 8);
  for (const std::string text : {"nan", "inf", "-inf", "1e300", "-1e300", "1e18", "5e-324"}) {
    const double began = thread_cpu_seconds();
    for (const PlannerInfo& info : planners()) {
      for (const OptionInfo& option : info.options) {
        if (option.kind != OptionKind::number && option.kind != OptionKind::integer) continue;
        const auto planner = make_planner(info.name, space, {{option.name, text}});
        if (!planner) continue;
        Query query{{1.5, 1.5, 0}, {Goal(Pose{15.5, 6.5, 0})}};
        query.limits.expansions = 2000;
        EXPECT_EQ(check((*planner)->plan(query)), "") << info.name << ' ' << option.name << text;
      }
    }
    for (const SmootherInfo& info : smoothers()) {
      for (const OptionInfo& option : info.options) {
        if (option.kind == OptionKind::flag) continue;
        const auto smoother = make_smoother(info.name, {{option.name, text}});
        if (smoother) (*smoother)(Path::along({{1, 1}, {9, 2}, {9, 6}}), space);
      }
    }
    for (const GeneratorInfo& info : generators()) {
      for (const OptionInfo& option : info.options) {
        if (option.kind == OptionKind::flag) continue;
        make_map(info.name, info.default_width, info.default_height, 1, {{option.name, text}});
      }
    }
    EXPECT_LT(thread_cpu_seconds() - began, 6 * kMostSeconds) << text;
  }
}

}  // namespace
}  // namespace wend::test
