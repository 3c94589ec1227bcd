// wend tour: the best order of many stops, and its path.

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/stop_arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/io/query/stop_csv.hpp"
#include "wend/render/scene.hpp"
#include "wend/report/tour_report.hpp"
#include "wend/tour/plan_tour.hpp"
#include "wend/tour/tour_path.hpp"

namespace wend::cli {
namespace {

struct TourArguments {
  StopArguments stops;
  std::string start;
  std::string end;
  bool closed = false;
  std::string before;
  std::optional<double> kicks;
  std::uint64_t seed = 1;
  Format format = Format::text;
  PictureArguments pictures;
  OutputFiles output;
};

constexpr double kMostKicks = 1e12;

constexpr const char* kTourExamples = R"(Examples:
  wend tour office.yaml --stops stops.csv --robot-radius 0.2 -o tour.png
  wend tour office.yaml --stops stops.csv --start 1,1 --end 15,9 -o tour.csv
  wend tour office.yaml --stops stops.csv --closed --format json
  wend tour office.yaml --stops stops.csv --start 1,1 --before pairs.csv
  wend tour office.yaml --stops many.csv --planner hub_labels --limit-time 5

The order is printed as rows of the stops, from 0. No order is cheaper than the
bound. --start and --end are places besides the stops, the robot's for example;
without them a tour begins and ends with any stop. --limit-time is of the whole
call. Exit codes: 0 found, 1 no tour (standard error gives the reason), 2 bad
usage or input.)";

TourOptions options_of(const TourArguments& arguments, StopsOnMap& stops) {
  TourOptions options;
  options.closed = arguments.closed;
  options.seed = arguments.seed;
  if (arguments.kicks) options.kicks = static_cast<std::uint64_t>(*arguments.kicks);
  if (!arguments.start.empty()) options.start = stops.add_place("start", arguments.start);
  if (!arguments.end.empty()) options.end = stops.add_place("end", arguments.end);
  if (arguments.before.empty()) return options;
  for (const auto& [first, second] : value_or_throw(load_stop_pair_csv(arguments.before))) {
    options.before.push_back({first, second});
    for (const int row : {first, second}) {
      if (static_cast<std::size_t>(row) < stops.stops_of_file()) continue;
      throw InputError(fmt::format("{}: there is no stop {}; {} has {}", arguments.before, row,
                                   arguments.stops.stops, stops.stops_of_file()));
    }
  }
  return options;
}

Scene scene_of(const StopsOnMap& stops, const TourReport& report) {
  Scene scene{.space = stops.view().space};
  scene.path = report.way.path;
  for (const int row : report.tour.order) {
    const Point point = stops.frame().to_grid(stops.stops()[static_cast<std::size_t>(row)].point());
    if (!scene.start) {
      scene.start = point;
    } else {
      scene.goals.emplace_back(point);
    }
  }
  return scene;
}

/// What is found until a limit is written. Throws NoPathError without a tour.
template <class Found>
Found found_or_throw(Expected<Found, Error> found) {
  if (found) return *std::move(found);
  const Error& error = found.error();
  if (error.status == Status::invalid_option) throw InputError(error.message);
  throw NoPathError(error.message, {std::string(to_string(error.status)), error.message});
}

TourReport find(const TourArguments& arguments, StopsOnMap& stops) {
  TourOptions options = options_of(arguments, stops);
  const StopCosts costs = stops.costs();
  if (!costs.cut_off.empty()) {
    const std::string text = cut_off_text(costs);
    throw NoPathError(text, {std::string(to_string(Status::unreachable)), text});
  }
  TourReport report;
  report.planner = stops.planner().name;
  report.capabilities = info_of(stops.planner()).capabilities;
  report.closed = arguments.closed;
  report.stops = stops.stops_of_file();
  options.limits = stops.deadline().left();
  double seconds = 0;
  report.tour = timed(thread_cpu_seconds, seconds,
                      [&] { return found_or_throw(plan_tour(costs.costs, options)); });
  StopCostOptions legs = stops.options();
  legs.limits = {};  // the order is found: its legs take little
  report.way = timed(thread_cpu_seconds, seconds, [&] {
    return found_or_throw(tour_path(stops.session(), stops.view(), stops.stops(), report.tour.order,
                                    arguments.closed, legs));
  });
  report.times = stops.times();
  report.times.search += seconds;
  return report;
}

/// If there is no tour, the path files say so.
TourReport find_or_write_failure(const TourArguments& arguments, StopsOnMap& stops) {
  try {
    return find(arguments, stops);
  } catch (const NoPathError& error) {
    const std::string csv = no_path_csv(error.plan());
    arguments.output.write(
        {{".csv", [&](const std::string& file) { return write_bytes(file, csv); }}}, ".csv");
    throw;
  }
}

int run(const TourArguments& arguments) {
  if (arguments.closed && !arguments.end.empty()) {
    throw InputError("--end: a closed tour ends where it starts; leave out --end or --closed");
  }
  StopsOnMap stops(arguments.stops, arguments.output);
  const TourReport report = find_or_write_failure(arguments, stops);
  const Scene scene = scene_of(stops, report);
  const Screen screen = detect_screen();
  if (arguments.format == Format::json && !arguments.output.print()) {
    print(tour_json(report, stops.frame()));
  } else if (!arguments.output.print()) {
    print(picture_above(tour_text(report), scene, screen, arguments.pictures));
  }
  auto writers = picture_writers({{{}, scene, {}}}, arguments.pictures.style);
  writers[".csv"] = [&](const std::string& file) {
    return write_bytes(file, path_csv(report.way.path, stops.frame()));
  };
  writers[".json"] = [&](const std::string& file) {
    return write_bytes(file, tour_json(report, stops.frame()));
  };
  arguments.output.write(writers, arguments.format == Format::json ? ".json" : ".csv");
  return success;
}

}  // namespace

