// Planners on cells against the reference.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "conformance/answer.hpp"
#include "conformance/checks.hpp"
#include "wend/base/random.hpp"

namespace wend::test {
namespace {

constexpr double kRelative = 1e-9;

/// What an optimal cost may exceed the optimum by, relative to it.
double slack_on(const FreeSpace& space) {
  return space.uniform_terrain() ? kRelative : kRelativeOfCosts;
}
constexpr std::uint64_t kFewMaps = 100;  // on fewer, chance decides how many paths there are

/// Where a path over waypoints may end in a cell: at a goal's own point, or at the centre.
Point end_in(Cell cell, const TestQuery& query, std::span<const Point> waypoints) {
  const auto ends_there = [&](const TestGoal& goal) { return goal.point == waypoints.back(); };
  return std::ranges::any_of(query.goals, ends_there) ? waypoints.back() : centre_of(cell);
}

/// Checks a path by itself: valid step by step, with the cost that it claims.
void hold_to_its_path(Examination& examination, const Plan& plan, const Reference& reference,
                      const GridMap& map, const TestQuery& query) {
  const PlannerInfo& info = examination.info();
  if (plan.path.empty()) return examination.violate("a path of cells", "an empty one");
  const std::vector<Cell> ends = query.ends(map);
  const Cell last = cell_at(plan.path.points().back());
  if (std::ranges::find(ends, last) == ends.end()) {
    examination.violate("a path to a goal", fmt::format("one to ({},{})", last.x, last.y));
  }
  const auto cells = plan.path.cells();
  const auto waypoints = plan.path.waypoints();
  const std::string fault =
      !info.capabilities.any_angle ? reference.fault(cells, query.start, last)
      : waypoints.empty()
          ? reference.any_angle_fault(cells, query.start, last)
          : reference.waypoint_fault(waypoints, query.start, end_in(last, query, waypoints));
  if (!fault.empty()) examination.violate("a legal path", fault);
  const double cost = !info.capabilities.any_angle ? reference.cost_of(cells)
                      : waypoints.empty()          ? reference.any_angle_cost_of(cells)
                                                   : reference.length_of(waypoints);
  if (!(std::abs(plan.cost - cost) <= kRelative * std::max(1.0, cost))) {
    examination.violate(fmt::format("cost {}, that of its path", cost),
                        fmt::format("cost {}", plan.cost));
  }
  if (info.capabilities.resumes) return;  // it did some of the work before
  const SearchMetrics& metrics = plan.metrics;
  const bool repeats =
      info.capabilities.anytime || (info.capabilities.leaps && !reference.uniform());
  if ((!repeats && metrics.generated < metrics.expanded) ||
      (!jumps_on(reference.uniform(), info.capabilities) && metrics.expanded < plan.path.size())) {
    examination.violate(
        fmt::format("every of {} cells expanded, and generated before", plan.path.size()),
        fmt::format("{} generated, {} expanded", metrics.generated, metrics.expanded));
  }
}

/// The length of the shortest path into an end: to its centre, if it is within a goal's tolerance, or to the points of
/// goals.
double length_into(Cell end, double to_centre, const Visibility& visibility,
                   const TestQuery& query) {
  double shortest = kInfinite;
  for (const TestGoal& goal : query.goals) {
    const bool within = distance(goal.point, centre_of(end)) <= goal.tolerance + Goal::kRounding;
    const bool has_point = cell_at(goal.point) == end;
    if (goal.tolerance > 0 && within) shortest = std::min(shortest, to_centre);
    const auto point = Visibility::at(goal.point);
    if (!has_point || !point || to_centre == kInfinite) continue;
    shortest = std::min(shortest, visibility.length_between(query.start, *point));
  }
  return shortest;
}

/// Checks a path at any angle that claims to be the shortest. On small maps: all lines between corners are tried.
void hold_to_the_shortest(Examination& examination, const Plan& plan, const Reference& reference,
                          const GridMap& map, const TestQuery& query) {
  constexpr std::uint64_t kSmall = 80;  // cells
  if (!plan.optimal() || plan.path.waypoints().empty() || map.size() > kSmall) return;
  Visibility visibility = reference.visibility();
  visibility.join_corners();
  const std::vector<double> lengths = visibility.lengths_from(query.start);
  double to_centres = kInfinite;
  double to_points = kInfinite;  // in the cells of goals to these, in others to the centres
  for (const Cell end : query.ends(map)) {
    if (!map.contains(end)) continue;
    const double to_centre = lengths[visibility.number(end.x, end.y)];
    to_centres = std::min(to_centres, to_centre);
    to_points = std::min(to_points, length_into(end, to_centre, visibility, query));
  }
  const auto is_cost = [&plan](double length) {
    return std::abs(plan.cost - length) <= kRelative * (1 + length);
  };
  if (is_cost(to_points) || is_cost(to_centres)) return;
  examination.violate(fmt::format("cost {}, that of the shortest path at any angle", to_points),
                      fmt::format("cost {}, bound {}", plan.cost, plan.bound));
}

/// How far the path ends from the centre of its last cell, to which the truth leads.
double beside_the_centre(const Plan& plan) {
  if (plan.path.empty()) return 0;
  const Point end = plan.path.points().back();
  return distance(end, centre_of(cell_at(end)));
}

/// Checks a plan against what its planner guarantees.
void hold_to_its_guarantee(Examination& examination, const Plan& plan, const Truth& truth,
                           double slack) {
  const PlannerInfo& info = examination.info();
  const auto cost_came = fmt::format("cost {}, bound {}", plan.cost, plan.bound);
  // Lines may be shorter than steps; that they are free has been checked.
  if (!info.capabilities.any_angle && !(plan.cost >= truth.cost * (1 - kRelative))) {
    examination.violate(fmt::format("a cost of at least {}", truth.cost), cost_came);
  }
  if (!(plan.bound >= 1)) examination.violate("a bound of at least 1", cost_came);
  const double most = plan.bound * (truth.cost + beside_the_centre(plan));
  if (plan.bound < Plan::kNoBound && !(plan.cost <= most * (1 + slack))) {
    examination.violate(fmt::format("at most bound times {}", truth.cost), cost_came);
  }
  const auto steps = static_cast<double>(plan.path.size()) - 1;
  if (info.guarantee == Guarantee::fewest_steps && steps != truth.steps) {
    examination.violate(fmt::format("{} steps", truth.steps), fmt::format("{} steps", steps));
  }
  if (info.guarantee == Guarantee::optimal && !plan.optimal()) {
    examination.violate("bound 1, as it declares to be optimal", cost_came);
  }
}

void hold_to_its_failure(Examination& examination, const Answer& answer, const Truth& truth) {
  if (const auto leftover = leftover_of(answer.plan); !leftover.empty()) {
    examination.violate("a failure without a path, at infinite cost", leftover);
  }
  if (examination.info().guarantee == Guarantee::none && answer.status == Status::step_limit)
    return;
  if (std::ranges::find(truth.failures, answer.status) != truth.failures.end()) return;
  const std::string expected = truth.failures.empty()
                                   ? fmt::format("a path of cost {}", truth.cost)
                                   : std::string(to_string(truth.failures.front()));
  examination.violate(expected, std::string(to_string(answer.status)));
}

void hold_to_the_truth(Examination& examination, Planner& planner, const Reference& reference,
                       const GridMap& map, const TestQuery& query) {
  examination.ask(query.query());
  const Answer answer = answer_of(planner, query.query());
  const Truth truth = truth_of(reference, map, query);
  if (answer.status != Status::found) return hold_to_its_failure(examination, answer, truth);
  examination.count_found();
  if (!truth.failures.empty()) {
    return examination.violate(std::string(to_string(truth.failures.front())), text_of(answer));
  }
  hold_to_its_path(examination, answer.plan, reference, map, query);
  hold_to_its_guarantee(examination, answer.plan, truth, slack_on(planner.free_space()));
  hold_to_the_shortest(examination, answer.plan, reference, map, query);
}

/// The map with its rows in the opposite order.
GridMap mirrored(const GridMap& map) {
  const int last = map.height() - 1;
  Grid<CellState> states(map.width(), map.height());
  Grid<double> terrain(map.width(), map.height());
  for (int y = 0; y <= last; ++y) {
    for (int x = 0; x < map.width(); ++x) {
      states[{x, y}] = map.state({x, last - y});
      terrain[{x, y}] = map.terrain({x, last - y});
    }
  }
  return *make_grid_map(states, map.frame(), terrain);
}

/// An order of the page, such as "up first", is another one in the grid when y points the other way.
void use_no_order_of_the_page(OptionValues& options) {
  std::erase_if(options, [](const auto& option) {
    return option.first == "neighbour_order" || option.first == "ties";
  });
}

}  // namespace

void examine_cell_answers(Examination& examination, std::uint64_t seed) {
  const Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  const Reference reference = reference_for(trial, examination.info());
  Random random(seed);
  for (int i = 0; i < 4; ++i) {
    hold_to_the_truth(examination, *planner, reference, trial.map,
                      random_test_query(random, trial.map));
  }
}

void conclude_answers(Examination& examination) {
  const CheckReport& report = examination.report();
  const PlannerInfo& info = examination.info();
  // Options can make a walk short, or motions longer than the maps.
  const bool may_find_few = examination.fixed_options() &&
                            (info.guarantee == Guarantee::none || info.capabilities.headings);
  if (report.maps < kFewMaps || may_find_few) return;
  // Most random queries of a car have no answer: a yard is small.
  const std::uint64_t enough = info.capabilities.headings ? report.maps / 4 : report.maps / 2;
  if (report.found > enough) return;
  examination.violate(fmt::format("more than {} paths on {} maps", enough, report.maps),
                      fmt::format("{}: too few to say anything", report.found));
}

/// A map of 3 x 3 cells, from the middle and from a corner to everywhere.
void examine_nine_cells(Examination& examination, std::uint64_t bits) {
  Grid<CellState> states(3, 3, CellState::free);
  for (int i = 0; i < 9; ++i) {
    if (((bits >> i) & 1U) != 0) states[{i % 3, i / 3}] = CellState::occupied;
  }
  Random random(bits);
  const auto& fixed = examination.fixed_options();
  const Trial trial{*make_grid_map(states),
                    {},
                    fixed ? *fixed : random_options(random, examination.info().options)};
  examination.on(trial, bits);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  const Reference reference = reference_for(trial, examination.info());
  for (int i = 0; i < 18; ++i) {
    const TestQuery query{i < 9 ? Cell{1, 1} : Cell{0, 0}, {Cell{i % 3, i / 3 % 3}}};
    hold_to_the_truth(examination, *planner, reference, trial.map, query);
  }
}

void examine_mirrored(Examination& examination, std::uint64_t seed) {
  const Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  const auto other = examination.planner_for({mirrored(trial.map), trial.robot, trial.options});
  if (planner == nullptr || other == nullptr) return;
  const auto mirrored_cell = [&](Cell cell) {
    return Cell{cell.x, trial.map.height() - 1 - cell.y};
  };
  Random random(seed);
  const TestQuery query = random_test_query(random, trial.map);
  TestQuery mirrored_query{mirrored_cell(query.start), {}};
  for (TestGoal goal : query.goals) {
    goal.point.y = trial.map.height() - goal.point.y;
    mirrored_query.goals.push_back(goal);
  }
  examination.ask(query.query());
  const Answer expected = answer_of(*planner, query.query());
  if (expected.status != Status::found || !expected.plan.optimal()) return;
  examination.count_found();
  const Answer answer = answer_of(*other, mirrored_query.query());
  if (answer.status == Status::found && std::abs(answer.plan.cost - expected.plan.cost) <=
                                            slack_on(planner->free_space()) * expected.plan.cost) {
    return;
  }
  examination.violate(text_of(expected), "mirrored: " + text_of(answer));
}

void examine_y_up(Examination& examination, std::uint64_t seed) {
  Trial trial = examination.random_trial(seed);
  use_no_order_of_the_page(trial.options);
  examination.on(trial, seed);
  Frame frame = trial.map.frame();
  frame.y_up = !frame.y_up;
  const auto planner = examination.planner_for(trial);
  const auto other =
      examination.planner_for({in_frame(trial.map, frame), trial.robot, trial.options});
  if (planner == nullptr || other == nullptr) return;
  Random random(seed);
  const Query query = random_test_query(random, trial.map).query();
  examination.ask(query);
  const Answer expected = answer_of(*planner, query);
  const Answer answer = answer_of(*other, query);
  if (!(answer == expected)) {
    examination.violate(text_of(expected), "with y the other way: " + text_of(answer));
  }
}

void examine_start_is_goal(Examination& examination, std::uint64_t seed) {
  const Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  Random random(seed);
  const Cell cell = random_cell(random, trial.map.width(), trial.map.height());
  const Query query = Query::between(cell, cell);
  examination.ask(query);
  const Answer answer = answer_of(*planner, query);
  if (!reference_for(trial, examination.info()).passable(cell)) {
    if (answer.status != Status::start_blocked) {
      examination.violate("start_blocked", text_of(answer));
    }
    return;
  }
  const std::vector<Point> points = answer.plan.path.points();
  const bool is_there = answer.status == Status::found && points.size() == 1 &&
                        points.front() == centre_of(cell) && answer.plan.cost == 0;
  if (!is_there) examination.violate("a path of that cell, at cost 0", text_of(answer));
  if (!(answer.plan.metrics == SearchMetrics{1, 1, 1})) {
    examination.violate("1 generated, 1 expanded, frontier 1", text_of(answer));
  }
}

}  // namespace wend::test
