#include "bench/comparison/comparison_run.hpp"

#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/explainer.hpp"
#include "wend/session/failure_text.hpp"
#include "wend/space/lattice/car_lattice.hpp"

namespace wend {
namespace {

/// Whole eighths of a turn come out as whole degrees.
double without_rounding(double degrees) {
  constexpr double kDigits = 1e6;
  return std::round(degrees * kDigits) / kDigits;
}

/// Could all planners answer the same queries?
bool have_same_states(std::span<const PlannerSpec> specs) {
  const PlannerInfo* first = nullptr;
  for (const PlannerSpec& spec : specs) {
    const PlannerInfo* const info = planners().find(spec.name);
    if (info == nullptr) continue;
    if (first == nullptr) first = info;
    if (!same_states(first->capabilities, info->capabilities)) return false;
  }
  return true;
}

}  // namespace

Expected<ComparisonRun, Error> ComparisonRun::make(const FreeSpace& space,
                                                   std::vector<PlannerSpec> specs,
                                                   const Clock& clock, const RepetitionRule& rule) {
  ComparisonRun run(space);
  if (!have_same_states(specs)) {
    return failure(Status::invalid_option,
                   "planners of different states, of cells or of poses, cannot be compared");
  }
  run.comparison_.frame = space.map().frame();
  if (const auto* info = specs.empty() ? nullptr : wend::planners().find(specs.front().name)) {
    run.comparison_.capabilities = info->capabilities;
    run.comparison_.cost_name = info->cost_name;
  }
  for (PlannerSpec& spec : specs) {
    const TimedPlanner& planner = run.planners_.emplace_back(space, spec, clock, rule);
    if (planner.error() && planner.error()->status == Status::invalid_option) {
      return failure(Status::invalid_option, spec.text + ": " + planner.error()->message);
    }
    run.specs_.push_back(std::move(spec));
  }
  return run;
}

void ComparisonRun::answer(const CellPair& cells, const Limits& limits) {
  Query query = Query::between(cells.start, cells.goal);
  query.limits = limits;
  answer(std::move(query));
}

void ComparisonRun::answer(Query query) {
  assert(!query.goals.empty());
  query.observer = nullptr;  // planners would tell it all at once
  ComparedQuery compared{query.start, query.goals, {}};
  for (std::size_t planner = 0; planner < specs_.size(); ++planner) {
    compared.rows.push_back(answer_of(planner, query));
  }
  comparison_.queries.push_back(std::move(compared));
}

ComparisonRow ComparisonRun::answer_of(std::size_t planner, const Query& query) {
  ComparisonRow row{.planner = specs_[planner].text};
  TimedPlanner& timed = planners_[planner];
  if (const auto& error = timed.error()) {
    row.status = error->status;
    row.reason = error->message;
    return row;
  }
  row.counts_first_query = timed.resumes();
  row.status = plan_eased(timed, query, row);
  row.cost = plan_.cost;
  row.expanded = plan_.metrics.expanded;
  row.generated = plan_.metrics.generated;
  row.max_frontier = plan_.metrics.max_frontier;
  if (!row.found()) {
    row.failure = timed.planner()->failure(query, row.status);
    row.reason = words_of(row.failure, plan_.metrics, space_);
    return row;
  }
  describe(plan_.path, space_, row);
  return row;
}

/// Leads the start out and moves the ends, as far as that is allowed: that is not timed.
Status ComparisonRun::plan_eased(TimedPlanner& timed, const Query& query, ComparisonRow& row) {
  const Units units(space_.map());
  Explainer explainer(space_, units, timed.planner()->grid_moves().value_or(GridMoves{}), {});
  explainer.allow(leeway_);
  const auto ease = [&] { return EasedQuery(query, *timed.planner(), explainer, units, leeway_); };
  const Query asked = ease().query();
  Status status = timed.answer(asked, plan_, row.times);
  EasedQuery eased = ease();  // the first answer is that of another planner, which is gone
  if (eased.ease_goals(status)) status = timed.answer(eased.query(), plan_, row.times);
  row.eased = {eased.query().start, eased.query().goals};
  row.lead = eased.lead();
  if (status != Status::found) return status;
  eased.finish(plan_);
  begin_with(row.lead, plan_, space_.map().frame());
  row.notes = eased.notes();
  row.remaining = eased.remaining();
  return status;
}

void ComparisonRun::describe(const Path& path, const FreeSpace& space, ComparisonRow& row) {
  const auto measured = measure(path, space);
  assert(measured);  // a planner's path
  const PathMetrics& metrics = *measured;
  row.length = metrics.length;
  row.turning = without_rounding(degrees_from(metrics.turning));
  row.largest_curvature = 1 / metrics.rounded_turning_radius;
  row.smallest_clearance = metrics.smallest_clearance;
  row.mean_clearance = metrics.mean_clearance;
  row.steps = path.size() - 1;
  row.reversals = static_cast<std::uint64_t>(metrics.reversals);
}

/// Repeats a search; one that was stopped, as far as it went. A planner that resumes would not search again, so another
/// one does. (One that keeps what it prepared may expand other cells than the first time.)
Plan ComparisonRun::again(std::size_t planner, std::size_t query, SearchObserver* observer) const {
  const ComparisonRow& row = comparison_.queries[query].rows[planner];
  Query same{row.eased.start, row.eased.goals};
  if (!row.found()) same.limits.expansions = row.expanded;
  same.observer = observer;
  Plan plan;
  const TimedPlanner& timed = planners_[planner];
  if (timed.planner() == nullptr) return plan;
  if (!timed.resumes()) {
    timed.planner()->plan(same, plan);
  } else if (const auto another = timed.another()) {
    (*another)->plan(same, plan);
  }
  return plan;
}

GridMoves ComparisonRun::grid_moves(std::size_t planner) const {
  const Planner* const made = planners_[planner].planner();
  return made == nullptr ? GridMoves{} : made->grid_moves().value_or(GridMoves{});
}

SearchRecorder ComparisonRun::record(std::size_t planner, std::size_t query) const {
  const Planner* const made = planners_[planner].planner();
  SearchRecorder recorder(space_, made == nullptr ? cells_of(space_) : made->place_grid());
  again(planner, query, &recorder);
  return recorder;
}

Path ComparisonRun::path(std::size_t planner, std::size_t query) const {
  const Path path = again(planner, query, nullptr).path;
  const Path& lead = comparison_.queries[query].rows[planner].lead;
  return path.empty() || lead.empty() ? path : joined(lead, path);
}

}  // namespace wend
