// wend test-planner: holds a planner to what it declares.

#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/commands/developer_commands.hpp"
#include "cli/developers/developers.hpp"
#include "cli/developers/watchdog.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/progress_bar.hpp"
#include "conformance/suite.hpp"
#include "conformance/suite_report.hpp"
#include "wend/base/choice.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/text.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {
namespace {

struct TestPlannerArguments {
  std::string planner;
  std::string command = "wend";  // with its plugins
  double seconds = 60;           // for a map
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
its own. A check that fails shows the smallest of its maps; one that takes
longer than --limit-time for a map ends the command. Exit codes: 0 all checks
passed, 1 a check failed, 2 bad usage or input.)";

constexpr NumberRange kLimits{1e-3, 1e9, "s"};

/// Throws InputError for options that the planner does not take.
void check_options(const PlannerSpec& planner) {
  const FreeSpace space =
      value_or_throw(make_free_space(*make_grid_map(Grid<CellState>(3, 3, CellState::free))));
  const auto made = info_of(planner).make(space, planner.options);
  if (!made && made.error().status == Status::invalid_option) {
    throw InputError(made.error().message);
  }
}

/// The checks of one planner, one after the other.
class PlannerTest {
 public:
  PlannerTest(const TestPlannerArguments& arguments, const PlannerSpec& planner)
      : arguments_(arguments),
        info_(info_of(planner)),
        options_{.maps = arguments.maps, .seed = arguments.seed},
        report_{arguments.planner, std::string(choice_name(info_.guarantee)), {}} {
    if (!planner.options.empty()) options_.options = planner.options;
  }

  ExitCode run() {
    for (const test::ConformanceCheck& check : test::conformance_checks()) {
      check_ = &check;
      add(run_with_progress());
    }
    return finish();
  }

 private:
  test::CheckReport run_with_progress() {
    ProgressBar progress(check_->name, test::maps_of(*check_, options_));
    options_.go_on = [&](std::uint64_t maps_done) {
      watchdog_.reset();
      map_ = maps_done;
      progress.update(maps_done);
      return true;
    };
    test::CheckReport report = run_check(*check_, info_, options_);
    watchdog_.pause();
    return report;
  }

  void add(test::CheckReport report) {
    report_.checks.push_back(std::move(report));
    if (arguments_.format == Format::text)
      print(visible(check_text(report_.checks.back(), command())));
  }

  ExitCode finish() const {
    print(arguments_.format == Format::json ? suite_json(report_) : summary_text(report_));
    return report_.passed() ? success : no_plan;
  }

  /// The planner's thread cannot be stopped, so the program ends.
  void give_up() {
    add(test::hanging(*check_, options_, map_, arguments_.seconds));
    finish();
    complain(fmt::format(
        "the check '{}' ended: no answer for {} s on a map; the checks behind it did not run",
        check_->name, format_number(arguments_.seconds)));
    finish_output();
    std::_Exit(no_plan);
  }

  std::string command() const {
    return fmt::format("{} test-planner {}", arguments_.command, arguments_.planner);
  }

  const TestPlannerArguments& arguments_;
  const PlannerInfo& info_;
  test::SuiteOptions options_;
  test::SuiteReport report_;
  const test::ConformanceCheck* check_ = nullptr;
  std::uint64_t map_ = 0;
  Watchdog watchdog_{arguments_.seconds, [this] { give_up(); }};
};

int run(const TestPlannerArguments& arguments) {
  check_range("--maps", arguments.maps, 1, kMostMaps);
  check_range("--seed", arguments.seed, 0, kMostSeed);
  const std::vector<PlannerSpec> specs = parse_planners(arguments.planner);
  if (specs.size() != 1) throw InputError("test-planner takes exactly one planner");
  const PlannerSpec& planner = specs.front();
  check_options(planner);
  return PlannerTest(arguments, planner).run();
}

}  // namespace

Command add_test_planner(Parser& app, const std::vector<std::string>& plugins) {
  Parser command = app.add_subcommand("test-planner", kTestPlannerDescription);
  const auto arguments = std::make_shared<TestPlannerArguments>();
  for (const std::string& file : plugins) arguments->command += " --plugin " + visible(file);
  command
      .add_option("planner", arguments->planner,
                  wrapped("Planner, with options after a colon: astar:weight=2"))
      .required()
      .type_name(kPlannerType);
  add_count(command, "--maps", arguments->maps,
            "Maps of the checks on most maps; others take a share (default 600)");
  add_count(command, "--seed", arguments->seed, "Seed of the first map (default 1)");
  add_number(command, "--limit-time", arguments->seconds, kLimits,
             "Limit in seconds (wall time) on a map of a check: a planner that does not answer is "
             "ended (default 60)");
  add_format(command, arguments->format);
  command.footer(kTestPlannerExamples);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
