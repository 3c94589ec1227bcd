// wend compare: planners beside each other, on one query or on many.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>
#include <string_view>
#include <utility>

#include "bench/comparison/comparison.hpp"
#include "bench/comparison/comparison_plot.hpp"
#include "bench/comparison/comparison_run.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/request_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/arguments/typed_request.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/query_scene.hpp"
#include "cli/output/terminal.hpp"
#include "cli/watching/films.hpp"
#include "cli/watching/watching.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {
namespace {

struct CompareArguments {
  MapArguments map;
  EndArguments ends;
  std::string planners;  // empty: kTeachers, or all for headings
  std::uint64_t random = 0;
  std::uint64_t seed = 1;
  LimitArguments limits;
  RequestArguments request;
  TableFormat format = TableFormat::text;
  StyleName style = StyleName::light;
  std::optional<double> speed;
  OutputFiles output;
  std::string plot;
};

constexpr std::uint64_t kMostQueries = 1'000'000;

constexpr const char* kCompareExamples = R"(Examples:
  wend compare office.yaml --start 1,1 --goal 15,9
  wend compare office.yaml --start 1,1 --goal 15,9 -o compare.png
  wend compare office.yaml --start 1,1 --goal 15,9 -o compare.gif
  wend compare grid.txt --start 0,0 --goal 9,9 --planner astar:w=2,bfs
  wend compare office.yaml --random 200 --planner astar,bfs --plot plots.png
  wend compare grid.txt --start 0,0,E --goal 9,9 --planner car,car:w=2

Runs six planners that differ most, or those of --planner, on one query or on N
random queries. Car planners are compared with car planners only. The picture
has a panel for each planner with the cells that it expanded. Plots need
gnuplot. Exit codes: 0
a path was found, 1 no path was found, 2 bad usage or input.)";

/// Planners on cells that show what there is to learn, the best teachers first; those that refuse costs are left out
/// where cells have some.
constexpr std::array<std::string_view, 9> kTeachers{
    "bfs", "dijkstra", "greedy", "astar", "jps", "any_angle", "alt", "theta_star", "dfs"};
constexpr std::size_t kMostByDefault = 6;

bool refuses(const PlannerInfo& info, const FreeSpace& space) {
  return !space.uniform_terrain() && terrain_in_words(info) == "refused";
}

/// All planners that need headings as the typed start and the robot do, or six of those on cells.
std::vector<PlannerSpec> default_planners(const std::string& start, const FreeSpace& space) {
  std::vector<PlannerSpec> specs;
  const auto add = [&](const PlannerInfo& info) { specs.push_back({info.name, {}, info.name}); };
  const bool primitives = space.robot().primitives.has_value();
  if (!primitives && !has_heading(start)) {
    for (const std::string_view name : kTeachers) {
      const PlannerInfo& info = *planners().find(name);
      if (specs.size() < kMostByDefault && !refuses(info, space)) add(info);
    }
    return specs;
  }
  for (const PlannerInfo& info : planners()) {
    const Capabilities& can = info.capabilities;
    const bool fits = can.headings && can.primitives == primitives && !info.index_support;
    if (fits && !refuses(info, space)) add(info);
  }
  return specs;
}

/// Where the states of all planners may lie: on vertices that their lattices share.
PlaceGrid common_places(const std::vector<PlannerSpec>& planners, const FreeSpace& space) {
  std::int64_t spacing = 1;
  for (const PlannerSpec& planner : planners) {
    const PlaceGrid places = places_of(info_of(planner), space, planner.options);
    spacing = std::lcm(spacing, places.spacing);
    spacing =
        std::min<std::int64_t>(spacing, std::numeric_limits<int>::max());  // no map is so large
  }
  return corners_of(space, static_cast<int>(spacing));
}

void check(const CompareArguments& arguments) {
  const EndArguments& ends = arguments.ends;
  const bool pair = !ends.start.empty() || !ends.goals.empty();
  if (pair && arguments.random > 0) {
    throw InputError("--random chooses the starts and goals: leave out --start and --goal");
  }
  if (arguments.random == 0 && (ends.start.empty() || ends.goals.empty())) {
    throw InputError("give one query with --start X,Y --goal X,Y, or many queries with --random N");
  }
  if (arguments.random > kMostQueries) {
    throw InputError(fmt::format("--random {}: at most {}", arguments.random, kMostQueries));
  }
  const bool picture = arguments.output.any_picture();
  if (picture && arguments.random > 0) {
    throw InputError("-o with a picture supports one query only; for many queries use --plot");
  }
  if (arguments.plot.empty()) return;
  if (arguments.random == 0) throw InputError("--plot needs many queries: add --random N");
  plot_kind_of(arguments.plot);
  check_folder(arguments.plot, "--plot " + arguments.plot);
  require_gnuplot();
}

/// What was asked as one of the planners understands it.
Query query_for(const PlannerSpec& planner, const CompareArguments& arguments,
                const FreeSpace& space) {
  const Coordinates coordinates = arguments.map.coordinates(space.map());
  return query_of(typed_request(planner, space, coordinates, arguments.ends), space.map().frame());
}

