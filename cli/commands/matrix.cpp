// wend matrix: the costs between all stops of a file.

#include <memory>

#include "cli/arguments/flags.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/stop_arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/report/tour_report.hpp"

namespace wend::cli {
namespace {

struct MatrixArguments {
  StopArguments stops;
  Format format = Format::text;
  OutputFiles output;
};

constexpr const char* kMatrixExamples = R"(Examples:
  wend matrix office.yaml --stops stops.csv -o costs.csv
  wend matrix office.yaml --stops stops.csv --robot-radius 0.2 -o costs.npy
  wend matrix office.yaml --stops stops.csv --planner hub_labels -o costs.npy

A row for every stop that one leaves, a column for every stop that one reaches;
inf where there is no way. Exit codes: 0 every stop reaches every other, 1 some
do not (standard error names them), 2 bad usage or input.)";

int run(const MatrixArguments& arguments) {
  StopsOnMap stops(arguments.stops, arguments.output);
  const StopCosts costs = stops.costs();
  const auto json = [&] { return cost_matrix_json(stops.planner().name, costs, stops.times()); };
  if (!arguments.output.print()) {
    if (arguments.format == Format::json) {
      print(json());
    } else if (arguments.output.files().empty()) {
      print(cost_matrix_csv(costs.costs));
    }
  }
  arguments.output.write(
      {{".csv",
        [&](const std::string& file) { return write_bytes(file, cost_matrix_csv(costs.costs)); }},
       {".npy",
        [&](const std::string& file) { return write_bytes(file, cost_matrix_npy(costs.costs)); }},
       {".json", [&](const std::string& file) { return write_bytes(file, json()); }}},
      arguments.format == Format::json ? ".json" : ".csv");
  if (costs.cut_off.empty()) return success;
  complain(cut_off_text(costs));
  return no_plan;
}

}  // namespace

Command add_matrix(Parser& app) {
  Parser matrix = app.add_subcommand("matrix", "Compute the costs between all of many stops");
  const auto arguments = std::make_shared<MatrixArguments>();
  arguments->stops.add_to(matrix);
  add_format(matrix, arguments->format);
  arguments->output.add_to(matrix, {".csv", ".npy", ".json"},
                           "Write the costs as CSV, as an array of NumPy (.npy) or as JSON; may be "
                           "given several times",
                           "the costs (JSON with --format json, else CSV)");
  matrix.footer(kMatrixExamples);
  return {matrix, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
