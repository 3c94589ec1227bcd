#include "bench/comparison/comparison_run.hpp"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "wend/path/joins.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/explainer.hpp"
#include "wend/session/failure_text.hpp"
#include "wend/session/legs.hpp"
#include "wend/space/lattice/car_lattice.hpp"

namespace wend {
namespace {

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

/// Of two legs by the same planner.
QueryTimes sum_of(const QueryTimes& a, const QueryTimes& b) {
  return {a.preparation, a.first + b.first, a.later + b.later};
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

void ComparisonRun::answer(Query query, const std::vector<Goal>& vias, bool closed) {
  if (closed) query.goals = {Goal(query.start)};
  assert(!query.goals.empty());
  query.observer = nullptr;  // planners would tell it all at once
  ComparedQuery compared{query.start, query.goals, {}, vias, closed};
  for (std::size_t planner = 0; planner < specs_.size(); ++planner) {
    compared.rows.push_back(answer_of(planner, query, compared));
  }
  comparison_.queries.push_back(std::move(compared));
}

ComparisonRow ComparisonRun::answer_of(std::size_t planner, const Query& query,
                                       const ComparedQuery& compared) {
  ComparisonRow row{.planner = specs_[planner].text};
  TimedPlanner& timed = planners_[planner];
  if (const auto& error = timed.error()) {
    row.status = error->status;
    row.reason = error->message;
    return row;
  }
  row.counts_first_query = timed.resumes();
  const std::vector<PlanLeg> legs = named_legs(compared.vias.size(), compared.closed);
  std::vector<Path> paths;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const bool last = leg + 1 == legs.size();
    Query asked = query;
    if (leg > 0) asked.start = end_of(paths.back());
    if (!last) asked.goals = {compared.vias[leg]};
    if (last && compared.closed) asked.goals = {Goal(beginning_of(paths.front()))};
    if (query.limits.expansions != Limits::kUnlimited) {
      asked.limits.expansions -= std::min(asked.limits.expansions, row.metrics.expanded);
    }
    Leeway leeway = leeway_;
    if (leg > 0) leeway.escape = 0;
    leeway.closest &= last;
    row.status = plan_eased(timed, asked, leeway, row);
    if (!row.found()) {
      row.failure = timed.planner()->failure(asked, row.status);
      row.reason = (last && leg == 0 ? "" : leg_words(legs, leg)) +
                   words_of(row.failure, plan_.metrics, space_);
      return row;
    }
    paths.push_back(std::move(plan_.path));
  }
  const Path legs_joined = end_to_end(paths);
  const Path path = row.lead.empty() ? legs_joined : joined(row.lead, legs_joined);
  const auto measured = measure(path, space_);
  assert(measured);  // a planner's path
  row.measured = *measured;
  row.steps = path.size() - 1;
  return row;
}

/// Leads the start out and moves the ends, as far as that is allowed: that is not timed.
Status ComparisonRun::plan_eased(TimedPlanner& timed, const Query& query, const Leeway& leeway,
                                 ComparisonRow& row) {
  const Units units(space_.map());
  Explainer explainer(space_, units, timed.planner()->grid_moves().value_or(GridMoves{}), {});
  explainer.allow(leeway);
  const auto ease = [&] { return EasedQuery(query, *timed.planner(), explainer, units, leeway); };
  const Query asked = ease().query();
  QueryTimes times;
  Status status = timed.answer(asked, plan_, times);
  EasedQuery eased = ease();  // the first answer is that of another planner, which is gone
  if (eased.ease_goals(status)) status = timed.answer(eased.query(), plan_, times);
  const bool first = row.eased.empty();
  row.times = first ? times : sum_of(row.times, times);
  row.eased.push_back({eased.query().start, eased.query().goals, plan_.metrics.expanded});
  if (first) row.lead = eased.lead();
  row.cost = first ? plan_.cost : row.cost + plan_.cost;
  row.metrics.expanded += plan_.metrics.expanded;
  row.metrics.generated += plan_.metrics.generated;
  row.metrics.max_frontier = std::max(row.metrics.max_frontier, plan_.metrics.max_frontier);
  if (status != Status::found) return status;
  eased.finish(plan_);
  row.notes.insert(row.notes.end(), eased.notes().begin(), eased.notes().end());
  row.remaining = eased.remaining();
  return status;
}

/// Repeats a search; one that was stopped, as far as it went. A planner that resumes would not search again, so another
/// one does. (One that keeps what it prepared may expand other cells than the first time.)
std::vector<Path> ComparisonRun::again(std::size_t planner, std::size_t query,
                                       SearchObserver* observer) const {
  const ComparisonRow& row = comparison_.queries[query].rows[planner];
  const TimedPlanner& timed = planners_[planner];
  std::vector<Path> paths;
  if (timed.planner() == nullptr) return paths;
  for (const EasedEnds& leg : row.eased) {
    Query same{leg.start, leg.goals};
    if (!row.found()) same.limits.expansions = leg.expanded;
    same.observer = observer;
    Plan plan;
    if (!timed.resumes()) {
      timed.planner()->plan(same, plan);
    } else if (const auto another = timed.another()) {
      (*another)->plan(same, plan);
    }
    paths.push_back(std::move(plan.path));
  }
  return paths;
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
  const std::vector<Path> legs = again(planner, query, nullptr);
  if (legs.empty() || std::ranges::any_of(legs, &Path::empty)) return {};
  const Path path = end_to_end(legs);
  const Path& lead = comparison_.queries[query].rows[planner].lead;
  return lead.empty() ? path : joined(lead, path);
}

}  // namespace wend
