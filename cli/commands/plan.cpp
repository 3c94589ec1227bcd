// wend plan: a path from a start to a goal.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "cli/arguments/planner_argument.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/plan_queries.hpp"
#include "cli/commands/plan_run.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/plan_text.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/session.hpp"

namespace wend::cli {
namespace {

constexpr const char* kPlanExamples = R"(Examples:
  wend plan office.yaml --start 1,1 --goal 15,9 --robot-radius 0.2 -o plan.png
  wend plan arena.map --start 1,11 --goal 40,30 --planner astar --weight 2
  wend plan grid.txt --start 0,0 --goal 9,9 --connectivity 4 --format json
  wend plan office.yaml --cells --start 10,10 --goal 145,85 --nearest
  wend plan grid.txt --start 0,0 --goal 9,9 --show expansion,heuristic,policy
  wend plan grid.txt --start 0,0 --goal 9,9 --step --show g
  wend plan office.yaml --start 1,1 --goal 15,9 --trace office.trace.yaml
  wend plan arena.map --index arena.idx --start 1,11 --goal 40,30
  wend plan grid.txt --planner car --start 0,0,E --goal 9,9,any
  wend plan office.yaml --planner lattice --start 1,1,E --goal 15,9,N
  wend plan grid.txt --planner ara_star --limit-time 0.05 --start 0,0 --goal 9,9
  wend plan office.yaml --start 1,1 --goal 15,9 --smooth -o smooth.csv
  wend plan office.yaml --start 1,1 --goal 15,9 --smooth --trajectory drive.csv
  wend plan office.yaml --queries queries.csv --threads 4 -o answers.csv
  wend generate maze --size 21x11 | wend plan - --start 1,1 --goal 19,9 -o -

Small maps (up to 80 x 40 cells) show the path as (1,1)>(2,1)>(3,1) and the map
with arrows; large maps show a summary and, on a terminal, a picture. The paths
of hybrid_astar, lattice and car are printed as commands. Exit codes: 0 found,
1 no path (standard error gives the reason), 2 bad usage or input.)";

/// The planner that was asked for, else the one that the index is for.
std::string planner_text(const PlanArguments& arguments, const IndexArgument& index) {
  if (!arguments.planner.empty()) return arguments.planner;
  if (!arguments.map.primitives.empty()) return "lattice";
  if (!index) return "astar";
  const bool known = *index && planners().find((*index)->header.planner_name()) != nullptr;
  if (known) return std::string((*index)->header.planner_name());
  return "hub_labels";  // only to say what is wrong with the index
}

/// Throws InputError where the constant of a heuristic is given and another heuristic is used.
void check_constant(const PlannerSpec& planner) {
  bool given = false;
  std::string heuristic;
  for (const auto& [name, value] : planner.options) {
    given |= name == "constant";
    if (name == "heuristic") heuristic = value;
  }
  if (!given || heuristic == "constant") return;
  throw InputError("--constant changes nothing: it is that of --heuristic constant");
}

/// Throws InputError where the file of --primitives is not used.
void check_primitives(const PlanArguments& arguments, const PlannerSpec& planner) {
  if (arguments.map.primitives.empty()) return;
  if (info_of(planner).capabilities.primitives) return;
  throw InputError(
      fmt::format("--primitives changes nothing for the planner {}: use "
                  "--planner lattice",
                  planner.name));
}

/// With some options at least: which ones, a made planner says.
bool can_be_anytime(const PlannerInfo& info) {
  return std::ranges::any_of(
      info.options, [](const OptionInfo& option) { return option.name == "initial_weight"; });
}

/// Throws InputError where --plot has nothing to plot.
void check_plot(const PlanArguments& arguments, const PlannerSpec& planner) {
  if (arguments.plot.empty()) return;
  if (!can_be_anytime(info_of(planner))) {
    throw InputError(
        fmt::format("--plot changes nothing for the planner {}, which finds one path: use "
                    "--planner ara_star",
                    planner.name));
  }
  if (arguments.watch.step || arguments.watch.open_list) {
    throw InputError("--plot cannot be combined with --step and --open-list");
  }
  plot_kind_of(arguments.plot);
  check_folder(arguments.plot, "--plot " + arguments.plot);
  require_gnuplot();
}

/// Options that the command sets with a flag of its own: a smoother has one, too.
bool has_flag_of_its_own(const OptionInfo& option) { return option.name == "turning_radius"; }

/// The only thing that is printed or written is the path as CSV.
bool is_csv_alone(const PlanArguments& arguments) {
  const OutputFiles& output = arguments.output;
  const bool prints_csv = arguments.format == TableFormat::csv ||
                          (output.print() && arguments.format == TableFormat::text);
  return prints_csv && !output.any_picture() && !output.any(".json");
}

/// Throws InputError for flags that were given and change nothing.
void check_idle(const Parser& plan, const PlanArguments& arguments) {
  arguments.request.check(plan);
  const OutputFiles& output = arguments.output;
  if (!arguments.queries.empty()) {
    refuse_idle(plan,
                {"--picture", "--style", "--open-list", "--unsafe", "--corner-rounding",
                 "--trajectory", "--plot", "--times"},
                "--queries only answers queries; it draws, smooths and times nothing");
  }
  arguments.pictures.check(plan, output.any_picture() || !arguments.plot.empty(),
                           arguments.format == TableFormat::text && !output.print());
  if (arguments.format != TableFormat::text || output.print()) {
    refuse_idle(plan, {"--times"}, "it is for text; JSON always has them");
  }
  if (!arguments.layers.any_order()) {
    refuse_idle(plan, {"--count-from"}, "it needs --show expansion or --show generation");
  }
  if (is_csv_alone(arguments)) {
    refuse_idle(plan, {"--show"}, "a CSV file has no layers; use -o FILE.png or JSON");
  }
  arguments.trajectory.check(plan, output);
  if (!arguments.refine.any() && !arguments.trajectory.wanted()) {
    refuse_idle(plan, {"--corner-rounding"},
                "it needs --simplify, --smooth, --resample or --trajectory");
  }
  if (!arguments.watch.animate && !output.any(".gif")) {
    refuse_idle(plan, {"--speed"}, "it needs --animate or -o FILE.gif");
  }
  if (arguments.watch.trace.empty()) {
    refuse_idle(plan, {"--trace-limit"}, "name the trace with --trace FILE");
  }
  if (arguments.queries.empty()) {
    refuse_idle(plan, {"--threads"}, "name the queries with --queries FILE");
  }
}

void check(const PlanArguments& arguments) {
  arguments.output.check();
  arguments.trajectory.limits();  // wrong ones are refused before the search
  if (!arguments.queries.empty()) return check_queries(arguments);
  if (arguments.ends.start.empty()) throw InputError("--start is required, or --queries FILE");
  if (arguments.ends.goals.empty()) throw InputError("--goal is required, or --queries FILE");
  arguments.watch.check(detect_screen());
  if (arguments.watch.step && arguments.format != TableFormat::text) {
    throw InputError("--step cannot be combined with --format json or csv");
  }
  if (arguments.output.print() && (arguments.watch.step || arguments.watch.animate)) {
    throw InputError(
        "-o - writes only the path to standard output: leave out --step and --animate");
  }
}

/// If a map does not fit into memory, or its free space is not made in time, the path files say so.
std::unique_ptr<Session> session_for(const PlanArguments& arguments, const GridMap& map,
                                     const PlannerSpec& planner, const Deadline& deadline) {
  const std::size_t planners = arguments.queries.empty() ? 1 : arguments.threads;
  try {
    return arguments.map.session(map, planners, info_of(planner).bytes_per_cell, deadline);
  } catch (const NoPathError& error) {
    write_failed_plan(arguments, error.plan());
    throw;
  }
}

int run(const PlanArguments& arguments) {
  check(arguments);
  WorkTimes times;
  IndexArgument index;
  if (!arguments.index.empty()) {
    index = timed(thread_cpu_seconds, times.index.emplace(0),
                  [&] { return read_given_index(arguments.index); });
  }
  PlannerSpec planner = parse_planner(planner_text(arguments, index));
  const OptionValues flags = arguments.options.values_for(planner.name);
  planner.options.insert(planner.options.end(), flags.begin(), flags.end());
  check_constant(planner);
  check_primitives(arguments, planner);
  check_plot(arguments, planner);
  const LoadedMap loaded =
      timed(thread_cpu_seconds, times.load, [&] { return arguments.map.load_map(); });
  arguments.refine.steer(planner, arguments.map.coordinates(loaded.map));
  arguments.output.check_not_among(loaded.files);
  arguments.trajectory.check_not_among(loaded.files);
  if (!arguments.index.empty()) {
    arguments.output.check_not_among({arguments.index});
    arguments.trajectory.check_not_among({arguments.index});
  }
  check_not_among(loaded.files, arguments.watch.trace, "--trace " + arguments.watch.trace);
  check_not_among(loaded.files, arguments.plot, "--plot " + arguments.plot);
  // Of many queries, each has a limit of its own.
  const Deadline deadline = arguments.queries.empty() ? arguments.limits.deadline() : Deadline();
  const auto session = timed(thread_cpu_seconds, times.free_space,
                             [&] { return session_for(arguments, loaded.map, planner, deadline); });
  if (!arguments.queries.empty()) return run_queries(arguments, *session, planner, index);
  PlanRun run(arguments, *session, std::move(planner), std::move(index), times, deadline);
  run.plan();
  return run.report();
}

}  // namespace

