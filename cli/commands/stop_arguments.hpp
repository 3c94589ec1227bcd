#pragma once

// What `wend matrix` and `wend tour` share: the stops, the robot, the planner whose costs count.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/arguments/parser.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/output/output.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/session/session.hpp"
#include "wend/tour/stop_costs.hpp"

namespace wend::cli {

struct StopArguments {
  MapArguments map;
  std::string stops;
  std::string planner;
  std::string index;
  OptionFlags options{"planner"};
  LimitArguments limits;
  std::uint64_t threads = ThreadWorkers().count();

  void add_to(Parser& app);
};

/// A session with the stops of a file, and what ways between them cost.
class StopsOnMap {
 public:
  /// Reads map and stops and makes the planner. Throws InputError and NoPathError. `output` must not overwrite what is read.
  StopsOnMap(const StopArguments& arguments, const OutputFiles& output);

  /// Adds a place that is typed as `name`, --start for example; returns its row.
  int add_place(const std::string& name, const std::string& typed);

  /// Throws NoPathError for a stop where the robot cannot be, and if a limit was reached.
  StopCosts costs();

  StopCostOptions options() const { return {planner_, deadline_.left(), &workers_, names_}; }
  Session& session() { return *session_; }
  const Session::View& view() const { return *view_; }
  const PlannerSpec& planner() const { return planner_; }
  const std::vector<MapPose>& stops() const { return stops_; }
  std::size_t stops_of_file() const { return stops_of_file_; }
  const Deadline& deadline() const { return deadline_; }
  const Frame& frame() const { return view_->space.map().frame(); }
  WorkTimes& times() { return times_; }

 private:
  void add_rows(const std::string& file);

  PlannerSpec planner_;
  Deadline deadline_;
  mutable ThreadWorkers workers_;
  WorkTimes times_;
  std::unique_ptr<Session> session_;
  std::optional<Session::View> view_;
  std::optional<Coordinates> coordinates_;
  std::vector<MapPose> stops_;
  std::vector<std::string> names_;  // empty: that of a row
  std::size_t stops_of_file_ = 0;
};

}  // namespace wend::cli
