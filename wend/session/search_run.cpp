#include "wend/session/search_run.hpp"

#include <cmath>
#include <utility>

#include "wend/planner/goal_region.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/run_parts.hpp"

namespace wend {
namespace {

Unexpected<RequestFailure> refused(Error error) {
  return Unexpected<RequestFailure>(RequestFailure{PlanFailure{std::move(error), {}}});
}

Capabilities capabilities_of(const PlannerSpec& spec) {
  const PlannerInfo* const info = planners().find(spec.name);
  return info != nullptr ? info->capabilities : Capabilities{};
}

/// Does the planner ask for the components itself, within the limits, and only if its search takes long?
bool asks_late(const RunParts& parts) {
  const PlanRequest& request = parts.request;
  const Capabilities can = capabilities_of(parts.spec);
  const Leeway leeway = request.leeway();
  return can.can_step && !can.resumes && !request.from_field && request.observer == nullptr &&
         !leeway.closest && !leeway.nearest && request.goals.size() == 1 &&
         request.goals.front().tolerance == 0;
}

Query unwatched(Query query) {
  query.observer = nullptr;
  query.on_solution = {};
  return query;
}

std::optional<Error> fault_of(const PlanRequest& request, bool steps) {
  if (!(request.keep >= 0)) {
    return Error{Status::invalid_option, "keep must be at least 0", "keep"};
  }
  if (request.goals.empty()) {
    return Error{Status::unsupported_query, "there is no goal", "goals"};
  }
  if (std::isnan(request.limits.seconds)) {
    return Error{Status::unsupported_query, "the limit of seconds is NaN", "seconds"};
  }
  if (request.from_field && !steps) {
    return Error{Status::unsupported_query,
                 "only planners that step from cell to cell answer from a field", "from_field"};
  }
  return fault_of(request.leeway());
}

Explainer explainer_of(const RunParts& parts, const Units& units) {
  Explainer explainer(parts.space, units, parts.planner->grid_moves().value_or(GridMoves{}),
                      parts.hints);
  explainer.allow(parts.request.leeway());
  explainer.stop_at(parts.deadline);
  return explainer;
}

}  // namespace

struct SearchRun::State {
  /// Deletes a planner that an exception, as of memory that ends, stopped in the middle of its work.
  class StoppedPlanner {
   public:
    /// The work has begun.
    explicit StoppedPlanner(WarmPlanner& planner) : planner_(planner) {}
    StoppedPlanner(const StoppedPlanner&) = delete;
    StoppedPlanner& operator=(const StoppedPlanner&) = delete;
    ~StoppedPlanner() {
      if (at_work_) planner_.discard();
    }

    void begin() { at_work_ = true; }
    void end() { at_work_ = false; }

   private:
    WarmPlanner& planner_;
    bool at_work_ = true;
  };

  explicit State(RunParts given);

  double now() const { return parts.clock ? parts.clock() : steady_seconds(); }
  Planner& planner() { return *parts.planner; }
  const PlanRequest& request() const { return parts.request; }
  bool can_step() const { return capabilities_of(parts.spec).can_step && !request().from_field; }
  Ends ends() const { return eased.ends(request().texts); }

  std::optional<Status> step();
  std::optional<Status> restart();
  Status run();
  Query asked() const;
  std::string why(Status status, const SearchMetrics& metrics) const;
  RequestFailure failure(Status status) const;
  PlanAnswer answer(EasedQuery& of, Plan found) const;
  Expected<PlanAnswer, RequestFailure> finish();

  RunParts parts;
  const Units units;
  const std::optional<GridMoves> moves;  // of the planner
  const Explainer explainer;
  StoppedPlanner stopped;
  EasedQuery eased;
  Plan plan = {};
  std::optional<Status> outcome = {};
  double seconds = 0;  // of the search
  bool told = false;   // of a path, in this call

 private:
  template <class Work>
  auto timed(Work work);
  void limit();
  Status whole(bool watched);
  Status search();
  void begin_stepping();
  void ease_failure();
  Status look_up();
  std::optional<AnsweredPath> take_rest(const Errand& errand);
  void remember(Errand errand, std::optional<AnsweredPath> rest_of, const Path& found,
                const PlanAnswer& answer) const;

