#include "lab/wasm/lab.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lab/wasm/answers.hpp"
#include "lab/wasm/cells.hpp"
#include "lab/wasm/drawn_points.hpp"
#include "lab/wasm/field_text.hpp"
#include "lab/wasm/json.hpp"
#include "wend/generate/generators.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/smoothing/smoother.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/session/request_fields.hpp"

namespace wend::lab {
namespace {

constexpr std::size_t kMostCellsOfIndex = 40'000;

/// One entry of a list: "astar:weight=2".
Expected<OptionSpec, Error> spec_of(std::string_view text, std::string_view kind,
                                    const std::vector<std::string>& names) {
  auto specs = parse_option_specs(text, kind, names);
  if (!specs) return Unexpected<Error>(specs.error());
  return std::move(specs->front());
}

/// Where the states of a planner lie; nothing is made of a planner on cells, whose making may take long.
PlaceGrid places_in(Session& session, const PlannerSpec& spec) {
  const PlannerInfo* const info = planners().find(spec.name);
  const auto view = session.view();
  if (info == nullptr || !view) return {};
  return places_of(*info, view->space, spec.options);
}

}  // namespace

std::string Lab::load(std::span<const std::uint8_t> cells, int width, int height,
                      const Frame& frame) {
  auto map = map_of(cells, width, height, frame);
  return map ? take(*std::move(map)) : error_text(map.error());
}

std::string Lab::generate(std::string_view spec, int width, int height, std::uint64_t seed) {
  const auto parsed = spec_of(spec, "generator", generators().names());
  if (!parsed) return error_text(parsed.error());
  auto map = make_map(parsed->name, width, height, seed, parsed->options);
  return map ? take(*std::move(map)) : error_text(map.error());
}

std::string Lab::take(GridMap map) {
  cells_ = cells_of(map);
  width_ = map.width();
  height_ = map.height();
  frame_ = map.frame();
  session_.set_map(std::move(map));
  pyramid_.set_map(cells_, width_, height_);
  find_fits();
  forget_search();
  return map_text();
}

std::string Lab::map_text() const {
  return Json()
      .object()
      .field("width", width_)
      .field("height", height_)
      .field("resolution", frame_.resolution)
      .field("originX", frame_.origin.x)
      .field("originY", frame_.origin.y)
      .field("originYaw", frame_.origin.heading)
      .field("yUp", frame_.y_up)
      .field("metric", frame_.metric)
      .end_object()
      .text();
}

std::string Lab::edit(std::span<const CellByte> changes) {
  MapEdit edit;
  std::vector<std::uint32_t> changed;
  for (const auto& [index, byte] : changes) {
    if (index >= cells_.size()) {
      return error_text({Status::invalid_map, "a cell of the edit is not on the map"});
    }
    const auto width = static_cast<std::uint32_t>(width_);
    const auto value = static_cast<std::uint8_t>(byte);
    edit.cells.push_back({{static_cast<int>(index % width), static_cast<int>(index / width)},
                          state_of(value),
                          cost_of(value)});
    changed.push_back(index);
  }
  const auto change = session_.edit(edit);
  if (!change) return error_text(change.error());
  for (const auto& [index, byte] : changes) cells_[index] = static_cast<std::uint8_t>(byte);
  pyramid_.update(cells_, width_, height_, std::move(changed));
  find_fits(*change);
  forget_search();
  return map_text();
}

std::string Lab::set_robot(std::string_view footprint, std::string_view fields) {
  const auto parsed = parse_footprint(footprint);
  if (!parsed) return error_text(parsed.error());
  FreeSpaceOptions robot;
  if (const auto fault = put_fields(fields, "robot", robot_fields(), frame_.resolution, robot)) {
    return error_text(*fault);
  }
  robot.footprint = *parsed;
  session_.set_robot(robot);
  forget_search();
  const auto view = session_.view();
  if (!view && view.error().status == Status::invalid_option) return error_text(view.error());
  if (view) find_fits();
  return map_text();
}

void Lab::find_fits() {
  fits_.clear();
  const auto view = session_.view();
  if (!view || view->space.is_point()) return;
  fits_.reserve(cells_.size());
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) fits_.push_back(view->space.passable(Cell{x, y}) ? 1 : 0);
  }
}

void Lab::find_fits(const SpaceChange& change) {
  const auto view = session_.view();
  if (change.everything || fits_.empty() || !view) return find_fits();
  for (const CellBox& box : change.boxes) {
    for (int y = box.begin.y; y < box.end.y; ++y) {
      for (int x = box.begin.x; x < box.end.x; ++x) {
        fits_[static_cast<std::size_t>(y * width_ + x)] = view->space.passable(Cell{x, y}) ? 1 : 0;
      }
    }
  }
}

