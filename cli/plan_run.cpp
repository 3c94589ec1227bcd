#include "plan_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "frame.hpp"
#include "observer_list.hpp"
#include "open_list_text.hpp"
#include "output.hpp"
#include "picture_files.hpp"
#include "planner_argument.hpp"
#include "search_frames.hpp"
#include "stepped_search.hpp"
#include "stepper.hpp"
#include "wend/io/path_csv.hpp"
#include "wend/parallel/thread_workers.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/plan_json.hpp"
#include "wend/report/thread_time.hpp"

namespace wend::cli {

namespace {

constexpr int kRowsOfStep = 2;  // what is expanded, and the cursor

}  // namespace

PlanRun::PlanRun(const PlanArguments& arguments, PlannerSpec planner, FreeSpace space,
                 std::optional<Expected<GivenIndex, std::string>> index, const WorkTimes& times)
    : arguments_(arguments),
      spec_(std::move(planner)),
      space_(std::move(space)),
      index_(std::move(index)),
      asked_(typed_query(spec_, space_, arguments.map.coordinates(space_.map()), arguments.ends)),
      refinement_(arguments.refine.refinement(arguments.map.coordinates(space_.map()),
                                              moves_of(spec_).adjacency())) {
  result_.times = times;
  asked_->check(arguments.layers);
  if (!arguments.refine.any() || info_of(spec_).motion == Motion::cells) return;
  throw InputError(fmt::format(
      "--simplify, --smooth and --resample are for paths from cell to cell: what the planner {} "
      "drives is made of arcs, which are to stay as they are",
      spec_.name));
}

/// On large maps a search is slowed down only for those who ask for what it did.
bool PlanRun::records() const {
  const WatchArguments& watch = arguments_.watch;
  return is_small(space_.map(), Screen{}) || steps() || watch.animate ||
         arguments_.layers.any_from(LayerSource::search) || arguments_.output.any(".gif");
}

/// Layers are drawn over the map alone.
bool PlanRun::draws_outcome() const {
  const auto extensions = picture_extensions();
  const auto is_asked_for = [this](const std::string& extension) {
    return arguments_.output.any(extension);
  };
  return arguments_.layers.kinds().empty() &&
         std::any_of(extensions.begin(), extensions.end(), is_asked_for);
}

void PlanRun::plan() {
  result_.planner = spec_.name;
  result_.motion = info_of(spec_).motion;
  if (arguments_.nearest) {
    for (const auto& note : asked_->move_to_nearest()) complain(note);
  }
  auto planner = make_planner();
  if (planner) {
    planner_ = *std::move(planner);
    result_.states = planner_->state_count();
    result_.unit = planner_->corner_unit();
    search();
  } else if (planner.error().status == Status::invalid_option) {
    throw InputError(planner.error().message());
  } else {
    fail(planner.error().status, planner.error().message());
  }
}

/// On the index that was given, else on one that is built now if the planner needs one.
PlannerResult PlanRun::make_planner() {
  if (index_ && !*index_) {
    return Unexpected<PlannerError>({Status::index_mismatch, index_->error()});
  }
  const PlannerInfo& info = info_of(spec_);
  if (!index_ && info.build_index) return make_planner_on_new_index(info);
  return timed(thread_cpu_seconds, result_.times.planner.emplace(0), [&] {
    return index_ ? wend::make_planner(spec_.name, space_, spec_.options, (*index_)->bytes)
                  : info.make(space_, spec_.options);
  });
}

PlannerResult PlanRun::make_planner_on_new_index(const PlannerInfo& info) {
  ThreadWorkers workers;
  auto index = timed(process_cpu_seconds, result_.times.index.emplace(0),
                     [&] { return build_index(info, space_, workers); });
  if (!index) return Unexpected<PlannerError>(index.error());
  built_index_ = true;
  return timed(thread_cpu_seconds, result_.times.planner.emplace(0),
               [&] { return info.make_on_index(space_, spec_.options, *std::move(index)); });
}

void PlanRun::search() {
  ProgressBar progress("planning", result_.states);
  Query query = asked_->query();
  query.limits = arguments_.limits.limits(progress);
  ObserverList told;
  Narrator narrator;
  if (arguments_.watch.verbose) told.add(narrator);
  if (records()) recorder_.emplace(asked_->recorder());
  std::optional<PosthocTrace> trace;
  if (!arguments_.watch.trace.empty()) {
    told.add(
        trace.emplace(asked_->trace(arguments_.watch.trace_form(), arguments_.watch.trace_limit)));
  }
  if (steps()) {
    result_.status = search_in_steps(query, *recorder_, told);
  } else {
    search_to_the_end(query);
    if (recorder_) told.add(*recorder_);
    const bool cancelled = result_.status == Status::cancelled;
    if (!told.empty() && !cancelled) search_for(told, query);
  }
  if (result_.status != Status::found) {
    fail(result_.status,
         asked_->reason(*planner_, result_.status, query.limits, result_.plan.metrics));
    if (draws_outcome()) failure_ = asked_->failure_scene(result_.status);
  }
  if (result_.status == Status::found && arguments_.refine.any()) refine_path();
  if (trace && result_.status != Status::cancelled) write_trace(*trace);
  make_layers(query.limits);
}

void PlanRun::search_to_the_end(const Query& query) {
  const Interruptible interruptible;  // what it did until then is reported
  result_.status = timed(thread_cpu_seconds, result_.times.search,
                         [&] { return planner_->plan(query, result_.plan); });
}

/// The same search again, as far as it went: what an observer does takes time that is none of the
/// search's. Ctrl-C ends the program meanwhile.
void PlanRun::search_for(SearchObserver& observer, Query query) {
  query.limits = {};
  query.limits.expansions = result_.plan.metrics.expanded;
  query.observer = &observer;
  Plan plan;
  planner_->plan(query, plan);
}

/// Is the search looked at before it is over?
bool PlanRun::steps() const { return arguments_.watch.step || arguments_.watch.open_list; }

/// Only the search is timed, not the person.
Status PlanRun::search_in_steps(const Query& query, SearchRecorder& recorder, ObserverList& told) {
  if (!info_of(spec_).can_step) {
    throw InputError(fmt::format("{}: the planner {} cannot be stepped",
                                 arguments_.watch.step ? "--step" : "--open-list", spec_.name));
  }
  SteppedSearch search(*planner_, query, recorder, told, result_.plan);
  const Status status =
      arguments_.watch.step ? step_by_keys(search, recorder) : step_to_the_end(search);
  result_.times.search = search.seconds();
  return status;
}

/// Tells the open list on the way, if that is asked for.
std::optional<Status> PlanRun::go_on(SteppedSearch& search) {
  if (arguments_.watch.open_list && search.expansions() == open_lists_told_) {
    tell(open_list_text(planner_->open_list(kMostOpenEntries)));
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
  result_.refined = refine(result_.plan.path, space_, refinement_,
                           arguments_.refine.rounding(arguments_.map.coordinates(space_.map())));
}

void PlanRun::make_layers(const Limits& limits) {
  std::optional<CostToGo> field;
  if (arguments_.layers.any_from(LayerSource::cost_to_go)) field = asked_->cost_to_go(limits);
  const bool searched = recorder_ && !recorder_->expansions().empty();
  layers_.clear();
  for (const LayerKind kind : arguments_.layers.kinds()) {
    switch (source_of(kind)) {
      case LayerSource::search:
        if (searched) layers_.push_back(search_layer(kind, *planner_, *recorder_));
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

/// A random walk crosses itself, which arrows cannot show, and a search that was stopped has no
/// path: the cells that they visited are shown instead.
Scene PlanRun::outcome() const {
  if (failure_) return *failure_;
  Scene scene = asked_->scene();
  if (result_.refined) {
    scene.lines = lines_of(*result_.refined);
    return scene;
  }
  const bool walked = spec_.name == "random_walk" && recorder_;
  if (!walked && !result_.plan.path.empty()) {
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
      layers.push_back(search_layer(kind, *planner_, recorder));
    }
  }
  const OpenList open = planner_->open_list(kMostOpenEntries);
  const std::string keys = Stepper::keys(screen_.columns);
  const auto rows_below =
      kRowsOfStep + static_cast<int>(std::count(keys.begin(), keys.end(), '\n'));
  const std::string text = frame_text(with_snapshot(asked_->scene(), snapshot), layers, screen_,
                                      arguments_.pictures.style, rows_below,
                                      [&open](int rows) { return open_list_text(open, rows); });
  const auto& event = search.last_expansion();
  return text +
         fmt::format("expansion {}: {}, frontier {}\n", search.expansions(),
                     event ? event_text(*event) : "not begun", open.count) +
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
    text += layer_text(outcome(), layer, screen_, arguments_.pictures);
  }
  std::string summary;
  if (found) summary += asked_->summary(result_);
  if (found && built_index_) {
    summary += "index     built for this query and not kept: `wend index build` keeps it\n";
  }
  if (result_.refined) {
    summary += "\n" + refined_text(*result_.refined, arguments_.map.coordinates(space_.map()));
  }
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
  complain(fmt::format("{}: the trace ends after {} events, {} more are left out (--trace-limit)",
                       watch.trace, watch.trace_limit, trace.dropped()));
}

void PlanRun::write_files() const {
  const Frame& frame = space_.map().frame();
  const StyleName style = arguments_.pictures.style;
  auto writers = picture_writers(layer_panels(outcome(), layers_), style);
  writers[".json"] = [&](const std::string& file) {
    return write_bytes(file, plan_json(result_, frame, layers_));
  };
  if (recorder_ && !recorder_->expansions().empty()) {
    writers[".gif"] = [&](const std::string& file) {
      return write_picture(file,
                           gif_of(outcome(), *recorder_, arguments_.watch.speed, style_of(style)));
    };
  }
  if (result_.status == Status::found) {
    writers[".csv"] = [&](const std::string& file) {
      const Path& path = result_.refined ? result_.refined->refined.path : result_.plan.path;
      const auto written = save_path_csv(path, frame, file);
      return written ? std::string() : written.error().message();
    };
  }
  arguments_.output.write(writers);
}

ExitCode PlanRun::report() {
  const bool searched = recorder_ && !recorder_->expansions().empty();
  if (arguments_.watch.animate && searched) {
    play(outcome(), *recorder_, screen_, arguments_.pictures, arguments_.watch.speed);
    outcome_is_shown_ = true;
  }
  if (arguments_.format == Format::json) {
    print(plan_json(result_, space_.map().frame(), layers_));
  } else {
    print(text());
  }
  write_files();
  if (result_.status == Status::found) return success;
  complain(result_.reason);
  return no_plan;
}

}  // namespace wend::cli
