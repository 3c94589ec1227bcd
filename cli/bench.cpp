// wend bench: MovingAI scenarios, solved, timed and checked.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "bench_contestant.hpp"
#include "bench_course.hpp"
#include "bench_race.hpp"
#include "bench_shards.hpp"
#include "bench_store.hpp"
#include "command.hpp"
#include "exit_code.hpp"
#include "flags.hpp"
#include "gnuplot.hpp"
#include "interrupt.hpp"
#include "output.hpp"
#include "output_files.hpp"
#include "picture.hpp"
#include "ranks.hpp"
#include "wend/report/bench_plot.hpp"
#include "wend/report/bench_rows.hpp"

namespace wend::cli {
namespace {

struct BenchArguments {
  std::vector<std::string> scenarios;
  std::string planners = "astar";
  std::string map;
  std::vector<std::string> indexes;
  std::string database;
  bool distributed = false;
  std::uint64_t threads = 1;
  std::uint64_t passes = 1;
  std::uint64_t sample = 0;
  bool check = false;
  std::string plot;
  StyleName style = StyleName::light;
  TableFormat format = TableFormat::text;
};

constexpr std::uint64_t kMostThreads = 1024;
constexpr std::uint64_t kMostPasses = 1'000'000;

constexpr const char* kExamples = R"(Examples:
  wend bench arena.map.scen
  wend bench arena.map.scen den520d.map.scen --planner astar,dijkstra
  wend bench . --planner astar,astar:weight=0 --passes 5 --threads 2
  wend bench arena.map.scen --planner astar:weight=2 --format json
  wend bench . --planner astar,dijkstra --database results.db --plot results.svg
  wend bench queries.scen --map arena.map
  mpirun -n 4 wend bench . --planner astar --database results.db --distributed

Always 8 neighbours without corner cutting. The map of X.map.scen is X.map, of other
scenarios the name in their map column; it lies in the scenario's folder. Wrong is: no path
though the file gives a length; a path though it says there is none; another length; a path
that is not valid cell by cell. Of several passes the fastest of every query counts, and the
spread is by how much the slowest pass was slower than the fastest. A run with --database that
was interrupted goes on where it was when it is started again; Planner Arena opens the file.
Exit codes: 0 all right, 1 something is wrong, 2 bad usage or input.)";

struct BenchResults {
  std::vector<BenchRow> rows{};
  std::vector<BenchedMap> maps{};
};

std::string text_of(const std::vector<BenchRow>& rows, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return bench_table(rows);
    case TableFormat::json:
      return bench_json(rows);
    case TableFormat::csv:
      return bench_csv(rows);
  }
  return {};
}

