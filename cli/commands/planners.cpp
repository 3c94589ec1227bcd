// wend planners: the planners there are.

#include "wend/planner/planners.hpp"

#include <memory>

#include "cli/arguments/flags.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/report/planner_listing.hpp"

namespace wend::cli {
namespace {

constexpr const char* kPlannersExamples = R"(Examples:
  wend planners
  wend planners --format json)";

int run(Format format) {
  print(format == Format::json ? planner_listing_json(wend::planners())
                               : planner_listing_text(wend::planners()));
  return success;
}

}  // namespace

Command add_planners(Parser& app) {
  Parser planners = app.add_subcommand("planners", "List planners: guarantees, options and papers");
  const auto format = std::make_shared<Format>(Format::text);
  add_format(planners, *format);
  planners.footer(kPlannersExamples);
  return {planners, [format] { return run(*format); }};
}

}  // namespace wend::cli