std::vector<Query> random_queries(const ComparisonRun& run, const CompareArguments& arguments,
                                  const FreeSpace& space) {
  if (run.comparison().capabilities.headings) {
    auto drives = random_drives(space, common_places(run.planners(), space), arguments.random,
                                arguments.seed);
    if (drives.empty())
      throw InputError("--random: no two lattice vertices of this map are connected");
    return drives;
  }
  std::vector<Query> queries;
  for (const CellPair& cells : random_pairs(space, arguments.random, arguments.seed)) {
    queries.push_back(Query::between(cells.start, cells.goal));
  }
  if (queries.empty()) throw InputError("--random: no two cells of this map are connected");
  return queries;
}

std::vector<Query> queries_of(const ComparisonRun& run, const CompareArguments& arguments,
                              const FreeSpace& space) {
  if (arguments.random > 0) return random_queries(run, arguments, space);
  return {query_for(run.planners().front(), arguments, space)};
}

void answer_all(ComparisonRun& run, std::vector<Query> queries, const LimitArguments& limits) {
  ProgressBar progress("comparing", queries.size());
  ProgressBar within_a_query("", 0);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    queries[i].limits = limits.limits(within_a_query);
    run.answer(std::move(queries[i]));
    progress.update(i + 1);
  }
}

/// Says why planners found nothing, as `wend plan` does.
void give_reasons(ComparisonRun& run, const CompareArguments& arguments, const FreeSpace& space) {
  const Coordinates coordinates = arguments.map.coordinates(space.map());
  const Limits limits = arguments.limits.limits();
  for (ComparedQuery& query : run.comparison().queries) {
    Ends ends{coordinates.place("start", cell_at(query.start.point())), {}};
    for (const Goal& goal : query.goals) {
      ends.goals.push_back(coordinates.place("goal", cell_at(goal.point)));
    }
    for (std::size_t i = 0; i < query.rows.size(); ++i) {
      ComparisonRow& row = query.rows[i];
      const SearchMetrics metrics{row.expanded, row.generated, row.max_frontier};
      Explainer explainer = explainer_for(space, coordinates, run.grid_moves(i));
      explainer.allow(arguments.request.leeway(coordinates));
      if (is_limit(row.status)) {
        row.reason = explainer.stopped(row.status, limits, metrics);
      } else if (!row.failure.causes.empty()) {
        row.reason = row.failure.headings ? explainer.words(row.failure, metrics)
                                          : explainer.explain(row.failure, ends, metrics);
      }
    }
  }
}

std::string caption_of(const ComparisonRow& row, const std::string& cost_name) {
  if (!row.found()) return fmt::format("{}, {} expanded", describe(row.status), row.expanded);
  return fmt::format("{} {:.6g}, {} expanded", cost_name, row.cost, row.expanded);
}

/// A panel for each planner: what it expanded for the first query, and its path.
std::vector<Panel> panels_of(const ComparisonRun& run, const CompareArguments& arguments,
                             const FreeSpace& space) {
  const ComparedQuery& query = run.comparison().queries.front();
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < query.rows.size(); ++i) {
    const SearchSnapshot snapshot = run.record(i, 0).snapshot();
    const PlannerSpec& planner = run.planners()[i];
    Scene scene = query_scene(planner, space, query_for(planner, arguments, space));
    scene.path = run.path(i, 0);
    scene.marked = {{CellRole::expanded, snapshot.expanded},
                    {CellRole::frontier, snapshot.frontier}};
    panels.push_back({query.rows[i].planner, std::move(scene),
                      caption_of(query.rows[i], run.comparison().cost_name)});
  }
  return panels;
}

/// The searches of the first query beside each other.
Expected<std::string, Error> film_of(const ComparisonRun& run, const CompareArguments& arguments,
                                     const FreeSpace& space) {
  const ComparedQuery& query = run.comparison().queries.front();
  std::vector<SearchRecorder> recorders;
  recorders.reserve(query.rows.size());
  std::vector<FilmedSearch> searches;
  for (std::size_t i = 0; i < query.rows.size(); ++i) {
    recorders.push_back(run.record(i, 0));
    const PlannerSpec& planner = run.planners()[i];
    Scene outcome = query_scene(planner, space, query_for(planner, arguments, space));
    outcome.path = run.path(i, 0);
    searches.push_back({query.rows[i].planner, std::move(outcome), &recorders.back()});
  }
  return gif_of(searches, arguments.speed, style_of(arguments.style));
}

void write_files(const CompareArguments& arguments, const ComparisonRun& run,
                 const FreeSpace& space) {
  const Comparison& comparison = run.comparison();
  std::map<std::string, FileWriter> writers;
  if (arguments.random == 0)
    writers = picture_writers(panels_of(run, arguments, space), arguments.style);
  writers[".gif"] = [&](const std::string& file) {
    return write_picture(file, film_of(run, arguments, space));
  };
  writers[".json"] = [&](const std::string& file) {
    return write_bytes(file, comparison_json(comparison));
  };
  writers[".csv"] = [&](const std::string& file) {
    return write_bytes(file, comparison_csv(comparison));
  };
  arguments.output.write(writers);
  if (arguments.plot.empty()) return;
  const std::string script =
      comparison_plot(comparison, plot_kind_of(arguments.plot), plot_colours_of(arguments.style));
  const std::string wrong = write_bytes(arguments.plot, drawn_by_gnuplot(script));
  if (!wrong.empty()) throw InputError(wrong);
}

