#pragma once

// One query of `wend plan`, from its arguments to its outcome.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/leeway_arguments.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/refine_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/arguments/trajectory_arguments.hpp"
#include "cli/commands/typed_query.hpp"
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
#include "wend/session/eased_query.hpp"
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
  LeewayArguments leeway;
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
  Limits limits_left(ProgressBar& progress) const;
  void search();
  void search_to_the_end(Query query);
  void note_what_was_eased(const EasedQuery& eased, const Explainer& explainer);
  Ends ends_of(const EasedQuery& eased) const;
  void put_lead_before(const EasedQuery& eased);
  void search_for(SearchObserver& observer, Query query);
  Status search_in_steps(const Query& query, SearchRecorder& recorder, ObserverList& told);
  std::optional<Status> go_on(SteppedSearch& search);
  Status step_to_the_end(SteppedSearch& search);
  Status step_by_keys(SteppedSearch& search, const SearchRecorder& recorder);
  void refine_path();
  void give_up(const Error& why);
  void time_path();
  void make_layers(const Limits& limits);
  void fail(Status status, std::string reason);

  bool records() const;
  bool steps() const;
  Scene outcome() const;
  std::string text() const;
  std::string step_text(const SteppedSearch& search, const SearchRecorder& recorder) const;
  std::vector<Panel> panels() const;
  const Path& path() const;
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
  FreeSpace space_;
  std::unique_ptr<TypedQuery> asked_;
  std::unique_ptr<WarmPlanner> planner_;  // null until it is made
  GridMoves moves_;                       // of a planner on cells
  std::optional<SearchRecorder> recorder_;
  std::vector<Layer> layers_;
  Refinement refinement_;
  PlanResult result_;
  std::uint64_t open_lists_told_ = 0;
  bool outcome_is_shown_ = false;  // on the terminal, by what was watched
};

}  // namespace wend::cli
