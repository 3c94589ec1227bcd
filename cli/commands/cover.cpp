// wend cover: a path on which a tool passes over every place that it can reach.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/coverage_scene.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "wend/base/parse.hpp"
#include "wend/cover/plan_coverage.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/io/map/save_map.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/map/masked.hpp"
#include "wend/report/coverage_report.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kWidths{1e-6, 1e6, kMapUnit};
constexpr NumberRange kLengths{0, 1e6, kMapUnit};
constexpr NumberRange kCoveredShares{1e-6, 1};
constexpr std::string_view kAutomatic = "auto";
constexpr std::size_t kMostMissed = 5;  // places that are explained

struct CoverArguments {
  MapArguments map;
  double tool_width = 0;  // in the user's units, as all lengths here
  double overlap = 0;
  std::string angle{kAutomatic};
  std::optional<double> turn_cost;
  double share = CoverageOptions{}.share;
  std::string start;
  std::string end;
  std::string area;
  std::string covered;
  std::uint64_t seed = CoverageOptions{}.seed;
  LimitArguments limits;
  Format format = Format::text;
  PictureArguments pictures;
  OutputFiles output;
};

constexpr const char* kCoverExamples = R"(Examples:
  wend cover office.yaml --robot-radius 0.175 --tool-width 0.35 -o cover.csv
  wend cover office.yaml --robot-radius 0.2 --tool-width 0.3 -o cover.png
  wend cover office.yaml --robot-radius 0.2 --tool-width 0.3 -o cover.gif
  wend cover office.yaml --robot-radius 0.2 --tool-width 0.3 --area zone.yaml
  wend cover office.yaml --robot-radius 0.2 --tool-width 0.3 -o done.pgm
  wend cover office.yaml --robot-radius 0.2 --tool-width 0.3 --covered done.pgm

The tool is a disc in the middle of the robot. A cell is covered if its centre is
at most half the tool's width from the path. The robot drives where it fits at
every heading. --area and --covered are masks as --mask reads them: their
occupied cells count. -o FILE.pgm writes such a mask of what the path covers.
Exit codes: 0 covered, 1 there is no such path (standard error gives the
reason), 2 bad usage or input.)";

std::optional<double> angle_of(const CoverArguments& arguments, const GridMap& map) {
  if (arguments.angle == kAutomatic) return std::nullopt;
  const auto degrees = parse_number(arguments.angle);
  if (!degrees || !(*degrees >= -360 && *degrees <= 360)) {
    throw InputError(
        fmt::format("--angle {}: auto or degrees from -360 to 360 expected", arguments.angle));
  }
  return *degrees * kPi / 180 - map.frame().origin.heading;
}

/// The cells of the map that a mask marks.
std::optional<BitGrid> cells_of(const std::string& file, const GridMap& map) {
  if (file.empty()) return std::nullopt;
  const auto mask = load_mask(file);
  if (!mask) throw InputError(mask.error().message);
  const auto here = mask_on_grid_of(map, mask->map);
  if (!here) throw InputError(fmt::format("{}: {}", file, here.error().message));
  return here->occupied();
}

std::optional<Point> place_of(const std::string& name, const std::string& typed,
                              const Coordinates& coordinates) {
  if (typed.empty()) return std::nullopt;
  return coordinates.parse_in_grid(name, typed);
}

CoverageOptions options_of(const CoverArguments& arguments, const GridMap& map) {
  const Coordinates coordinates = arguments.map.coordinates(map);
  CoverageOptions options;
  options.tool_width = coordinates.in_metres(arguments.tool_width);
  options.overlap = coordinates.in_metres(arguments.overlap);
  options.angle = angle_of(arguments, map);
  if (arguments.turn_cost) options.turn_cost = coordinates.in_metres(*arguments.turn_cost);
  options.share = arguments.share;
  options.start = place_of("start", arguments.start, coordinates);
  options.end = place_of("end", arguments.end, coordinates);
  options.area = cells_of(arguments.area, map);
  options.covered = cells_of(arguments.covered, map);
  options.seed = arguments.seed;
  options.limits = arguments.limits.limits();
  return options;
}

Coverage coverage_of(const FreeSpace& space, const CoverageOptions& options) {
  auto coverage = plan_coverage(space, options);
  if (coverage) return std::move(*coverage);
  const Error& error = coverage.error();
  if (error.status == Status::invalid_option) throw InputError(error.message);
  throw NoPathError(error.message, {std::string(to_string(error.status)), error.message});
}

std::string write_mask(const std::string& file, const Coverage& coverage,
                       const std::optional<BitGrid>& before, const Frame& frame) {
  BitGrid cells = coverage.covered;
  for (const Cell cell : every_cell(cells)) {
    if (before && (*before)[cell]) cells.set(cell, true);
  }
  const auto mask = make_grid_map(cells, BitGrid(cells.width(), cells.height()), frame);
  if (!mask) return mask.error().message;
  const auto saved = save_map(*mask, file);
  return saved ? std::string() : saved.error().message;
}