  bool stepping_ = false;
  bool goals_are_known_ = false;  // they will not be replaced
  bool is_rest_ = false;          // is the plan what was left of the last path?
};

SearchRun::State::State(RunParts given)
    : parts(std::move(given)),
      units(parts.space.map(), request().wording == MapUnits::cells),
      moves(parts.planner->grid_moves()),
      explainer(explainer_of(parts, units)),
      stopped(parts.planner),
      eased(query_of(request(), parts.space.map().frame()), *parts.planner, explainer, units,
            request().leeway()) {
  stopped.end();
}

/// Work of the planner, which counts as search.
template <class Work>
auto SearchRun::State::timed(Work work) {
  stopped.begin();
  const double begin = now();
  auto result = work();
  seconds += now() - begin;
  stopped.end();
  return result;
}

/// Sets the limits of the next search: what was done before counts.
void SearchRun::State::limit() {
  eased.query().limits = request().limits;
  eased.query().limits.seconds = parts.deadline.seconds_left();
}

Status SearchRun::State::whole(bool watched) {
  limit();
  if (request().from_field) return look_up();
  return planner().plan(watched ? eased.query() : unwatched(eased.query()), plan);
}

/// An observer sees the search that answers, not one whose goals are replaced after it.
Status SearchRun::State::search() {
  const bool twice = request().observer != nullptr && !goals_are_known_ && eased.may_ease_goals();
  Status status = whole(!twice);
  if (eased.ease_goals(status) || (twice && !is_limit(status))) status = whole(true);
  return status;
}

Status SearchRun::State::run() {
  if (stepping_) {
    while (!outcome) step();
  }
  if (!outcome) {
    outcome = timed([this] { return search(); });
    told |= outcome == Status::found;
  }
  return *outcome;
}

void SearchRun::State::begin_stepping() {
  limit();
  eased.query().on_solution = [this](const Plan& path) {
    told = true;
    if (request().on_solution) request().on_solution(path);
  };
  outcome = planner().begin(eased.query(), plan);
  ease_failure();
}

void SearchRun::State::ease_failure() {
  if (outcome && *outcome != Status::found && eased.ease_goals(*outcome)) begin_stepping();
}

std::optional<Status> SearchRun::State::restart() {
  outcome.reset();
  seconds = 0;
  if (!can_step()) return std::nullopt;
  stepping_ = true;
  return timed([this] {
    if (request().observer != nullptr && !goals_are_known_ && eased.may_ease_goals()) {
      const Status status = whole(false);
      goals_are_known_ = true;
      if (!eased.ease_goals(status) && is_limit(status)) return outcome = status;
    }
    begin_stepping();
    return outcome;
  });
}

std::optional<Status> SearchRun::State::step() {
  if (outcome) return outcome;
  if (!can_step()) return run();
  if (!stepping_ && restart()) return outcome;
  return timed([this] {
    outcome = planner().step(plan);
    ease_failure();
    return outcome;
  });
}

/// The query with the limits that messages name.
Query SearchRun::State::asked() const {
  Query query = eased.query();
  query.limits = request().limits;
  return query;
}

std::string SearchRun::State::why(Status status, const SearchMetrics& metrics) const {
  const Query query = asked();
  return explainer.explain(*parts.planner, query, ends(), parts.planner->failure(query, status),
                           metrics);
}

RequestFailure SearchRun::State::failure(Status status) const {
  const Query query = asked();
  Failure failure = parts.planner->failure(query, status);
  std::string reason = request().explain
                           ? explainer.explain(*parts.planner, query, ends(), failure, plan.metrics)
                           : explainer.words(failure, plan.metrics);
  return {PlanFailure{{status, std::move(reason)}, plan.metrics, std::move(failure)}, seconds};
}

PlanAnswer SearchRun::State::answer(EasedQuery& of, Plan found) const {
  PlanAnswer answer{.space = parts.space, .plan = std::move(found), .moves = moves};
  answer.search_seconds = seconds;
  answer.kept = is_rest_;
  of.finish(answer.plan);
  answer.notes = of.notes();
  answer.lead_out = of.lead_out();
  if (const auto remaining = of.remaining()) {
    answer.remaining = *remaining * parts.space.map().frame().resolution;
  }
  auto disc = explainer.planned_as_disc(*parts.planner);
  if (!disc.empty()) answer.notes.push_back("the robot is " + std::move(disc));
  // Who receives paths sets the flag when one is good enough: that one is finished.
  finish_path(answer, request(), of.lead(),
              request().on_solution ? parts.deadline.without_cancel() : parts.deadline);
  return answer;
}

Expected<PlanAnswer, RequestFailure> SearchRun::State::finish() {
  run();
  eased.query().limits = request().limits;  // as messages name them
  Errand errand;
  std::optional<AnsweredPath> rest_of;
  if (parts.kept) {
    errand = {request().planner, eased.query().goals, parts.space.map().frame()};
    rest_of = take_rest(errand);
  }
  const Status status = outcome.value_or(Status::cancelled);  // run() has set it
  if (status != Status::found) return Unexpected<RequestFailure>(failure(status));
  const Path over_centres = parts.kept ? plan.path : Path();
  PlanAnswer done = answer(eased, std::move(plan));
  if (parts.kept) remember(std::move(errand), std::move(rest_of), over_centres, done);
  return done;
}

/// Makes what is left of the last path the answer, if it is kept. Returns which path that is.
std::optional<AnsweredPath> SearchRun::State::take_rest(const Errand& errand) {
  const Query& query = eased.query();
  auto rest = parts.kept->rest(errand, *parts.planner, query);
  if (!rest) return std::nullopt;
  const bool same = outcome == Status::found && plan.path == rest->plan.path;
  if (!same) {
    if (!is_kept(rest->plan, outcome.value_or(Status::cancelled), plan, request().keep))
      return std::nullopt;
    rest->plan.metrics = plan.metrics;
    plan = std::move(rest->plan);
    outcome = Status::found;
    if (query.on_solution) query.on_solution(plan);
  }
  is_rest_ = true;
  return std::move(rest->of);
}

/// Keeps the answer for the next time, and the path as the planner found it.
void SearchRun::State::remember(Errand errand, std::optional<AnsweredPath> rest_of,
                                const Path& found, const PlanAnswer& answer) const {
  AnsweredPath path;
  if (rest_of) {
    path = *std::move(rest_of);
  } else {
    path = {std::move(errand), std::make_shared<const Path>(found), nullptr,
            answer.plan.goal_snapping_error};
  }
  path.answered = std::make_shared<const Path>(answer.path());
  parts.kept->keep(std::move(path));
}

/// Plan::metrics are those of making the field: 0 if it was kept.
Status SearchRun::State::look_up() {
  const Query& query = eased.query();
  const auto to_goals = parts.field->get(parts.space, parts.version, goal_cells(parts.space, query),
                                         moves.value_or(GridMoves{}), query.limits);
  if (!to_goals) {
    plan.metrics = to_goals.error().metrics;
    return to_goals.error().status;
  }
  auto found = to_goals->costs->path_from(ends().start.cell);
  const Status status = found ? Status::found : found.error().status;
  if (found) plan = *std::move(found);
  plan.metrics = to_goals->metrics;
  return status;
}

SearchRun::SearchRun(std::unique_ptr<State> state) : state_(std::move(state)) {}
SearchRun::SearchRun(SearchRun&&) noexcept = default;
SearchRun& SearchRun::operator=(SearchRun&&) noexcept = default;
SearchRun::~SearchRun() = default;

Expected<SearchRun, RequestFailure> SearchRun::begin(RunParts& parts) {
  const auto moves = parts.planner->grid_moves();
  if (auto fault = fault_of(parts.request, moves && !capabilities_of(parts.spec).any_angle)) {
    return refused(*std::move(fault));
  }
  const Deadline& deadline = parts.deadline;
  const Deadline soon = deadline.later(kSecondsToFinish);
  if (deadline.bounded() && moves &&
      !(asks_late(parts) ? !soon.passed()
                         : parts.space.make_components(moves->adjacency(), soon))) {
    return refused(Error{deadline.status(),
                         deadline.text() + ", before it was known which cells are connected"});
  }
  return SearchRun(std::make_unique<State>(std::move(parts)));
}

std::optional<Status> SearchRun::step() { return state_->step(); }

std::optional<Status> SearchRun::restart() { return state_->restart(); }

Status SearchRun::run() { return state_->run(); }

void SearchRun::cancel() {
  if (!state_->outcome) state_->outcome = Status::cancelled;
}

std::optional<PlanAnswer> SearchRun::next_solution() {
  state_->told = false;
  while (!state_->told && !state_->step()) {
  }
  if (!state_->told) return std::nullopt;
  EasedQuery eased = state_->eased;  // each path has its own notes
  return state_->answer(eased, state_->plan);
}

void SearchRun::repeat(SearchObserver& observer) {
  Query query = unwatched(state_->eased.query());
  query.limits = {};
  query.limits.expansions = state_->plan.metrics.expanded;
  query.observer = &observer;
  Plan plan;
  state_->stopped.begin();
  state_->planner().plan(query, plan);
  state_->stopped.end();
}

Expected<PlanAnswer, RequestFailure> SearchRun::finish() { return state_->finish(); }

std::string SearchRun::explain() const {
  return state_->why(state_->outcome.value_or(Status::found), state_->plan.metrics);
}

/// Of a search that was made elsewhere for the same request.
std::string SearchRun::explain(const PlanFailure& failure) {
  state_->eased.ease_goals(failure.status);
  return state_->why(failure.status, failure.metrics);
}

WarmPlanner SearchRun::take_planner() { return std::move(state_->parts.planner); }

OpenList SearchRun::open_list(std::size_t most) const { return planner().open_list(most); }

const Plan& SearchRun::plan() const { return state_->plan; }

const Planner& SearchRun::planner() const { return *state_->parts.planner; }

const Query& SearchRun::query() const { return state_->eased.query(); }

const Path& SearchRun::lead() const { return state_->eased.lead(); }

const std::vector<std::string>& SearchRun::notes() const { return state_->eased.notes(); }

}  // namespace wend
