#include "wend/explore/explorer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "wend/explore/visible_cells.hpp"
#include "wend/planner/rest_of_path.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

constexpr double kRounding = 1e-9;  // of sums of costs

Expected<GridMap, Error> first_belief(const GridMap& truth, const std::optional<GridMap>& known) {
  if (!known) {
    return make_grid_map(Grid<CellState>(truth.width(), truth.height(), CellState::unknown),
                         truth.frame());
  }
  if (known->width() != truth.width() || known->height() != truth.height()) {
    return failure(Status::invalid_option,
                   "the known map has " + std::to_string(known->width()) + " x " +
                       std::to_string(known->height()) + " cells, the true one " +
                       std::to_string(truth.width()) + " x " + std::to_string(truth.height()),
                   "known");
  }
  return *known;
}

/// Which options are valid does not depend on the map, so the smallest one tells before the drive begins.
std::optional<Error> fault_of_planner_options(const PlannerSpec& spec) {
  const auto map = make_grid_map(Grid<CellState>(1, 1, CellState::free), Frame{});
  if (!map) return map.error();
  const auto space = make_free_space(*map, {});
  if (!space) return space.error();
  const auto made = make_planner(spec.name, *space, spec.options);
  if (made || made.error().status != Status::invalid_option) return std::nullopt;
  return made.error();
}

std::optional<Error> fault_of_options(const ExplorerOptions& options) {
  if (!(options.sensor_range >= 1) || !std::isfinite(options.sensor_range)) {
    return Error{Status::invalid_option, "the range of the sensor must be at least 1 cell",
                 "sensor_range"};
  }
  if (!(options.keep >= 0)) {
    return Error{Status::invalid_option, "keep must be at least 0", "keep"};
  }
  const PlannerInfo* info = planners().find(options.planner.name);
  if (info == nullptr) {
    return Error{Status::invalid_option, planners().unknown("planner", options.planner.name),
                 "planner"};
  }
  if (info->capabilities.headings || info->capabilities.any_angle) {
    return Error{Status::invalid_option,
                 "an explorer steps from cell to cell, which " + info->name + " does not",
                 "planner"};
  }
  return fault_of_planner_options(options.planner);
}

}  // namespace

struct Explorer::State {
  State(FreeSpace true_space, FreeSpace first_space, Cell start, Cell end, ExplorerOptions chosen)
      : options(std::move(chosen)),
        truth(std::move(true_space)),
        believed(std::move(first_space)),
        cell(start),
        goal(end),
        driven{start} {
    if (!options.clock) options.clock = steady_seconds;
  }

  std::optional<Status> step();
  bool look();
  void feel(Cell next);
  bool learn(const std::vector<Cell>& cells);
  bool path_holds();
  void keep(std::vector<Cell> rest);
  std::optional<Status> plan();
  std::optional<Status> end_with(Error error);

  ExplorerOptions options;
  FreeSpace truth;
  FreeSpace believed;
  Cell cell;
  Cell goal;
  std::vector<Cell> driven;
  std::unique_ptr<Planner> planner;
  GridMoves moves;  // of the planner
  bool released = false;
  SpaceChange pending;  // since the planner was last told
  Plan found;
  std::size_t at = 0;    // on the path
  double rest_cost = 0;  // of what is ahead, as planned
  std::vector<Cell> seen;
  MapEdit edit;
  bool planned = false;
  bool must_plan = true;
  ExplorationTotals totals;
  std::optional<Status> end;
  PlanFailure why;
};

/// Puts cells on the believed map as they truly are. Is one of them blocked, free or dear otherwise than it
/// was believed?
bool Explorer::State::learn(const std::vector<Cell>& cells) {
  const GridMap& map = believed.map();
  bool surprised = false;
  MapEdit found_out;
  for (const Cell seen_cell : cells) {
    const bool blocked = truth.obstacles().blocked()[seen_cell];
    const CellState state = blocked ? CellState::occupied : CellState::free;
    const double terrain = truth.map().terrain(seen_cell);
    const bool same_terrain = map.terrain(seen_cell) == terrain;
    if (map.state(seen_cell) == state && same_terrain) continue;
    surprised = surprised || blocked != believed.obstacles().blocked()[seen_cell] || !same_terrain;
    CellEdit each{seen_cell, state};
    if (!same_terrain) each.terrain = terrain;
    found_out.cells.push_back(each);
  }
  if (found_out.cells.empty()) return false;
  std::ranges::sort(found_out.cells, {},
                    [](const CellEdit& each) { return std::pair(each.cell.y, each.cell.x); });
  const auto same = std::ranges::unique(found_out.cells, {}, &CellEdit::cell);
  found_out.cells.erase(same.begin(), same.end());
  totals.seen += found_out.cells.size();
  if (planner != nullptr && !released) planner->release();
  released = true;
  if (auto change = believed.edit(found_out)) {
    pending.boxes.insert(pending.boxes.end(), change->boxes.begin(), change->boxes.end());
    pending.everything = pending.everything || change->everything;
  }
  edit.cells.insert(edit.cells.end(), found_out.cells.begin(), found_out.cells.end());
  return surprised;
}

bool Explorer::State::look() {
  seen.clear();
  append_visible_cells(truth.obstacles(), centre_of(cell), options.sensor_range, seen);
  return learn(seen);
}

/// The robot touches something that it has not seen: all that its shape could touch there becomes known.
void Explorer::State::feel(Cell next) {
  const double per_cell = truth.map().frame().resolution;
  const int reach =
      static_cast<int>(std::ceil(truth.footprint().circumscribed_radius() / per_cell)) + 2;
  seen.clear();
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const Cell near{next.x + dx, next.y + dy};
      if (truth.contains(near)) seen.push_back(near);
    }
  }
  learn(seen);
}

