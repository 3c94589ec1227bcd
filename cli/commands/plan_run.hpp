#pragma once

// One query of `wend plan`, from its arguments to its outcome.

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/refine_arguments.hpp"
#include "cli/arguments/request_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/arguments/trajectory_arguments.hpp"
#include "cli/arguments/typed_request.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/watching/shown_layers.hpp"
#include "cli/watching/stepped_search.hpp"
#include "cli/watching/watching.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/planner/planner.hpp"
#include "wend/render/scene.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/report/posthoc_trace.hpp"
#include "wend/session/session.hpp"

namespace wend::cli {

struct PlanArguments {
  MapArguments map;
  EndArguments ends;
  std::string queries;  // a file with many starts and goals, instead of `ends`
  std::uint64_t threads = ThreadWorkers().count();  // that answer them
  std::string planner;                              // empty: the index's, or else astar
  std::string index;
  OptionFlags options{"planner"};
  LimitArguments limits;
  RequestArguments request;
  TableFormat format = TableFormat::text;
  RefineArguments refine;
  TrajectoryArguments trajectory;
  PictureArguments pictures;
  ShownLayers layers;
  WatchArguments watch;
  bool times = false;  // of every stage, and memory, are told
  std::string plot;
  OutputFiles output;
};

/// Writes the reason of a failed plan to the path files, in place of an old path.
void write_failed_plan(const PlanArguments& arguments, const FailedPlan& plan);

class PlanRun {
 public:
  /// `times` are those of the work done for the query so far; the deadline is that of all the work. The session has a
  /// map and its free space.
  PlanRun(const PlanArguments& arguments, Session& session, PlannerSpec planner,
          IndexArgument index, const WorkTimes& times, Deadline deadline);

  /// Plans. Throws InputError for options out of range.
  void plan();

  /// Prints and writes the results.
  ExitCode report();

 private:
  Expected<WarmPlanner, Error> make_planner();
  void describe(const Planner& planner);
  PlanRequest request(ProgressBar& progress) const;
  void search();
  PosthocTrace trace_of(const Query& query) const;
  void run_to_the_end(SearchRun& run);
  std::optional<Status> go_on(SteppedSearch& search, const SearchRun& run);
  void step_to_the_end(SteppedSearch& search, SearchRun& run);
  void step_by_keys(SteppedSearch& search, SearchRun& run);
  void take(Expected<PlanAnswer, RequestFailure> answer, const SearchRun& run);
  void take_fault(const Error& fault, bool refined);
  void make_layers(const Planner& planner, const Limits& limits);
  void fail(Status status, std::string reason);

  bool records() const;
  bool steps() const;
  const SearchRecorder& recorder() const;
  bool searched() const;
  Scene scene() const;
  Scene outcome() const;
  std::string text() const;
  std::string step_text(const SteppedSearch& search, const SearchRun& run) const;
  std::vector<Panel> panels() const;
  std::string csv() const;
  std::string json() const;
  Expected<std::string, Error> film() const;
  void print_results();
  void write_files() const;
  void write_plot() const;
  void write_trace(PosthocTrace& trace) const;

  const PlanArguments& arguments_;
  Screen screen_ = detect_screen();
  Session& session_;
  PlannerSpec spec_;
  IndexArgument index_;
  Deadline deadline_;  // of all that is done for the query
  bool built_index_ = false;
  Session::View view_;
  const FreeSpace& space_;
  Coordinates coordinates_;
  PlanRequest request_;  // without limits and observers
  Query asked_;          // the same in grid coordinates; ends that were moved
  GridMoves moves_;      // of a planner on cells
  std::optional<SearchRecorder> recorder_;
  std::vector<Layer> layers_;
  PlanResult result_;
  std::uint64_t open_lists_told_ = 0;
  bool outcome_is_shown_ = false;  // on the terminal, by what was watched
};

}  // namespace wend::cli