Command add_tour(Parser& app) {
  Parser tour = app.add_subcommand("tour", "Find the best order of many stops, and its path");
  const auto arguments = std::make_shared<TourArguments>();
  arguments->stops.add_to(tour);
  tour.add_option("--start", arguments->start,
                  wrapped("Where the tour begins, as in `wend plan`; default: at any stop"))
      .type_name("X,Y[,HEADING]");
  tour.add_option("--end", arguments->end, wrapped("Where the tour ends; default: at any stop"))
      .type_name("X,Y[,HEADING]");
  tour.add_flag("--closed", arguments->closed, wrapped("Return to where the tour begins"));
  tour.add_option("--before", arguments->before,
                  wrapped("CSV file of pairs of stops, with the columns first and second: rows of "
                          "the stops, of which the first must be visited before the second"))
      .type_name(kFileType);
  add_number(tour, "--kicks", arguments->kicks, {0, kMostKicks},
             "How often to try another order (default: 20 for each stop; with --limit-time until "
             "then). The same number gives the same order");
  add_count(tour, "--order-seed", arguments->seed, "Seed of the search for an order (default 1)");
  tour.further({"--kicks", "--order-seed"});
  add_format(tour, arguments->format);
  arguments->pictures.add_to(tour);
  arguments->output.add_to(tour, {".png", ".svg", ".pdf", ".csv", ".json"},
                           "Also write a picture (.png, .svg, .pdf), the path (.csv) or the JSON; "
                           "may be given several times. If there is no tour, the CSV states the "
                           "reason instead",
                           "the path (JSON with --format json, else CSV)");
  tour.footer(kTourExamples);
  return {tour, [tour, arguments] {
            arguments->pictures.check(
                tour, arguments->output.any_picture(),
                arguments->format != Format::json && !arguments->output.print());
            return run(*arguments);
          }};
}

}  // namespace wend::cli
