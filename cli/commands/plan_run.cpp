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
#include "cli/output/query_scene.hpp"
#include "cli/watching/films.hpp"
#include "cli/watching/frame.hpp"
#include "cli/watching/narrator.hpp"
#include "cli/watching/stepped_search.hpp"
#include "cli/watching/stepper.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/planner/goal_region.hpp"
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
      view_(value_or_throw(session.view())),
      space_(view_.space),
      coordinates_(arguments.map.coordinates(space_.map())),
      request_(typed_request(spec_, space_, coordinates_, arguments.ends)),
      asked_(query_of(request_, space_.map().frame())) {
  result_.times = times;
  const bool poses = info_of(spec_).capabilities.headings;
  if (poses && arguments.layers.any_from(LayerSource::cost_to_go)) {
    throw InputError("--show: cost and policy support grid planners only");
  }
  request_.refinement = arguments.refine.refinement(coordinates_);
  request_.corner_rounding = arguments.refine.rounding(coordinates_);
  if (arguments.trajectory.wanted()) request_.trajectory = arguments.trajectory.limits();
  arguments.request.put(request_, coordinates_);
  if (!poses || !request_.refinement.simplify) return;
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
  {
    const auto planner = make_planner();
    if (!planner) {
      if (planner.error().status == Status::invalid_option) {
        throw InputError(planner.error().message);
      }
      return fail(planner.error().status, planner.error().message);
    }
    describe(**planner);
  }
  search();
}

void PlanRun::describe(const Planner& planner) {
  moves_ = planner.grid_moves().value_or(GridMoves{});
  result_.states = planner.state_count();
  result_.places = planner.place_grid();
  result_.anytime = planner.anytime();
  result_.planned_as_disc = explainer_for(space_, coordinates_, moves_).planned_as_disc(planner);
  if (!arguments_.plot.empty() && !result_.anytime) {
    throw InputError(
        "--plot changes nothing without --initial-weight above 1: the planner finds one path");
  }
  if (steps() && !info_of(spec_).capabilities.can_step) {
    throw InputError(fmt::format("--step: the planner {} does not support stepping", spec_.name));
  }
}

Expected<WarmPlanner, Error> PlanRun::make_planner() {
  const auto built = provide_index(session_, spec_, index_, result_.times, deadline_);
  if (!built) return Unexpected<Error>(built.error());
  built_index_ = *built;
  return timed(thread_cpu_seconds, result_.times.planner.emplace(0),
               [&] { return session_.planner(spec_, deadline_); });
}

PlanRequest PlanRun::request(ProgressBar& progress) const {
  PlanRequest request = request_;
  request.planner = spec_;
  request.limits = arguments_.limits.limits(progress);
  return request;
}

void PlanRun::search() {
  ProgressBar progress("planning", result_.states);
  PlanRequest asked = request(progress);
  ObserverList told;
  Narrator narrator(space_.map().frame());
  if (arguments_.watch.verbose) told.add(narrator);
  if (records()) {
    recorder_.emplace(info_of(spec_).capabilities.headings ? SearchRecorder(space_, result_.places)
                                                           : SearchRecorder(space_));
  }
  std::optional<SteppedSearch> steps;
  if (this->steps() && recorder_) asked.observer = &steps.emplace(*recorder_, told).observer();
  if (result_.anytime && !steps) {
    asked.on_solution = [this, begun = thread_cpu_seconds()](const Plan& plan) {
      result_.solutions.push_back(
          {thread_cpu_seconds() - begun, plan.cost, plan.bound, plan.metrics.expanded});
    };
  }
  auto run = session_.begin(view_, asked, deadline_);
  if (!run) return fail(run.error().status, run.error().message);
  if (run->lead().empty()) asked_.start = run->query().start;
  asked_.goals = run->query().goals;
  std::optional<PosthocTrace> trace;
  if (!arguments_.watch.trace.empty()) told.add(trace.emplace(trace_of(asked_)));
  if (!steps) {
    run_to_the_end(*run);
    if (recorder_) told.add(*recorder_);
    const bool cancelled = run->run() == Status::cancelled;
    if (!told.empty() && !cancelled) run->repeat(told);
  } else if (arguments_.watch.step) {
    step_by_keys(*steps, *run);
  } else {
    step_to_the_end(*steps, *run);
  }
  take(run->finish(), *run);
  if (trace && result_.status != Status::cancelled) write_trace(*trace);
  make_layers(run->planner(), asked.limits);
}

