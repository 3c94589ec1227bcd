// wend bench: MovingAI scenarios, solved, timed and checked.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include "bench/scenario/bench_plot.hpp"
#include "bench/scenario/bench_queries.hpp"
#include "bench/scenario/bench_rows.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/commands/developer_commands.hpp"
#include "cli/developers/bench/dynamic_run.hpp"
#include "cli/developers/bench/entry.hpp"
#include "cli/developers/bench/ranks.hpp"
#include "cli/developers/bench/run.hpp"
#include "cli/developers/bench/scenarios.hpp"
#include "cli/developers/bench/settings.hpp"
#include "cli/developers/bench/store.hpp"
#include "cli/developers/developers.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"

namespace wend::cli {
namespace {

struct BenchArguments {
  std::vector<std::string> scenarios;
  std::string planners = "astar";
  std::string map;
  std::vector<std::string> indexes;
  std::string database;
  bool distributed = false;
  BenchSettings settings;
  std::uint64_t sample = std::numeric_limits<std::uint64_t>::max();
  bool check = false;
  std::string per_query;
  std::string plot;
  StyleName style = StyleName::light;
  TableFormat format = TableFormat::text;
};

constexpr const char* kBenchExamples = R"(Examples:
  wend generate rooms --size 128x128 --seed 3 -o rooms.map
  wend generate scenario rooms.map --buckets 10 --seed 1 -o rooms.map.scen
  wend bench rooms.map.scen --planner astar,jps,hub_labels
  wend bench rooms.map.scen --planner astar,jps --fresh --sample 20
  wend bench . --planner astar,dijkstra --repetitions 2 --per-query times.csv
  wend bench rooms.map.scen --robot-radius 1.5 --connectivity 4
  wend bench . --planner astar,dijkstra --database results.db --plot results.svg
  wend bench queries.scen --map arena.map
  mpirun -n 4 wend bench . --planner astar --database results.db --distributed

Times are CPU times of the thread. The first query is one run of a new planner;
it is measured for ten queries, with --fresh for all. A later query is the
minimum of as many runs as fill 5 ms. The preparation of a planner, its index
and its view of the map, is shown separately.

The map of X.map.scen is X.map, of X.yaml.scen it is X.yaml; other scenarios
name their map in the map column, in the scenario's folder. Cells are numbered
as with --cells: from the upper left cell, on ROS maps from the lower left cell.
On terrain, lengths are costs. Lengths in scenarios are for a point on 8
neighbours without corner cutting; for other robots Dijkstra's algorithm
computes them first. In scenarios of version 2 the map changes between queries;
the time of a query includes telling the planner. An answer is wrong if it finds
no path and the scenario has a length, or the reverse; if its length differs; if
the path is not valid cell by cell; or if it differs from an earlier repetition.
An interrupted run with --database continues when it is started again; Planner
Arena opens the file.
Exit codes: 0 all answers are right, 1 an answer is wrong, 2 bad usage or input.)";

struct BenchResults {
  std::vector<BenchRow> rows{};
  std::vector<BenchedMap> maps{};
};

std::string text_of(const BenchArguments& arguments, const std::vector<BenchRow>& rows) {
  const BenchConditions conditions = arguments.settings.conditions();
  switch (arguments.format) {
    case TableFormat::text:
      return bench_table(conditions, rows, table_width(detect_screen()));
    case TableFormat::json:
      return bench_json(conditions, rows);
    case TableFormat::csv:
      return bench_csv(conditions, rows);
  }
  return {};
}

void check(const Parser& bench, const BenchArguments& arguments) {
  arguments.settings.check(bench);
  check_positive("--sample", arguments.sample);
  if (!arguments.database.empty()) {
    check_folder(arguments.database, "--database " + arguments.database);
  }
  if (arguments.distributed && arguments.database.empty()) {
    throw InputError("--distributed needs --database FILE for the results of all ranks");
  }
  if (!arguments.per_query.empty()) {
    check_folder(arguments.per_query, "--per-query " + arguments.per_query);
    check_replaces_own(arguments.per_query, kBenchQueriesHeader,
                       "--per-query " + arguments.per_query);
  }
  if (arguments.plot.empty()) return;
  plot_kind_of(arguments.plot);
  check_folder(arguments.plot, "--plot " + arguments.plot);
  require_gnuplot();
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<std::filesystem::path> files_of(const std::vector<BenchScenario>& scenarios) {
  std::vector<std::filesystem::path> files;
  for (const BenchScenario& scenario : scenarios) {
    files.emplace_back(scenario.file);
    append(files, scenario.map_files);
  }
  return files;
}

/// Throws InputError if no entry uses the index.
void check_used(const GivenIndex& index, const std::vector<BenchEntry>& entries) {
  const bool taken =
      std::ranges::any_of(entries, [&](const BenchEntry& entry) { return entry.takes(index); });
  if (taken) return;
  throw InputError(
      fmt::format("--index {}: the index is for the planner {}, which is not in --planner",
                  index.file, index.header.planner_name()));
}

/// All that a benchmark needs, read and checked before anything is measured or written.
struct BenchInput {
  std::vector<BenchEntry> entries;
  std::vector<GivenIndex> indexes;
  std::vector<BenchScenario> scenarios;
};

BenchInput load_input(const BenchArguments& arguments) {
  const BenchSettings& settings = arguments.settings;
  BenchInput input{parse_entries(arguments.planners, settings.moves.moves),
                   open_indexes(arguments.indexes),
                   load_scenarios(arguments.scenarios, arguments.map, arguments.sample)};
  for (const GivenIndex& index : input.indexes) check_used(index, input.entries);
  std::vector<bool> fits(input.indexes.size(), false);
  for (const BenchScenario& scenario : input.scenarios) {
    const FreeSpace space = settings.robot.free_space(scenario.map);
    for (const BenchEntry& entry : input.entries) entry.check(space);
    for (std::size_t i = 0; i < fits.size(); ++i) {
      fits[i] = fits[i] || is_for(input.indexes[i], space);
    }
  }
  const auto unused = std::ranges::find(fits, false);
  if (unused != fits.end()) {
    const auto at = static_cast<std::size_t>(unused - fits.begin());
    throw InputError(
        fmt::format("--index {}: the index is for another map", input.indexes[at].file));
  }
  return input;
}

/// Runs the scenarios, or a share of their queries.
BenchResults run_scenarios(const BenchArguments& arguments, BenchInput& input, BenchStore& store,
                           BenchShare share = {}) {
  const BenchSettings& settings = arguments.settings;
  std::uint64_t queries = 0;
  for (const BenchScenario& scenario : input.scenarios) queries += scenario.queries.size();
  const std::uint64_t answers = queries * input.entries.size() * settings.repetitions;
  BenchProgress progress{{"queries", answers}};
  BenchResults results;
  for (BenchScenario& scenario : input.scenarios) {
    if (!settings.as_in_scenarios()) {
      set_lengths(scenario.queries, settings.robot.free_space(scenario.map), settings.moves.moves);
    }
    BenchRun bench_run(scenario, input.entries, settings, store, share);
    bench_run.run(input.indexes, progress);
    if (share.ranks > 1) continue;
    append(results.rows, bench_run.rows());
    if (!arguments.plot.empty() || !arguments.per_query.empty()) {
      append(results.maps, bench_run.benched());
    }
  }
  if (progress.known > 0 && !arguments.distributed) {
    complain(fmt::format("{}: {} of {} answers were already stored", arguments.database,
                         progress.known, answers));
  }
  return results;
}

void write_queries(const BenchArguments& arguments, const std::vector<BenchedMap>& maps) {
  const std::string wrong =
      write_bytes(arguments.per_query, bench_queries_csv(maps, arguments.settings.fresh));
  if (!wrong.empty()) throw InputError(wrong);
}

void write_plot(const BenchArguments& arguments, const std::vector<BenchedMap>& maps) {
  const std::string script =
      bench_plot(maps, plot_kind_of(arguments.plot), plot_colours_of(arguments.style));
  const std::string wrong = write_bytes(arguments.plot, drawn_by_gnuplot(script));
  if (!wrong.empty()) throw InputError(wrong);
}

/// Merges the shards of an earlier run, does this rank's share, and merges the shards of all ranks.
void run_share(const BenchArguments& arguments, BenchInput& input, Ranks& ranks) {
  const bool merges = ranks.rank() == 0;
  if (merges) merge_shards(arguments.database);
  ranks.wait_for_all();
  {
    BenchStore store(arguments.database, shard_file(arguments.database, ranks.rank()));
    run_scenarios(
        arguments, input, store,
        {static_cast<std::size_t>(ranks.rank()), static_cast<std::size_t>(ranks.count())});
  }
  ranks.wait_for_all();
  if (merges) merge_shards(arguments.database);
}

/// Must this rank report the results? Then they are all in the database.
bool run_distributed(const BenchArguments& arguments, BenchInput& input) {
  Ranks ranks;
  try {
    run_share(arguments, input, ranks);
  } catch (const InputError& error) {
    complain(error.what());
    ranks.end_all(bad_input);
  } catch (const Cancelled&) {
    complain("cancelled; run the same command again to continue");
    ranks.end_all(interrupted);
  }
  return ranks.rank() == 0;
}

/// Throws InputError for flags that scenarios whose maps change do not have.
void check_dynamic(const Parser& bench, const BenchArguments& arguments) {
  refuse_idle(bench,
              {"--map", "--index", "--database", "--distributed", "--sample", "--threads",
               "--repetitions", "--fresh"},
              "the map of a scenario of version 2 changes from query to query");
  if (!arguments.settings.as_in_scenarios()) {
    throw InputError(
        "the lengths of a scenario of version 2 are for a point on 8 neighbours "
        "without corner cutting");
  }
}

BenchResults run_dynamic_scenarios(const BenchArguments& arguments,
                                   const std::vector<DynamicScenario>& scenarios) {
  const Interruptible interruptible;
  const auto entries = parse_entries(arguments.planners, arguments.settings.moves.moves);
  BenchResults results;
  for (const DynamicScenario& scenario : scenarios) {
    for (const BenchEntry& entry : entries) {
      results.maps.push_back(run_dynamic(scenario, entry, arguments.settings));
      BenchRow row;
      row.scen = scenario.file;
      row.planner = entry.name();
      row.set_answers(results.maps.back().answers);
      results.rows.push_back(std::move(row));
    }
  }
  return results;
}

/// Prints and writes the results. Returns the exit code.
int report(const BenchArguments& arguments, const BenchResults& results) {
  print(text_of(arguments, results.rows));
  if (!arguments.per_query.empty()) write_queries(arguments, results.maps);
  if (!arguments.plot.empty()) write_plot(arguments, results.maps);
  const bool wrong =
      std::ranges::any_of(results.rows, [](const BenchRow& row) { return row.wrong > 0; });
  return wrong ? no_plan : success;
}

int run(const Parser& bench, const BenchArguments& arguments) {
  check(bench, arguments);
  try {
    if (const auto dynamic = load_dynamic_scenarios(arguments.scenarios); !dynamic.empty()) {
      check_dynamic(bench, arguments);
      return report(arguments, run_dynamic_scenarios(arguments, dynamic));
    }
    BenchInput input = load_input(arguments);
    if (!arguments.per_query.empty()) {
      check_not_among(files_of(input.scenarios), arguments.per_query,
                      "--per-query " + arguments.per_query);
    }
    check_not_among(files_of(input.scenarios), arguments.plot, "--plot " + arguments.plot);
    check_not_among(files_of(input.scenarios), arguments.database,
                    "--database " + arguments.database);
    if (arguments.distributed && !run_distributed(arguments, input)) return success;
    BenchStore store = arguments.database.empty() ? BenchStore() : BenchStore(arguments.database);
    return report(arguments, run_scenarios(arguments, input, store));
  } catch (const Cancelled&) {
    complain(arguments.database.empty()
                 ? "cancelled"
                 : fmt::format("cancelled; run the same command again to continue {}",
                               arguments.database));
    return interrupted;
  }
}

}  // namespace

Command add_bench(Parser& app) {
  Parser bench = app.add_subcommand("bench", kBenchDescription);
  const auto arguments = std::make_shared<BenchArguments>();
  bench
      .add_option("SCEN", arguments->scenarios,
                  wrapped("MovingAI scenario files, or folders with .scen files"))
      .required()
      .type_name(kFileType);
  bench
      .add_option("--planner", arguments->planners,
                  wrapped("Planners, separated by commas, each with options after a colon: "
                          "astar:weight=2,dijkstra (default astar)"))
      .type_name(kPlannerType);
  bench.add_option("--map", arguments->map, "Map for all scenarios").type_name(kFileType);
  arguments->settings.add_to(bench);
  add_count(bench, "--sample", arguments->sample,
            "Number of queries per scenario, evenly spread (default: all)");
  add_texts(bench, "--index", arguments->indexes,
            "Index for one of the planners; may be given several times. A missing index is built "
            "first, by one thread")
      .type_name(kFileType);
  bench
      .add_option("--database", arguments->database,
                  wrapped("Store every answer in this SQLite database, in the schema of OMPL's "
                          "benchmarks; stored answers are not computed again"))
      .type_name(kFileType);
  bench.add_flag("--distributed", arguments->distributed,
                 wrapped("Under mpirun: divide the queries among the ranks and merge their answers "
                         "in the database"));
  bench.add_flag("--check", arguments->check,
                 wrapped("Check every path cell by cell (always done; kept for compatibility)"));
  add_table_format(bench, arguments->format);
  bench
      .add_option("--per-query", arguments->per_query,
                  wrapped("Also write the result of every query and planner to this CSV file"))
      .type_name(kFileType);
  bench
      .add_option("--plot", arguments->plot,
                  wrapped("Plot time against path length, distributions and, for several maps, "
                          "time against map size, as .png, .svg or .pdf; needs gnuplot"))
      .type_name(kFileType);
  add_style(bench, arguments->style, "Colours of the plot (default light)");
  bench.further({"--fresh", "--index", "--distributed", "--check", "--style", "--connectivity",
                 "--corner-rule"});
  bench.footer(kBenchExamples);
  return {bench, [bench, arguments] {
            if (arguments->plot.empty()) {
              refuse_idle(bench, {"--style"}, "it needs --plot FILE");
            }
            return run(bench, *arguments);
          }};
}

}  // namespace wend::cli