std::string text_of(const Comparison& comparison, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return comparison_table(comparison, table_width(detect_screen()));
    case TableFormat::json:
      return comparison_json(comparison);
    case TableFormat::csv:
      return comparison_csv(comparison);
  }
  return {};
}

bool found_any(const Comparison& comparison) {
  return std::any_of(comparison.queries.begin(), comparison.queries.end(), [](const auto& query) {
    return std::any_of(query.rows.begin(), query.rows.end(),
                       [](const ComparisonRow& row) { return row.found(); });
  });
}

int run(const CompareArguments& arguments) {
  arguments.output.check();
  check(arguments);
  std::vector<PlannerSpec> specs;
  if (!arguments.planners.empty()) specs = parse_planners(arguments.planners);
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  if (!arguments.plot.empty()) {
    check_not_among(loaded.files, arguments.plot, "--plot " + arguments.plot);
  }
  const FreeSpace space = arguments.map.free_space(loaded.map);
  if (specs.empty()) specs = default_planners(arguments.ends.start, space);
  auto made = ComparisonRun::make(space, std::move(specs), thread_cpu_seconds);
  if (!made) throw InputError(made.error().message);
  ComparisonRun& run = *made;
  run.allow(arguments.request.leeway(arguments.map.coordinates(loaded.map)));
  answer_all(run, queries_of(run, arguments, space), arguments.limits);
  give_reasons(run, arguments, space);
  print(text_of(run.comparison(), arguments.format));
  write_files(arguments, run, space);
  return found_any(run.comparison()) ? success : no_plan;
}

}  // namespace

Command add_compare(Parser& app) {
  Parser compare = app.add_subcommand("compare", "Compare planners on one query or on many");
  const auto arguments = std::make_shared<CompareArguments>();
  arguments->map.add_to(compare);
  arguments->map.add_clearance_cost_to(compare);
  arguments->map.add_primitives_to(compare);
  compare.add_option("--start", arguments->ends.start, wrapped("Start, as in `wend plan`"))
      .type_name("X,Y[,HEADING]");
  add_texts(compare, "--goal", arguments->ends.goals,
            "Goal, as in `wend plan`; if given several times, the goal with the lowest path cost")
      .type_name("X,Y[,HEADING]");
  add_goal_tolerance(compare, arguments->ends.tolerance);
  arguments->request.add_to(compare, {"nearest", "nearest_limit", "escape", "closest"});
  compare
      .add_option(
          "--planner", arguments->planners,
          wrapped("Planners, separated by commas, each with options after a colon: "
                  "astar:w=2,heuristic=euclidean,bfs (default: six grid planners that differ most; "
                  "all planners for headings if the start has one)"))
      .type_name(kPlannerType);
  add_count(compare, "--random", arguments->random,
            "Number of random queries between connected cells");
  add_count(compare, "--seed", arguments->seed, "Seed of the random queries (default 1)");
  arguments->limits.add_to(compare);
  add_table_format(compare, arguments->format);
  add_style(compare, arguments->style, "Colours of pictures and plots (default light)");
  add_number(compare, "--speed", arguments->speed, kFilmSpeeds,
             "Expansions per second of a .gif (default: a few seconds in total)");
  arguments->output.add_to(compare, {".png", ".svg", ".pdf", ".gif", ".json", ".csv"},
                           "Also write a picture with a panel for each planner (.png, .svg, "
                           ".pdf), a film of the searches (.gif), or the table (.csv, .json); may "
                           "be given several times");
  compare
      .add_option("--plot", arguments->plot,
                  wrapped("Plot time and expansions against path length, and their distributions, "
                          "as .png, .svg or .pdf; needs --random and gnuplot"))
      .type_name(kFileType);
  compare.further({"--goal-tolerance", "--seed", "--style"});
  compare.footer(kCompareExamples);
  return {compare, [compare, arguments] {
            arguments->request.check(compare);
            if (compare.given("--random")) {
              refuse_idle(compare, {"--goal-tolerance"}, "it needs --goal X,Y");
              refuse_idle(compare, {"--nearest", "--closest", "--escape"}, "it needs --goal X,Y");
              check_positive("--random", arguments->random);
            } else {
              refuse_idle(compare, {"--seed"}, "it needs --random N");
            }
            if (!arguments->output.any(".gif")) {
              refuse_idle(compare, {"--speed"}, "it needs -o FILE.gif");
            }
            if (!arguments->output.any_picture() && arguments->plot.empty()) {
              refuse_idle(compare, {"--style"}, "there is no picture; add -o FILE.png");
            }
            return run(*arguments);
          }};
}

}  // namespace wend::cli