PosthocTrace PlanRun::trace_of(const Query& query) const {
  const TraceForm form = arguments_.watch.trace_form();
  const std::uint64_t most = arguments_.watch.trace_limit;
  if (info_of(spec_).capabilities.headings) return {space_, query, result_.places, form, most};
  const bool near = query.goals.front().tolerance > 0;
  return {space_, coordinates_.place("start", query.start.point()).cell,
          near ? goal_cells(space_, query) : cells_of_goals(query, coordinates_), form, most};
}

void PlanRun::run_to_the_end(SearchRun& run) {
  const Interruptible interruptible;  // what it did until then is reported
  run.run();
}

/// What was found, or why nothing was, and what is said of it.
void PlanRun::take(Expected<PlanAnswer, RequestFailure> answer, const SearchRun& run) {
  for (const std::string& note : run.notes()) complain(note);
  if (answer) {
    PlanAnswer& done = *answer;
    result_.notes = std::move(done.notes);
    result_.plan = std::move(done.plan);
    result_.times.search = done.search_seconds;
    result_.lead_out = std::move(done.lead_out);
    result_.remaining = done.remaining;
    if (done.fault) return take_fault(*done.fault, done.refined.has_value());
    if (done.refined) {
      request_.refinement.adjacency = moves_.adjacency();
      result_.refined = refined_path(result_.plan.path, request_.refinement,
                                     *std::move(done.refined), space_, request_.corner_rounding);
    }
    if (!done.trajectory) return;
    result_.trajectory = arguments_.trajectory.sampled(*std::move(done.trajectory));
    return;
  }
  result_.notes = run.notes();
  if (!result_.planned_as_disc.empty()) {
    result_.notes.push_back("the robot is " + result_.planned_as_disc);
  }
  result_.times.search = answer.error().search_seconds;
  result_.plan.metrics = answer.error().metrics;
  fail(answer.error().status, std::move(answer.error().message));
}

/// There is a path, but what was to be done with it cannot be done, or there is no time for it.
void PlanRun::take_fault(const Error& fault, bool refined) {
  if (!is_limit(fault.status)) {
    const bool of_trajectory = refined || !arguments_.refine.any();
    throw InputError((of_trajectory ? "the trajectory: " : "") + fault.message);
  }
  result_.plan.path.clear();
  fail(fault.status, fault.message);
}

/// Is the search looked at before it is over?
bool PlanRun::steps() const { return arguments_.watch.step || arguments_.watch.open_list; }

/// Of a search that is recorded.
const SearchRecorder& PlanRun::recorder() const {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): only what asks records() or searched() calls it
  return *recorder_;
}

/// Has it told anything?
bool PlanRun::searched() const { return recorder_ && !recorder_->expansions().empty(); }

/// Tells the open list on the way, if that is asked for.
std::optional<Status> PlanRun::go_on(SteppedSearch& search, const SearchRun& run) {
  if (arguments_.watch.open_list && search.expansions() == open_lists_told_) {
    tell(open_list_text(run.open_list(kMostOpenEntries), space_.map().frame()));
    ++open_lists_told_;
  }
  return search.go_on();
}

void PlanRun::step_to_the_end(SteppedSearch& search, SearchRun& run) {
  auto outcome = search.begin(run);
  while (!outcome) outcome = go_on(search, run);
}

void PlanRun::step_by_keys(SteppedSearch& search, SearchRun& run) {
  auto outcome = search.begin(run);
  if (outcome) return;
  // Lines of --verbose would come in between.
  Stepper stepper(screen_.is_terminal && !(arguments_.watch.verbose && progress_is_seen()));
  std::uint64_t next = 1;  // after how many expansions to show it
  while (!outcome) {
    if (search.expansions() < next) {
      outcome = go_on(search, run);
      continue;
    }
    const auto wanted = stepper.ask(step_text(search, run), search.expansions());
    if (!wanted) {
      outcome_is_shown_ = stepper.in_place();
      return run.cancel();
    }
    next = *wanted;
    if (next < search.expansions()) outcome = search.go_back_to(next);
  }
  stepper.finish();
}