/// Is every step ahead legal as the robot knows the map now, and no dearer than planned?
bool Explorer::State::path_holds() {
  const auto ahead = found.path.cells().subspan(at);
  const auto cost = check_grid_path(believed, moves, ahead);
  return cost && *cost <= rest_cost * (1 + kRounding);
}

/// Goes on along the rest of the last path, if it is legal, unless the new one is much cheaper.
void Explorer::State::keep(std::vector<Cell> rest) {
  const auto cost = check_grid_path(believed, moves, rest);
  if (rest.empty() || !cost || is_worth_changing_to(found.cost, *cost, options.keep)) return;
  found.path = Path(std::move(rest));
  found.cost = *cost;
}

std::optional<Status> Explorer::State::end_with(Error error) {
  why = {std::move(error), {}};
  return end = why.status;
}

std::optional<Status> Explorer::State::plan() {
  const double begun = options.clock();
  const bool first = planner == nullptr;
  if (first) {
    auto made = make_planner(options.planner.name, believed, options.planner.options);
    if (!made) return end_with(std::move(made.error()));
    planner = *std::move(made);
    moves = planner->grid_moves().value_or(GridMoves{});
  } else if (released) {
    if (auto updated = planner->update(believed, pending); !updated) {
      return end_with(std::move(updated.error()));
    }
  }
  released = false;
  pending = {};
  std::vector<Cell> rest;
  if (!first) {
    const auto ahead = found.path.cells().subspan(at);
    rest.assign(ahead.begin(), ahead.end());
  }
  Query query = Query::between(cell, goal);
  query.limits = options.limits;
  const Status status = planner->plan(query, found);
  const double seconds = options.clock() - begun;
  planned = true;
  ++totals.replans;
  totals.planning_seconds += seconds;
  totals.expanded += found.metrics.expanded;
  if (first) {
    totals.first_seconds = seconds;
  } else {
    totals.worst_seconds = std::max(totals.worst_seconds, seconds);
  }
  if (status != Status::found) {
    why = {{status, std::string(describe(status))}, found.metrics, planner->failure(query, status)};
    return end = status;
  }
  keep(std::move(rest));
  at = 0;
  rest_cost = grid_path_cost(believed, found.path.cells());
  must_plan = false;
  return std::nullopt;
}

std::optional<Status> Explorer::State::step() {
  if (end) return end;
  planned = false;
  edit.cells.clear();
  const bool surprised = look();
  if (planner == nullptr || must_plan ||
      (surprised && (options.when == ReplanWhen::discovery || !path_holds()))) {
    if (auto ended = plan()) return ended;
  }
  const auto cells = found.path.cells();
  if (cell == goal) return end = Status::found;
  const Cell next = cells[at + 1];
  const std::array ends{cell, next};
  if (!check_grid_path(truth, moves, ends)) {
    feel(next);
    must_plan = true;
    return std::nullopt;
  }
  rest_cost -= grid_path_cost(believed, ends);
  ++at;
  cell = next;
  driven.push_back(cell);
  return std::nullopt;
}

Expected<Explorer, Error> Explorer::make(const GridMap& truth, Cell start, Cell goal,
                                         const ExplorerOptions& options) {
  if (auto fault = fault_of_options(options)) return Unexpected<Error>(*std::move(fault));
  auto true_space = make_free_space(truth, options.robot);
  if (!true_space) return Unexpected<Error>(std::move(true_space.error()));
  if (!true_space->contains(start)) {
    return wend::failure(Status::start_outside, "the start is outside the map", "start");
  }
  if (!true_space->contains(goal)) {
    return wend::failure(Status::goal_outside, "the goal is outside the map", "goal");
  }
  if (const auto blocked = true_space->why_blocked(start)) {
    return wend::failure(Status::start_blocked, "the start is " + std::string(describe(*blocked)),
                         "start");
  }
  auto belief = first_belief(truth, options.known);
  if (!belief) return Unexpected<Error>(std::move(belief.error()));
  FreeSpaceOptions robot = options.robot;
  robot.unknown = UnknownPolicy::free;
  auto believed = make_free_space(*belief, robot);
  if (!believed) return Unexpected<Error>(std::move(believed.error()));
  return Explorer(
      std::make_unique<State>(*std::move(true_space), *std::move(believed), start, goal, options));
}

Explorer::Explorer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Explorer::Explorer(Explorer&&) noexcept = default;
Explorer& Explorer::operator=(Explorer&&) noexcept = default;
Explorer::~Explorer() = default;

std::optional<Status> Explorer::step() { return state_->step(); }
const PlanFailure& Explorer::failure() const { return state_->why; }
const FreeSpace& Explorer::believed() const { return state_->believed; }
const FreeSpace& Explorer::truth() const { return state_->truth; }
Cell Explorer::cell() const { return state_->cell; }
Cell Explorer::goal() const { return state_->goal; }
const std::vector<Cell>& Explorer::driven() const { return state_->driven; }
std::span<const Cell> Explorer::ahead() const {
  const auto cells = state_->found.path.cells();
  return cells.empty() ? cells : cells.subspan(state_->at);
}
const MapEdit& Explorer::last_edit() const { return state_->edit; }
bool Explorer::planned() const { return state_->planned; }
const ExplorationTotals& Explorer::totals() const { return state_->totals; }
double Explorer::driven_cost() const { return grid_path_cost(state_->truth, state_->driven); }

}  // namespace wend