void write_files(const CoverArguments& arguments, const FreeSpace& space,
                 const CoverageOptions& options, const Coverage& coverage,
                 const std::string& json) {
  const Frame& frame = space.map().frame();
  auto writers = picture_writers({{{}, coverage_scene(space, coverage, options.tool_width)}},
                                 arguments.pictures.style);
  writers[".csv"] = [&](const std::string& file) {
    if (!coverage.path.empty()) return write_bytes(file, path_csv(coverage.path, frame));
    return write_bytes(file, no_path_csv({"found", "nothing is left to cover"}));
  };
  writers[".json"] = [&](const std::string& file) { return write_bytes(file, json); };
  writers[".pgm"] = [&](const std::string& file) {
    return write_mask(file, coverage, options.covered, frame);
  };
  writers[".gif"] = [&](const std::string& file) {
    return write_picture(file, coverage_gif(space, coverage, options.tool_width,
                                            style_of(arguments.pictures.style)));
  };
  arguments.output.write(writers);
}

int run(const CoverArguments& arguments) {
  arguments.output.check();
  check_read_once({arguments.map.file, arguments.area, arguments.covered});
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  for (const std::string& mask : {arguments.area, arguments.covered}) {
    if (!mask.empty()) arguments.output.check_not_among({mask});
  }
  const FreeSpace space = arguments.map.free_space(loaded.map);
  const CoverageOptions options = options_of(arguments, loaded.map);
  const Interruptible interruptible;
  const Coverage coverage = coverage_of(space, options);
  const auto missed = missed_places(space, coverage, kMostMissed);
  const std::string json = coverage_json(coverage, missed, loaded.map.frame(), options.tool_width);
  if (arguments.format == Format::json) {
    print(json);
  } else {
    print(picture_above(coverage_text(coverage, missed, arguments.map.coordinates(loaded.map)),
                        coverage_scene(space, coverage, options.tool_width), detect_screen(),
                        arguments.pictures));
  }
  write_files(arguments, space, options, coverage, json);
  return success;
}

void add_places(Parser& cover, CoverArguments& arguments) {
  cover.add_option("--start", arguments.start, wrapped("Where the path begins (default: anywhere)"))
      .type_name("X,Y");
  cover.add_option("--end", arguments.end, wrapped("Where the path ends (default: anywhere)"))
      .type_name("X,Y");
  cover.add_option("--area", arguments.area, wrapped("Mask of the cells to cover (default: all)"))
      .type_name(kFileType);
  cover
      .add_option("--covered", arguments.covered,
                  wrapped("Mask of the cells that are covered already"))
      .type_name(kFileType);
}

}  // namespace

Command add_cover(Parser& app) {
  Parser cover =
      app.add_subcommand("cover", "Cover an area: a path over every place that a tool can reach");
  const auto arguments = std::make_shared<CoverArguments>();
  arguments->map.add_to(cover);
  add_number(cover, "--tool-width", arguments->tool_width, kWidths,
             "Width of the tool, from 2 to 500 cells of the map (units as --robot-radius)")
      .required();
  add_number(cover, "--overlap", arguments->overlap, kLengths,
             "How much neighbouring swaths overlap (default 0)");
  cover
      .add_option(
          "--angle", arguments->angle,
          wrapped("Angle of the swaths in degrees from the map's +x, or auto: each room its "
                  "cheapest one (default auto)"))
      .type_name("DEG");
  add_number(cover, "--turn-cost", arguments->turn_cost, kLengths,
             "What turning around costs, as a length (default: the tool's width)");
  add_number(cover, "--share", arguments->share, kCoveredShares,
             "Share of what the tool can reach that is to be covered (default 0.999)");
  add_places(cover, *arguments);
  add_count(cover, "--seed", arguments->seed, "Seed of the search for the order (default 1)");
  arguments->limits.add_to(cover);
  add_format(cover, arguments->format);
  arguments->pictures.add_to(cover);
  arguments->output.add_to(
      cover, {".csv", ".json", ".png", ".svg", ".pdf", ".gif", ".pgm"},
      "Also write the path (.csv), all results (.json), a picture (.png, .svg, "
      ".pdf), a film (.gif) or a mask of what is covered (.pgm); may be given "
      "several times");
  cover.footer(kCoverExamples);
  return {cover, [cover, arguments] {
            arguments->pictures.check(cover, arguments->output.any_picture(),
                                      arguments->format != Format::json);
            return run(*arguments);
          }};
}

}  // namespace wend::cli
