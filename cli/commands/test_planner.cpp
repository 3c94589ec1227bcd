// wend test-planner: holds a planner to what it declares.

#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/progress_bar.hpp"
#include "conformance/suite.hpp"
#include "conformance/suite_report.hpp"
#include "wend/base/choice.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {
namespace {

struct TestPlannerArguments {
  std::string planner;
  std::uint64_t maps = 600;
  std::uint64_t seed = 1;
  Format format = Format::text;
};

constexpr std::uint64_t kMostMaps = 1'000'000;
constexpr std::uint64_t kMostSeed = 1'000'000'000'000;

constexpr const char* kTestPlannerExamples = R"(Examples:
  wend test-planner astar
  wend test-planner astar:weight=2 --maps 2000 --seed 7
  wend test-planner car --maps 100 --format json

Holds a planner to the guarantee that it declares (wend planners), on random
maps. Planners on cells are compared with a reference that shares no code with
wend. Options after a colon are used for all maps; without any, each map draws
its own. A check that fails shows the smallest of its maps. Exit codes: 0 all
checks passed, 1 a check failed, 2 bad usage or input.)";

/// Throws InputError for options that the planner does not take.
void check_options(const PlannerSpec& planner) {
  const FreeSpace space =
      value_or_throw(make_free_space(*make_grid_map(Grid<CellState>(3, 3, CellState::free))));
  const auto made = info_of(planner).make(space, planner.options);
  if (!made && made.error().status == Status::invalid_option) {
    throw InputError(made.error().message);
  }
}

test::CheckReport run_with_progress(const test::ConformanceCheck& check, const PlannerInfo& info,
                                    test::SuiteOptions options) {
  ProgressBar progress(check.name, test::maps_of(check, options));
  options.go_on = [&](std::uint64_t maps_done) {
    progress.update(maps_done);
    return true;
  };
  return run_check(check, info, options);
}

int run(const TestPlannerArguments& arguments) {
  check_range("--maps", arguments.maps, 1, kMostMaps);
  check_range("--seed", arguments.seed, 0, kMostSeed);
  const std::vector<PlannerSpec> specs = parse_planners(arguments.planner);
  if (specs.size() != 1) throw InputError("test-planner takes exactly one planner");
  const PlannerSpec& planner = specs.front();
  check_options(planner);
  const PlannerInfo& info = info_of(planner);
  test::SuiteOptions options{.maps = arguments.maps, .seed = arguments.seed};
  if (!planner.options.empty()) options.options = planner.options;
  test::SuiteReport report{arguments.planner, std::string(choice_name(info.guarantee)), {}};
  for (const test::ConformanceCheck& check : test::conformance_checks()) {
    report.checks.push_back(run_with_progress(check, info, options));
    if (arguments.format == Format::text) {
      print(check_text(report.checks.back(), arguments.planner));
    }
  }
  print(arguments.format == Format::json ? suite_json(report) : summary_text(report));
  return report.passed() ? success : no_plan;
}

}  // namespace

Command add_test_planner(Parser& app) {
  Parser command =
      app.add_subcommand("test-planner", "Hold a planner to its guarantee on random maps");
  const auto arguments = std::make_shared<TestPlannerArguments>();
  command
      .add_option("planner", arguments->planner,
                  wrapped("Planner, with options after a colon: astar:weight=2"))
      .required()
      .type_name(kPlannerType);
  add_count(command, "--maps", arguments->maps,
            "Maps of the checks on most maps; others take a share (default 600)");
  add_count(command, "--seed", arguments->seed, "Seed of the first map (default 1)");
  add_format(command, arguments->format);
  command.footer(kTestPlannerExamples);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
