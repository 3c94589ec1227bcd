// wend planners: the planners there are, and all about some of them.

#include "wend/planner/planners.hpp"

#include <memory>
#include <string>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/io/text.hpp"
#include "wend/report/planner_listing.hpp"

namespace wend::cli {
namespace {

constexpr const char* kPlannersExamples = R"(Examples:
  wend planners
  wend planners astar
  wend planners --format json

docs/planners.md has the same for all planners. Options are given after the
name, --planner astar:weight=2, or as flags: `wend plan --planner astar --help`.)";

struct PlannersArguments {
  std::vector<std::string> names;  // empty: all
  Format format = Format::text;
};

/// Throws InputError for a planner that does not exist.
Registry<PlannerInfo> chosen(const std::vector<std::string>& names) {
  if (names.empty()) return wend::planners();
  std::vector<PlannerInfo> some;
  some.reserve(names.size());
  for (const std::string& name : names) {
    some.push_back(*value_or_throw(wend::planners().named("planner", name)));
  }
  return Registry<PlannerInfo>(std::move(some));
}

int run(const PlannersArguments& arguments) {
  const Registry<PlannerInfo> planners = chosen(arguments.names);
  if (arguments.format == Format::json) {
    print(planner_listing_json(planners));
  } else {
    print(visible(arguments.names.empty() ? planner_table(planners)
                                          : planner_listing_text(planners)));
  }
  return success;
}

}  // namespace

Command add_planners(Parser& app) {
  Parser planners = app.add_subcommand("planners", "List planners, or tell all about some");
  const auto arguments = std::make_shared<PlannersArguments>();
  planners
      .add_option("PLANNER", arguments->names,
                  wrapped("Planners to describe in full: guarantee, time, memory, options, paper "
                          "(default: a line for each planner)"))
      .type_name(kPlannerType);
  add_format(planners, arguments->format);
  planners.footer(kPlannersExamples);
  return {planners, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