void check(const BenchArguments& arguments) {
  check_range("--threads", arguments.threads, 1, kMostThreads);
  check_range("--passes", arguments.passes, 1, kMostPasses);
  if (arguments.distributed && arguments.database.empty()) {
    throw InputError("--distributed: name the file for the results of all ranks with --database");
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

/// Every index that was given is to be used.
void check_used(const std::vector<GivenIndex>& indexes, const std::vector<Contestant>& contestants,
                const std::vector<Course>& courses) {
  for (const GivenIndex& index : indexes) {
    const bool taken =
        std::any_of(contestants.begin(), contestants.end(),
                    [&](const Contestant& contestant) { return contestant.takes(index); });
    if (!taken) {
      throw InputError(fmt::format("--index {}: it is for {}, which is not in --planner",
                                   index.file, index.header.planner_name()));
    }
    const bool fits = std::any_of(courses.begin(), courses.end(), [&](const Course& course) {
      return is_for(index, FreeSpace(course.map));
    });
    if (!fits) throw InputError(fmt::format("--index {}: it is for another map", index.file));
  }
}

/// Of the courses, or of a share of their queries.
BenchResults run_races(const BenchArguments& arguments, BenchStore& store, BenchShare share = {}) {
  const std::vector<Contestant> contestants = parse_contestants(arguments.planners);
  const std::vector<GivenIndex> indexes = open_indexes(arguments.indexes);
  const std::vector<Course> courses =
      load_courses(arguments.scenarios, arguments.map, arguments.sample);
  check_used(indexes, contestants, courses);
  std::uint64_t queries = 0;
  for (const Course& course : courses) queries += course.scenario.queries.size();
  const std::uint64_t answers = queries * contestants.size() * arguments.passes;
  BenchProgress progress{{"queries", answers}};
  BenchResults results;
  for (const Course& course : courses) {
    BenchRace race(course, contestants, static_cast<unsigned>(arguments.threads), store, share);
    race.run(arguments.passes, indexes, progress);
    if (share.ranks > 1) continue;
    append(results.rows, race.rows());
    if (!arguments.plot.empty()) append(results.maps, race.benched());
  }
  if (progress.known > 0 && !arguments.distributed) {
    complain(fmt::format("{}: {} of {} answers were there already", arguments.database,
                         progress.known, answers));
  }
  return results;
}

void write_plot(const BenchArguments& arguments, const std::vector<BenchedMap>& maps) {
  const std::string script =
      bench_plot(maps, plot_kind_of(arguments.plot), plot_colours_of(arguments.style));
  const std::string wrong = write_bytes(arguments.plot, drawn_by_gnuplot(script));
  if (!wrong.empty()) throw InputError(wrong);
}

/// Merges what the ranks of an earlier run left, does this rank's share, and merges those of all.
void run_share(const BenchArguments& arguments, Ranks& ranks) {
  const bool merges = ranks.rank() == 0;
  if (merges) merge_shards(arguments.database);
  ranks.wait_for_all();
  {
    BenchStore store(arguments.database, shard_file(arguments.database, ranks.rank()));
    run_races(arguments, store,
              {static_cast<std::size_t>(ranks.rank()), static_cast<std::size_t>(ranks.count())});
  }
  ranks.wait_for_all();
  if (merges) merge_shards(arguments.database);
}

/// Is it for this rank to tell the results? They are all in the database then.
bool run_distributed(const BenchArguments& arguments) {
  Ranks ranks;
  try {
    run_share(arguments, ranks);
  } catch (const InputError& error) {
    complain(error.what());
    ranks.end_all(bad_input);
  } catch (const Cancelled&) {
    complain("cancelled; the same command goes on where the ranks were");
    ranks.end_all(interrupted);
  }
  return ranks.rank() == 0;
}

int run(const BenchArguments& arguments) {
  check(arguments);
  try {
    if (arguments.distributed && !run_distributed(arguments)) return success;
    BenchStore store = arguments.database.empty() ? BenchStore() : BenchStore(arguments.database);
    const BenchResults results = run_races(arguments, store);
    const std::vector<BenchRow>& rows = results.rows;
    print(text_of(rows, arguments.format));
    if (!arguments.plot.empty()) write_plot(arguments, results.maps);
    const auto is_wrong = [](const BenchRow& row) { return row.wrong > 0; };
    return std::any_of(rows.begin(), rows.end(), is_wrong) ? no_plan : success;
  } catch (const Cancelled&) {
    complain(
        arguments.database.empty()
            ? "cancelled"
            : fmt::format("cancelled; the same command goes on where {} ends", arguments.database));
    return interrupted;
  }
}

}  // namespace

Command add_bench(Parser& app) {
  Parser bench = app.add_subcommand("bench", "Solve, time and check MovingAI scenarios");
  const auto arguments = std::make_shared<BenchArguments>();
  bench
      .add_option("SCEN", arguments->scenarios,
                  wrapped("MovingAI scenarios, and folders with .scen files"))
      .required()
      .type_name(kFileType);
  bench
      .add_option("--planner", arguments->planners,
                  wrapped("Planners with commas between, options after a colon: "
                          "astar:weight=2,dijkstra (default astar)"))
      .type_name(kPlannerType);
  bench.add_option("--map", arguments->map, "The map, for all scenarios").type_name(kFileType);
  add_count(bench, "--threads", arguments->threads,
            "So many planners at the same time, on one map (default 1)");
  add_count(bench, "--passes", arguments->passes,
            "Ask every query so many times, planner after planner (default 1)");
  add_count(bench, "--sample", arguments->sample,
            "So many queries of every scenario, evenly spread (default: all)");
  add_texts(bench, "--index", arguments->indexes,
            "An index for one of the planners; may be given several times. One that is not given "
            "is built first")
      .type_name(kFileType);
  bench
      .add_option("--database", arguments->database,
                  wrapped("Keep every answer in this SQLite database, in the schema of OMPL's "
                          "benchmarks; what it has is not done again"))
      .type_name(kFileType);
  bench.add_flag("--distributed", arguments->distributed,
                 wrapped("Under mpirun: share the queries among the ranks, and put their answers "
                         "together in the database"));
  bench.add_flag("--check", arguments->check,
                 wrapped("Check every path cell by cell: always done, whether asked for or not"));
  add_table_format(bench, arguments->format);
  bench
      .add_option("--plot", arguments->plot,
                  wrapped("Time against length, distributions and, of several maps, time against "
                          "size, as .png, .svg or .pdf; needs gnuplot"))
      .type_name(kFileType);
  add_style(bench, arguments->style, "Colours of the plot (default light)");
  bench.footer(kExamples);
  return {bench, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
