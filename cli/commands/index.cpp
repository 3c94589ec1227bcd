// wend index: builds an index of a map, and says what one holds.

#include <fmt/format.h>

#include <memory>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/io/text.hpp"
#include "wend/report/json.hpp"

namespace wend::cli {
namespace {

constexpr double kMegabyte = 1e6;

struct BuildArguments {
  MapArguments map;
  std::string planner = "hub_labels";
  std::uint64_t threads = ThreadWorkers().count();
  Format format = Format::text;
  std::string output;
};

struct IndexInfoArguments {
  std::string file;
  Format format = Format::text;
};

constexpr const char* kIndexExamples = R"(Examples:
  wend index build arena.map -o arena.idx
  wend index build office.yaml --planner euclidean_labels -o office.idx
  wend index info arena.idx
  wend plan arena.map --index arena.idx --start 1,11 --goal 40,30)";

constexpr const char* kBuildExamples = R"(Examples:
  wend index build arena.map -o arena.idx
  wend index build office.yaml --planner euclidean_labels -o office.idx
  wend plan arena.map --index arena.idx --start 1,11 --goal 40,30

An index is valid for the cells where the robot fits: plan with the same map,
radius and --unknown. Ctrl-C stops the build, and no file is written. Exit
codes: 0 built, 1 not built (standard error gives the reason), 2 bad usage or
input.)";

constexpr const char* kIndexInfoExamples = R"(Examples:
  wend index info arena.idx
  wend index info arena.idx --format json

Exit codes: 0 valid, 2 damaged or not an index (standard error gives the
reason).)";

int build(const BuildArguments& arguments) {
  check_folder(arguments.output, "-o " + arguments.output);
  if (arguments.output == kStandardOutput) {
    throw InputError("-o -: an index must be a file");
  }
  check_range("--threads", arguments.threads, 1, kMostThreads);
  const PlannerSpec spec = parse_planner(arguments.planner);
  const PlannerInfo& planner = info_of(spec);
  if (!planner.index_support) {
    throw InputError(
        fmt::format("--planner {}: this planner does not use an index; planners with an index: {}",
                    planner.name, planners_with_index()));
  }
  if (!spec.options.empty()) {
    throw InputError(fmt::format("--planner {}: this planner has no options", arguments.planner));
  }
  const LoadedMap loaded = arguments.map.load_map();
  check_not_among(loaded.files, arguments.output, "-o " + arguments.output);
  const FreeSpace space = arguments.map.free_space(loaded.map);
  ThreadWorkers workers(static_cast<unsigned>(arguments.threads));
  const double begin = steady_seconds();
  const auto index = build_index(planner, space, workers);
  if (!index) {
    complain(index.error().message);
    return no_plan;
  }
  const double seconds = steady_seconds() - begin;
  const auto written = write_index(arguments.output, *index);
  if (!written) throw InputError(written.error().message);
  if (arguments.format == Format::json) {
    print(wend::text_of({{"file", arguments.output},
                         {"planner", planner.name},
                         {"width", space.width()},
                         {"height", space.height()},
                         {"passable_cells", space.passable().count()},
                         {"index_bytes", index->size()},
                         {"build_s", seconds},
                         {"threads", workers.count()}}));
  } else {
    print(fmt::format(
        "{}: {} of {} x {} cells, {:.1f} MB, built in {:.2f} s of wall time with {} thread{}\n",
        visible(arguments.output), planner.name, space.width(), space.height(),
        static_cast<double>(index->size()) / kMegabyte, seconds, workers.count(),
        workers.count() == 1 ? "" : "s"));
  }
  return success;
}

int info(const IndexInfoArguments& arguments) {
  const auto index = read_given_index(arguments.file);
  if (!index) throw InputError(index.error().message);
  const IndexHeader& header = index->header;
  if (arguments.format == Format::json) {
    Json sections = Json::array();
    for (std::size_t i = 0; i < header.sections; ++i) sections.push_back(header.table[i].bytes);
    print(wend::text_of({{"file", arguments.file},
                         {"planner", header.planner_name()},
                         {"version", header.version},
                         {"width", header.width},
                         {"height", header.height},
                         {"passable_cells", header.passable_cells},
                         {"map_hash", fmt::format("{:016x}", header.map_hash)},
                         {"index_bytes", header.bytes},
                         {"section_bytes", sections}}));
    return success;
  }
  const double cells = static_cast<double>(std::max<std::uint64_t>(1, header.passable_cells));
  print(fmt::format(
      "planner         {} (version {})\n"
      "map             {} x {} cells, {} of them passable\n"
      "map hash        {:016x}\n"
      "size            {:.1f} MB, {:.1f} bytes a passable cell\n",
      visible(header.planner_name()), header.version, header.width, header.height,
      header.passable_cells, header.map_hash, static_cast<double>(header.bytes) / kMegabyte,
      static_cast<double>(header.bytes) / cells));
  return success;
}

}  // namespace

Command add_index(Parser& app) {
  Parser index = app.add_subcommand("index", "Build an index of a map for fast queries");
  index.require_subcommand();
  index.footer(kIndexExamples);

  Parser build_command = index.add_subcommand("build", "Build the index of a map");
  const auto to_build = std::make_shared<BuildArguments>();
  to_build->map.add_to(build_command);
  build_command
      .add_option("--planner", to_build->planner,
                  wrapped("Planner of the index (default hub_labels): " + planners_with_index()))
      .type_name(kPlannerType);
  add_count(build_command, "--threads", to_build->threads,
            "Number of threads that build (default: all cores)");
  add_format(build_command, to_build->format);
  build_command.add_option("-o,--output", to_build->output, "Index file to write")
      .required()
      .type_name(kFileType);
  build_command.footer(kBuildExamples);

  Parser info_command = index.add_subcommand("info", "Describe an index");
  const auto to_tell = std::make_shared<IndexInfoArguments>();
  info_command.add_option("FILE", to_tell->file, "An index").required().type_name(kFileType);
  add_format(info_command, to_tell->format);
  info_command.footer(kIndexInfoExamples);

  return {index, [build_command, to_build, to_tell] {
            return build_command.parsed() ? build(*to_build) : info(*to_tell);
          }};
}

}  // namespace wend::cli
