#include "cli/commands/stop_arguments.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/exit_code.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/query/stop_csv.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

void StopArguments::add_to(Parser& app) {
  map.add_to(app);
  map.add_clearance_cost_to(app);
  map.add_primitives_to(app);
  app.add_option("--stops", stops,
                 wrapped("CSV file of the stops: the header names the columns x and y, and heading "
                         "for planners with headings; metres, or cells on maps without a "
                         "resolution and with --cells. Rows count from 0"))
      .required()
      .type_name(kFileType);
  app.add_option("--planner", planner,
                 wrapped("Planner whose costs count (default astar). With hub_labels or "
                         "euclidean_labels the costs of many stops take microseconds each"))
      .type_name(kPlannerType);
  app.add_option("--index", index,
                 wrapped("Index of the map, built by `wend index build`; else a planner that needs "
                         "one builds it"))
      .type_name(kFileType);
  add_count(app, "--threads", threads, "Number of threads (default: all cores)");
  limits.add_to(app);
  for (const PlannerInfo& info : planners()) options.collect(info.name, info.options);
  options.add_to(app, "--planner");
  app.further({"--threads", "--index"});
}

StopsOnMap::StopsOnMap(const StopArguments& arguments, const OutputFiles& output)
    : workers_(static_cast<unsigned>(arguments.threads)) {
  output.check();
  IndexArgument index;
  if (!arguments.index.empty()) index = read_given_index(arguments.index);
  std::string name = arguments.planner;
  if (name.empty()) name = index && *index ? std::string((*index)->header.planner_name()) : "astar";
  planner_ = parse_planner(name);
  const OptionValues flags = arguments.options.values_for(planner_.name);
  planner_.options.insert(planner_.options.end(), flags.begin(), flags.end());
  const LoadedMap loaded =
      timed(thread_cpu_seconds, times_.load, [&] { return arguments.map.load_map(); });
  output.check_not_among(loaded.files);
  output.check_not_among({arguments.stops});
  deadline_ = arguments.limits.deadline();
  session_ = timed(thread_cpu_seconds, times_.free_space, [&] {
    return arguments.map.session(loaded.map, arguments.threads, info_of(planner_).bytes_per_cell,
                                 deadline_);
  });
  view_ = value_or_throw(session_->view());
  coordinates_ = arguments.map.coordinates(loaded.map);
  value_or_throw(provide_index(*session_, planner_, index, times_, deadline_));
  add_rows(arguments.stops);
}

void StopsOnMap::add_rows(const std::string& file) {
  const auto rows = value_or_throw(load_stop_csv(file));
  if (rows.empty()) throw InputError(file + ": there are no stops");
  for (std::size_t row = 0; row < rows.size(); ++row) {
    try {
      add_place({}, rows[row]);
    } catch (const InputError& error) {
      const std::string_view wrong = error.what();  // "--: ..."
      throw InputError(fmt::format("{}: stop {}{}", file, row, wrong.substr(wrong.find(':'))));
    }
  }
  stops_of_file_ = stops_.size();
}

int StopsOnMap::add_place(const std::string& name, const std::string& typed) {
  const FreeSpace& space = view_->space;
  const PlannerInfo& info = info_of(planner_);
  Pose pose;
  if (info.capabilities.headings) {
    const TypedPose read =
        parse_start_pose(*coordinates_, typed, places_of(info, space, planner_.options));
    pose = {read.point.x, read.point.y, read.heading.value_or(0)};
  } else {
    const Point point = coordinates_->parse_in_grid(name, typed);
    pose = {point.x, point.y, 0};
  }
  stops_.push_back(frame().to_metres(pose));
  names_.push_back(name);
  return static_cast<int>(stops_.size()) - 1;
}

StopCosts StopsOnMap::costs() {
  auto found = timed(thread_cpu_seconds, times_.search,
                     [&] { return stop_costs(*session_, *view_, stops_, options()); });
  if (found) return *std::move(found);
  const Error& error = found.error();
  if (error.status == Status::invalid_option) throw InputError(error.message);
  throw NoPathError(error.message, {std::string(to_string(error.status)), error.message});
}

}  // namespace wend::cli