void Lab::forget_search() {
  replay_.begin(0, 0, {});
  pyramid_.forget_steps();
  points_.clear();
  solutions_.clear();
  path_.reset();
  escape_ = 0;
  values_ = {};
  value_of_cell_.clear();
}

std::string Lab::plan(const Task& task) {
  auto spec = spec_of(task.planner, "planner", planners().names());
  if (!spec) return error_text(spec.error());
  moves_ = {};
  PlanRequest request;
  request.start = frame_.to_metres(task.start);
  const MapPose goal = frame_.to_metres(task.goal);
  request.goals = {{.point = {goal.x, goal.y}}};
  if (task.headings) request.goals.front().heading = goal.heading;
  request.planner = task.record ? without_leaps(*std::move(spec)) : *std::move(spec);
  request.nearest_limit = std::numeric_limits<double>::infinity();  // the page shows where to
  if (const auto fault =
          put_fields(task.fields, "request", request_fields(), frame_.resolution, request)) {
    return error_text(*fault);
  }
  if (!task.smoother.empty()) {
    const auto smoother = spec_of(task.smoother, "smoother", smoothers().names());
    if (!smoother) return error_text(smoother.error());
    request.refinement.smoother = SmootherChoice{smoother->name, smoother->options};
  }
  forget_search();
  if (task.record) {
    replay_.begin(width_, height_, places_in(session_, request.planner));
    request.observer = &replay_;
    if (planners().find(request.planner.name)->capabilities.anytime) {
      request.on_solution = [this](const Plan& plan) {
        solutions_.push_back({plan.cost, plan.bound, replay_.steps(), plan.path, 0});
      };
    }
  }
  const auto answer = answer_to(request);
  goal_ = cell_at(task.goal.point());
  if (!answer) return failure_text(answer.error(), replay_.steps());
  if (answer->moves) moves_ = *answer->moves;
  path_ = answer->path();
  points_ = drawn_points(*path_);
  put_solutions();
  std::size_t lead_points = 0;
  if (answer->lead_out) {
    escape_ = request.escape;
    lead_points = drawn_points(lead_of(*path_, answer->lead_out->points)).size() / kNumbersOfPoint;
  }
  return plan_text(*answer, replay_.steps(), solutions_, lead_points);
}

Expected<PlanAnswer, RequestFailure> Lab::answer_to(const PlanRequest& request) {
  auto answer = session_.plan(request);
  if (answer) return answer;
  const Status status = answer.error().status;
  if (status != Status::index_missing && status != Status::index_mismatch) return answer;
  // No other thread could stop it: the page ends the worker, and maps of more cells take too long.
  if (cells_.size() > kMostCellsOfIndex) {
    answer.error().message = request.planner.name +
                             " needs an index, which the lab builds on maps of up to " +
                             std::to_string(kMostCellsOfIndex) + " cells";
    return answer;
  }
  const auto built = session_.build_index(request.planner.name);
  if (!built) {
    answer.error().message = built.error().message;
    return answer;
  }
  return session_.plan(request);
}

void Lab::put_solutions() {
  for (Solution& solution : solutions_) {
    const std::vector<double> its_points = drawn_points(solution.path);
    points_.insert(points_.end(), its_points.begin(), its_points.end());
    solution.points = its_points.size() / kNumbersOfPoint;
  }
}

std::string Lab::cell(Cell cell) {
  points_.clear();
  const auto view = session_.view();
  if (!view) return error_text(view.error());
  if (!view->space.contains(cell)) return error_text({Status::invalid_map, "not on the map"});
  const auto index = static_cast<std::uint32_t>(cell.y * width_ + cell.x);
  if (replay_.width() != 0) {
    std::uint32_t at = index;
    // A chain without end cannot be, but for a search that was stopped while it changed parents.
    for (std::size_t i = 0; i < cells_.size() && at != Replay::kNone; ++i) {
      points_.insert(points_.end(), {at % static_cast<std::uint32_t>(width_) + 0.5,
                                     at / static_cast<std::uint32_t>(width_) + 0.5, 0.0});
      at = replay_.parent()[at];
    }
  }
  return cell_text(view->space, cell, cells_[index], replay_);
}

void Lab::paint(const View& view, std::uint32_t step) {
  pixels_.resize(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  View drawn = view;
  drawn.y_up = frame_.y_up;
  values_.of_cells = value_of_cell_;
  pyramid_.take_steps(replay_, pyramid_.level_for(view.cells));
  const bool known = values_.of_search ? replay_.width() != 0 : true;
  lab::paint({.cells = cells_,
              .fits = fits_,
              .width = width_,
              .height = height_,
              .pyramid = pyramid_,
              .replay = replay_,
              .step = std::min(step, replay_.steps()),
              .values = known && !value_of_cell_.empty() ? values_ : Values{}},
             drawn, palette_, pixels_);
}

}  // namespace wend::lab