void PlanRun::make_layers(const Planner& planner, const Limits& limits) {
  const auto& chosen = arguments_.layers;
  std::optional<Session::Field> field;
  if (chosen.any_from(LayerSource::cost_to_go)) {
    auto made = session_.cost_to_go(view_, goal_cells(space_, asked_), moves_, limits);
    if (made) field = *std::move(made);
  }
  for (const LayerKind kind : chosen.kinds()) {
    switch (source_of(kind)) {
      case LayerSource::search:
        if (!searched()) break;
        layers_.push_back(chosen.counted(search_layer(kind, planner, recorder())));
        break;
      case LayerSource::cost_to_go:
        if (field) layers_.push_back(cost_to_go_layer(kind, space_, *field->costs));
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

Scene PlanRun::scene() const { return query_scene(spec_, space_, asked_); }

/// A path may cross itself, as a random walk does, which arrows cannot show, and a search that was stopped has no path:
/// the cells that they visited are shown instead.
Scene PlanRun::outcome() const {
  Scene scene = this->scene();
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
  } else if (searched()) {
    scene.marked = {{CellRole::expanded, recorder().snapshot().expanded}};
  }
  return scene;
}

std::string PlanRun::step_text(const SteppedSearch& search, const SearchRun& run) const {
  const SearchSnapshot snapshot = recorder().snapshot();
  std::vector<Layer> layers;
  for (const LayerKind kind : arguments_.layers.kinds()) {
    if (source_of(kind) == LayerSource::search) {
      layers.push_back(arguments_.layers.as_numbers(
          arguments_.layers.counted(search_layer(kind, run.planner(), recorder()))));
    }
  }
  const OpenList open = run.open_list(kMostOpenEntries);
  const Frame& frame = space_.map().frame();
  const std::string keys = Stepper::keys(screen_.columns);
  const auto rows_below =
      kRowsOfStep + static_cast<int>(std::count(keys.begin(), keys.end(), '\n'));
  const std::string text =
      frame_text(with_snapshot(scene(), snapshot), layers, screen_, arguments_.pictures.style,
                 rows_below, [&](int rows) { return open_list_text(open, frame, rows); });
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
  if (found) text += plan_steps(result_, coordinates_, small);
  for (const Layer& layer : layers_) {
    text +=
        layer_text(outcome(), arguments_.layers.as_numbers(layer), screen_, arguments_.pictures);
  }
  std::string summary;
  if (found) summary += plan_summary(result_, coordinates_, asked_.goals.size());
  if (found && built_index_) {
    summary += "index     built for this query and not saved; `wend index build` saves it\n";
  }
  if (found && arguments_.times) summary += times_lines(result_.times);
  if (result_.refined) {
    summary += "\n" + refined_text(*result_.refined, coordinates_);
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

std::string PlanRun::csv() const {
  if (result_.status != Status::found) {
    return no_path_csv({std::string(to_string(result_.status)), result_.reason});
  }
  const Path& driven = result_.refined ? result_.refined->refined.path : result_.plan.path;
  return path_csv(driven, space_.map().frame());
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
  std::vector<Panel> panels{
      {fmt::format("no path: {}", to_string(result_.status)),
       gave_up ? outcome()
               : failure_scene(spec_, space_, asked_, result_.status, moves_, coordinates_),
       result_.reason}};
  if (layers_.empty()) return panels;
  for (Panel& panel : layer_panels(outcome(), layers_)) panels.push_back(std::move(panel));
  return panels;
}

Expected<std::string, Error> PlanRun::film() const {
  const Style style = style_of(arguments_.pictures.style);
  if (!searched()) return gif_of(panels().front().title, panels().front().scene, style);
  const FilmedSearch search{spec_.name, outcome(), &recorder()};
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
  if (arguments_.watch.animate && searched()) {
    play(outcome(), recorder(), screen_, arguments_.pictures, arguments_.watch.speed);
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
