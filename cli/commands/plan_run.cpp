#include "cli/commands/plan_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bench/plot/solution_plot.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/plan_text.hpp"
#include "cli/watching/films.hpp"
#include "cli/watching/frame.hpp"
#include "cli/watching/narrator.hpp"
#include "cli/watching/stepped_search.hpp"
#include "cli/watching/stepper.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/report/plan_report.hpp"

namespace wend::cli {

namespace {

constexpr int kRowsOfStep = 2;  // what is expanded, and the cursor

/// Does a path come back to a cell that it has left?
bool crosses_itself(const Path& path) {
  std::vector<Cell> cells = path.passed_cells();
  const auto repeated = std::ranges::unique(cells);
  cells.erase(repeated.begin(), repeated.end());
  std::ranges::sort(cells, {}, [](Cell cell) { return std::pair(cell.y, cell.x); });
  return std::ranges::adjacent_find(cells) != cells.end();
}

}  // namespace

void write_failed_plan(const PlanArguments& arguments, const FailedPlan& plan) {
  if (!arguments.queries.empty()) return;
  arguments.trajectory.write_failure(plan);
  arguments.output.write(
      {{".csv", [&](const std::string& file) { return write_bytes(file, no_path_csv(plan)); }},
       {".json",
        [&](const std::string& file) { return write_bytes(file, failed_plan_json(plan)); }}},
      arguments.format == TableFormat::json ? ".json" : ".csv");
}

PlanRun::PlanRun(const PlanArguments& arguments, Session& session, PlannerSpec planner,
                 IndexArgument index, const WorkTimes& times, Deadline deadline)
    : arguments_(arguments),
      session_(session),
      spec_(std::move(planner)),
      index_(std::move(index)),
      deadline_(std::move(deadline)),
      space_(value_or_throw(session.view()).space),
      asked_(typed_query(spec_, space_, arguments.map.coordinates(space_.map()), arguments.ends)),
      refinement_(arguments.refine.refinement(arguments.map.coordinates(space_.map()))) {
  result_.times = times;
  asked_->check(arguments.layers);
  const bool arcs = info_of(spec_).capabilities.headings;
  if (!arcs || !refinement_.simplify) return;
  throw InputError(fmt::format(
      "--simplify supports grid planners only: the path of the planner {} consists of arcs",
      spec_.name));
}

/// On large maps a search is slowed down only for those who ask for what it did.
bool PlanRun::records() const {
  const WatchArguments& watch = arguments_.watch;
  return is_small(space_.map(), Screen{}) || steps() || watch.animate ||
         arguments_.layers.any_from(LayerSource::search) || arguments_.output.any(".gif");
}

void PlanRun::plan() {
  if (records() || !arguments_.watch.trace.empty()) spec_ = without_leaps(std::move(spec_));
  result_.planner = spec_.name;
  result_.capabilities = info_of(spec_).capabilities;
  result_.cost_name = info_of(spec_).cost_name;
  result_.footprint = space_.footprint();
  auto planner = make_planner();
  if (!planner) {
    if (planner.error().status == Status::invalid_option) {
      throw InputError(planner.error().message);
    }
    return fail(planner.error().status, planner.error().message);
  }
  planner_ = std::make_unique<WarmPlanner>(*std::move(planner));
  moves_ = (*planner_)->grid_moves().value_or(GridMoves{});
  refinement_.adjacency = moves_.adjacency();
  result_.states = (*planner_)->state_count();
  result_.places = (*planner_)->place_grid();
  result_.anytime = (*planner_)->anytime();
  if (!arguments_.plot.empty() && !result_.anytime) {
    throw InputError(
        "--plot changes nothing without --initial-weight above 1: the planner finds one path");
  }
  search();
}

Expected<WarmPlanner, Error> PlanRun::make_planner() {
  const auto built = provide_index(session_, spec_, index_, result_.times, deadline_);
  if (!built) return Unexpected<Error>(built.error());
  built_index_ = *built;
  return timed(thread_cpu_seconds, result_.times.planner.emplace(0),
               [&] { return session_.planner(spec_, deadline_); });
}

/// The limits of the next search: the time until now counts.
Limits PlanRun::limits_left(ProgressBar& progress) const {
  Limits limits = arguments_.limits.limits(progress);
  limits.seconds = deadline_.seconds_left();
  return limits;
}

void PlanRun::search() {
  ProgressBar progress("planning", result_.states);
  const Coordinates coordinates = arguments_.map.coordinates(space_.map());
  const Leeway leeway = arguments_.leeway.leeway(coordinates);
  Explainer explainer = explainer_for(space_, coordinates, moves_);
  explainer.allow(leeway);
  explainer.stop_at(deadline_);
  EasedQuery eased(asked_->query(), **planner_, explainer, coordinates, leeway);
  asked_->move_ends(eased);
  eased.query().limits = limits_left(progress);
  ObserverList told;
  Narrator narrator(space_.map().frame());
  if (arguments_.watch.verbose) told.add(narrator);
  if (records()) recorder_.emplace(asked_->recorder());
  std::optional<PosthocTrace> trace;
  if (!arguments_.watch.trace.empty()) {
    told.add(
        trace.emplace(asked_->trace(arguments_.watch.trace_form(), arguments_.watch.trace_limit)));
  }
  if (steps() && recorder_) {
    result_.status = search_in_steps(eased.query(), *recorder_, told);
    if (eased.ease_goals(result_.status)) search_to_the_end(eased.query());
  } else {
    search_to_the_end(eased.query());
    if (eased.ease_goals(result_.status)) search_to_the_end(eased.query());
    if (recorder_) told.add(*recorder_);
    const bool cancelled = result_.status == Status::cancelled;
    if (!told.empty() && !cancelled) search_for(told, eased.query());
  }
  if (result_.status == Status::found) eased.finish(result_.plan);
  note_what_was_eased(eased, explainer);
  eased.query().limits = arguments_.limits.limits(progress);  // as messages name them
  if (result_.status != Status::found) {
    fail(result_.status, explainer.explain(**planner_, eased.query(), ends_of(eased),
                                           result_.status, result_.plan.metrics));
  }
  if (result_.status == Status::found && arguments_.refine.any()) refine_path();
  if (trace && result_.status != Status::cancelled) write_trace(*trace);
  if (result_.status == Status::found) put_lead_before(eased);
  if (result_.status == Status::found && arguments_.trajectory.wanted()) time_path();
  make_layers(eased.query().limits);
}

void PlanRun::note_what_was_eased(const EasedQuery& eased, const Explainer& explainer) {
  for (const std::string& note : eased.notes()) complain(note);
  result_.notes = eased.notes();
  result_.planned_as_disc = explainer.planned_as_disc(**planner_);
  if (!result_.planned_as_disc.empty()) {
    result_.notes.push_back("the robot is " + result_.planned_as_disc);
  }
}

/// The ends as they were asked for, but for a start that is led out.
Ends PlanRun::ends_of(const EasedQuery& eased) const {
  Ends ends = asked_->ends();
  if (eased.lead_out()) {
    ends.start =
        Units(arguments_.map.coordinates(space_.map())).place("start", eased.query().start.point());
  }
  return ends;
}

/// Before the path that the search and its trace know, and before the refined one.
void PlanRun::put_lead_before(const EasedQuery& eased) {
  result_.lead_out = eased.lead_out();
  if (const auto remaining = eased.remaining()) {
    result_.remaining = *remaining * space_.map().frame().resolution;
  }
  const Path& lead = eased.lead();
  if (lead.empty()) return;
  begin_with(lead, result_.plan, space_.map().frame());
  if (result_.refined)
    result_.refined =
        with_lead(lead, *std::move(result_.refined), space_,
                  arguments_.refine.rounding(arguments_.map.coordinates(space_.map())));
}

void PlanRun::search_to_the_end(Query query) {
  const Interruptible interruptible;  // what it did until then is reported
  if (result_.anytime) {
    query.on_solution = [this, begun = thread_cpu_seconds()](const Plan& plan) {
      result_.solutions.push_back(
          {thread_cpu_seconds() - begun, plan.cost, plan.bound, plan.metrics.expanded});
    };
  }
  result_.status = timed(thread_cpu_seconds, result_.times.search,
                         [&] { return (*planner_)->plan(query, result_.plan); });
}

/// Repeats the search, as far as it went, with an observer, so that the observer's time does not
/// count as the search's. Ctrl-C ends the program.
void PlanRun::search_for(SearchObserver& observer, Query query) {
  query.limits = {};
  query.limits.expansions = result_.plan.metrics.expanded;
  query.observer = &observer;
  Plan plan;
  (*planner_)->plan(query, plan);
}

/// Is the search looked at before it is over?
bool PlanRun::steps() const { return arguments_.watch.step || arguments_.watch.open_list; }

/// Only the search is timed, not the person.
Status PlanRun::search_in_steps(const Query& query, SearchRecorder& recorder, ObserverList& told) {
  if (!info_of(spec_).capabilities.can_step) {
    throw InputError(fmt::format("--step: the planner {} does not support stepping", spec_.name));
  }
  SteppedSearch search(**planner_, query, recorder, told, result_.plan);
  const Status status =
      arguments_.watch.step ? step_by_keys(search, recorder) : step_to_the_end(search);
  result_.times.search = search.seconds();
  return status;
}

/// Tells the open list on the way, if that is asked for.
std::optional<Status> PlanRun::go_on(SteppedSearch& search) {
  if (arguments_.watch.open_list && search.expansions() == open_lists_told_) {
    tell(open_list_text((*planner_)->open_list(kMostOpenEntries), space_.map().frame()));
    ++open_lists_told_;
  }
  return search.go_on();
}

Status PlanRun::step_to_the_end(SteppedSearch& search) {
  auto outcome = search.begin();
  while (!outcome) outcome = go_on(search);
  return *outcome;
}

Status PlanRun::step_by_keys(SteppedSearch& search, const SearchRecorder& recorder) {
  auto outcome = search.begin();
  if (outcome) return *outcome;
  // Lines of --verbose would come in between.
  Stepper stepper(screen_.is_terminal && !(arguments_.watch.verbose && progress_is_seen()));
  std::uint64_t next = 1;  // after how many expansions to show it
  while (!outcome) {
    if (search.expansions() < next) {
      outcome = go_on(search);
      continue;
    }
    const auto wanted = stepper.ask(step_text(search, recorder), search.expansions());
    if (!wanted) {
      outcome_is_shown_ = stepper.in_place();
      return Status::cancelled;
    }
    next = *wanted;
    if (next < search.expansions()) outcome = search.go_back_to(next);
  }
  stepper.finish();
  return *outcome;
}

void PlanRun::refine_path() {
  auto refined =
      refine(result_.plan.path, space_, refinement_,
             arguments_.refine.rounding(arguments_.map.coordinates(space_.map())), deadline_);
  if (!refined) return give_up(refined.error());
  result_.refined = *std::move(refined);
}

/// There is a path, but no time for what was to be done with it.
void PlanRun::give_up(const Error& why) {
  result_.plan.path.clear();
  result_.refined.reset();
  fail(why.status, why.message);
}

void PlanRun::time_path() {
  const TrajectoryArguments& trajectory = arguments_.trajectory;
  auto timed = trajectory.along(
      path(), space_, arguments_.refine.rounding(arguments_.map.coordinates(space_.map())),
      refinement_.adjacency, trajectory.limits(), deadline_);
  if (!timed) return give_up(timed.error());
  result_.trajectory = *std::move(timed);
}

void PlanRun::make_layers(const Limits& limits) {
  std::optional<CostToGo> field;
  if (arguments_.layers.any_from(LayerSource::cost_to_go))
    field = asked_->cost_to_go(moves_, limits);
  const bool searched = recorder_ && !recorder_->expansions().empty();
  layers_.clear();
  for (const LayerKind kind : arguments_.layers.kinds()) {
    switch (source_of(kind)) {
      case LayerSource::search:
        if (!searched) break;
        layers_.push_back(arguments_.layers.counted(search_layer(kind, **planner_, *recorder_)));
        break;
      case LayerSource::cost_to_go:
        if (field) layers_.push_back(cost_to_go_layer(kind, space_, *field));
        break;
      case LayerSource::map:
        layers_.push_back(map_layer(kind, space_));
        break;
    }
  }
}

void PlanRun::fail(Status status, std::string reason) {
  result_.status = status;
  result_.reason = std::move(reason);
}

/// A path may cross itself, as a random walk does, which arrows cannot show, and a search that was stopped has no path:
/// the cells that they visited are shown instead.
Scene PlanRun::outcome() const {
  Scene scene = asked_->scene();
  if (result_.refined) {
    const Path& refined = result_.refined->refined.path;
    if (refined.driven()) {
      scene.path = refined;
    } else {
      scene.lines = lines_of(*result_.refined);
    }
    return scene;
  }
  const bool crosses = recorder_ && crosses_itself(result_.plan.path);
  if (!crosses && !result_.plan.path.empty()) {
    scene.path = result_.plan.path;
  } else if (recorder_ && !recorder_->expansions().empty()) {
    scene.marked = {{CellRole::expanded, recorder_->snapshot().expanded}};
  }
  return scene;
}

std::string PlanRun::step_text(const SteppedSearch& search, const SearchRecorder& recorder) const {
  const SearchSnapshot snapshot = recorder.snapshot();
  std::vector<Layer> layers;
  for (const LayerKind kind : arguments_.layers.kinds()) {
    if (source_of(kind) == LayerSource::search) {
      layers.push_back(arguments_.layers.as_numbers(
          arguments_.layers.counted(search_layer(kind, **planner_, recorder))));
    }
  }
  const OpenList open = (*planner_)->open_list(kMostOpenEntries);
  const Frame& frame = space_.map().frame();
  const std::string keys = Stepper::keys(screen_.columns);
  const auto rows_below =
      kRowsOfStep + static_cast<int>(std::count(keys.begin(), keys.end(), '\n'));
  const std::string text = frame_text(with_snapshot(asked_->scene(), snapshot), layers, screen_,
                                      arguments_.pictures.style, rows_below,
                                      [&](int rows) { return open_list_text(open, frame, rows); });
  const auto& event = search.last_expansion();
  return text +
         fmt::format("expansion {}: {}, frontier {}\n", search.expansions(),
                     event ? event_text(*event, frame) : "not begun", open.count) +
         keys;
}

std::string PlanRun::text() const {
  std::string text;
  const bool found = result_.status == Status::found;
  const bool small = is_small(space_.map(), screen_);
  const bool quit = arguments_.watch.step && outcome_is_shown_;
  if (quit) return text;
  if (found) text += asked_->steps(result_.plan, screen_);
  for (const Layer& layer : layers_) {
    text +=
        layer_text(outcome(), arguments_.layers.as_numbers(layer), screen_, arguments_.pictures);
  }
  std::string summary;
  if (found) summary += asked_->summary(result_);
  if (found && built_index_) {
    summary += "index     built for this query and not saved; `wend index build` saves it\n";
  }
  if (found && arguments_.times) summary += times_lines(result_.times);
  if (result_.refined) {
    summary += "\n" + refined_text(*result_.refined, arguments_.map.coordinates(space_.map()));
  }
  if (result_.trajectory) summary += trajectory_text(result_.trajectory->trajectory);
  // Of a failure there is something to see where a search has begun.
  const bool shows_map = layers_.empty() && !outcome_is_shown_ &&
                         (found || (small && result_.plan.metrics.expanded > 0));
  if (!shows_map) return text + summary;
  return text + picture_above(summary, outcome(), screen_, arguments_.pictures);
}

void PlanRun::write_trace(PosthocTrace& trace) const {
  const WatchArguments& watch = arguments_.watch;
  const std::string wrong = write_bytes(watch.trace, trace.finish(result_.plan.path));
  if (!wrong.empty()) throw InputError(wrong);
  if (trace.dropped() == 0) return;
  complain(fmt::format(
      "{}: the trace is truncated after {} events; {} more events are missing (--trace-limit)",
      watch.trace, watch.trace_limit, trace.dropped()));
}

/// As it is driven: refined, if that was asked for.
const Path& PlanRun::path() const {
  return result_.refined ? result_.refined->refined.path : result_.plan.path;
}

std::string PlanRun::csv() const {
  if (result_.status != Status::found) {
    return no_path_csv({std::string(to_string(result_.status)), result_.reason});
  }
  return path_csv(path(), space_.map().frame());
}

std::string PlanRun::json() const {
  std::vector<Layer> layers;
  layers.reserve(layers_.size());
  for (const Layer& layer : layers_) layers.push_back(arguments_.layers.as_numbers(layer));
  return plan_json(result_, space_.map().frame(), layers);
}

/// Of a failure: what there is to see of the reason, and the reason in words.
std::vector<Panel> PlanRun::panels() const {
  if (result_.status == Status::found) return layer_panels(outcome(), layers_);
  const bool gave_up = result_.plan.metrics.expanded > 0 && result_.status != Status::unreachable;
  std::vector<Panel> panels{{fmt::format("no path: {}", to_string(result_.status)),
                             gave_up ? outcome() : asked_->scene_of_failure(result_.status, moves_),
                             result_.reason}};
  if (layers_.empty()) return panels;
  for (Panel& panel : layer_panels(outcome(), layers_)) panels.push_back(std::move(panel));
  return panels;
}

Expected<std::string, Error> PlanRun::film() const {
  const Style style = style_of(arguments_.pictures.style);
  const bool searched = recorder_ && !recorder_->expansions().empty();
  if (!searched) return gif_of(panels().front().title, panels().front().scene, style);
  const FilmedSearch search{spec_.name, outcome(), &*recorder_};
  return gif_of(std::span(&search, 1), arguments_.watch.speed, style);
}

/// Every file is replaced, also where there is no path: what an earlier command left there is not to
/// be taken for the answer.
void PlanRun::write_files() const {
  std::map<std::string, FileWriter> writers;
  if (arguments_.output.any_of(picture_extensions())) {
    writers = picture_writers(panels(), arguments_.pictures.style);
  }
  writers[".json"] = [this](const std::string& file) { return write_bytes(file, json()); };
  writers[".csv"] = [this](const std::string& file) { return write_bytes(file, csv()); };
  writers[".gif"] = [this](const std::string& file) { return write_picture(file, film()); };
  if (result_.trajectory) {
    arguments_.trajectory.write(*result_.trajectory);
  } else {
    arguments_.trajectory.write_failure({std::string(to_string(result_.status)), result_.reason});
  }
  arguments_.output.write(writers, arguments_.format == TableFormat::json ? ".json" : ".csv");
  if (!arguments_.plot.empty()) write_plot();
}

void PlanRun::write_plot() const {
  if (result_.solutions.empty()) {
    return complain("--plot: no path was found; " + arguments_.plot + " is not written");
  }
  const std::string script = solution_plot(result_.solutions, plot_kind_of(arguments_.plot),
                                           plot_colours_of(arguments_.pictures.style));
  const std::string wrong = write_bytes(arguments_.plot, drawn_by_gnuplot(script));
  if (!wrong.empty()) throw InputError(wrong);
}

void PlanRun::print_results() {
  const bool searched = recorder_ && !recorder_->expansions().empty();
  if (arguments_.watch.animate && searched) {
    play(outcome(), *recorder_, screen_, arguments_.pictures, arguments_.watch.speed);
    outcome_is_shown_ = true;
  }
  switch (arguments_.format) {
    case TableFormat::text:
      return print(text());
    case TableFormat::json:
      return print(json());
    case TableFormat::csv:
      return print(csv());
  }
}

ExitCode PlanRun::report() {
  if (!arguments_.output.print()) print_results();
  write_files();
  if (result_.status == Status::found) return success;
  complain(result_.reason);
  return no_plan;
}

}  // namespace wend::cli