Command add_plan(Parser& app) {
  Parser plan = app.add_subcommand("plan", "Plan a path from a start to a goal");
  const auto arguments = std::make_shared<PlanArguments>();
  arguments->map.add_to(plan);
  arguments->map.add_clearance_cost_to(plan);
  arguments->map.add_primitives_to(plan);
  plan.add_option("--start", arguments->ends.start,
                  wrapped("Start of the path: metres, or cells on maps without a resolution and "
                          "with --cells. For the planners hybrid_astar, "
                          "lattice and car also a heading: N, W, E, S or an angle such as 45deg "
                          "(car starts at a grid vertex, lattice in the middle of a cell)"))
      .type_name("X,Y[,HEADING]");
  add_texts(plan, "--goal", arguments->ends.goals,
            "Goal of the path; if given several times, the goal with the lowest path cost. The "
            "heading may be left out or any")
      .type_name("X,Y[,HEADING]");
  add_goal_tolerance(plan, arguments->ends.tolerance);
  plan.add_option("--queries", arguments->queries,
                  wrapped("Answer every row of a CSV file instead. Its header names the columns "
                          "start_x, start_y, goal_x and goal_y, or start and goal; each row gets a "
                          "status, a reason and the cost and length of the path"))
      .type_name(kFileType);
  add_count(
      plan, "--threads", arguments->threads,
      "Number of threads that answer --queries, each with its own planner (default: all cores)");
  arguments->request.add_others_to(plan);
  plan.add_option("--planner", arguments->planner,
                  wrapped("Planner (default astar); `wend planners` lists all. Options may follow, "
                          "as in astar:weight=2"))
      .type_name(kPlannerType);
  plan.add_option("--index", arguments->index,
                  wrapped("Index of the map, built by `wend index build`; without --planner, the "
                          "planner is the one that the index is for"))
      .type_name(kFileType);
  arguments->refine.add_to(plan);
  arguments->trajectory.add_file_to(plan);
  arguments->trajectory.add_limits_to(plan);
  arguments->limits.add_to(plan);
  add_choice<TableFormat>(
      plan, "--format", arguments->format,
      {{"text", TableFormat::text}, {"json", TableFormat::json}, {"csv", TableFormat::csv}},
      "Format of the output: text (the default), all results as JSON, or the path as CSV");
  plan.add_flag("--times", arguments->times, wrapped(kTimesHelp));
  arguments->layers.add_to(plan);
  arguments->layers.add_counting_to(plan);
  arguments->pictures.add_to(plan);
  arguments->output.add_to(plan, {".png", ".svg", ".pdf", ".gif", ".csv", ".json"},
                           "Also write a picture (.png, .svg, .pdf), an animation of the search "
                           "(.gif), the path (.csv, after any smoothing) or the JSON; may be given "
                           "several times. If there is no path, the file states the reason instead",
                           "the path (JSON with --format json, else CSV)");
  plan.add_option("--plot", arguments->plot,
                  wrapped("With --planner ara_star: plot the cost of the best path and its proven "
                          "lower bound over time (.png, .svg, .pdf); needs gnuplot"))
      .type_name(kFileType);
  arguments->watch.add_to(plan);
  for (const PlannerInfo& planner : planners()) {
    std::vector<OptionInfo> options = planner.options;
    std::erase_if(options, has_flag_of_its_own);
    arguments->options.collect(planner.name, options);
  }
  for (const PlannerInfo& planner : planners()) {
    std::vector<OptionInfo> options = planner.options;
    std::erase_if(options, std::not_fn(has_flag_of_its_own));
    arguments->options.mention(planner.name, options);
  }
  arguments->options.add_to(plan, "--planner");
  plan.further({"--goal-tolerance", "--threads", "--index", "--plot"});
  plan.footer(kPlanExamples);
  return {plan, [plan, arguments] {
            check_idle(plan, *arguments);
            return run(*arguments);
          }};
}

}  // namespace wend::cli
