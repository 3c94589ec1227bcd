// wend check: is a path free, and where does it first collide?

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/refine_arguments.hpp"
#include "cli/arguments/request_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/plan_text.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/report/path_report.hpp"

namespace wend::cli {
namespace {

struct CheckArguments {
  MapArguments map;
  std::string path;
  GridMoves moves;
  std::optional<double> corner_rounding;  // in the user's units
  RequestArguments request;
  Format format = Format::text;
  PictureArguments pictures;
  OutputFiles output;
};

constexpr const char* kCheckExamples = R"(Examples:
  wend check office.yaml plan.csv --robot-radius 0.2
  wend check office.yaml plan.json --robot-radius 0.25 -o collision.png
  wend check office.yaml plan.csv --footprint '0.4,0.25;0.4,-0.25;-0.3,0'
  wend check track.yaml centerline.csv --robot-radius 0.3 --format json

A path is a file of `wend plan -o` or `wend smooth -o` (.csv, .json; the
smoothed path if there is one), or a centreline in metres. The robot's disc is
swept along the path exactly. A polygon (--footprint) faces along the path and
turns in place where it bends; turns are checked to 0.01 cells. Exit codes:
0 free, 1 not free (standard error shows the first collision), 2 bad usage or
input.)";

/// The beginning of a path that leads so far off the map that it cannot be measured: until it leaves the map.
Path until_exit(const Path& path, const FreeSpace& space) {
  const auto exit = first_exit(path, space);
  if (!exit) return path;
  std::vector<Point> points = path.points();
  points.resize(std::min(exit->piece + 1, points.size()));
  points.push_back(exit->point);
  return Path::along(std::move(points));
}

/// Paths that leave the map are shown as far as they are on it.
Scene scene_of(const FreeSpace& space, const Path& path,
               const std::optional<PathCollision>& collision) {
  Scene scene = wend::scene_of(space, path);
  if (collision) scene.collision = collision->point;
  return scene;
}

std::string text_of(const CheckArguments& arguments, const Scene& scene, const MeasuredPath& path,
                    const LedPath& led) {
  const Coordinates coordinates = arguments.map.coordinates(scene.space.map());
  const bool is_free = !led.collision;
  std::string text;
  if (led.lead > 0) {
    text = fmt::format("lead out: for {} the robot leaves what it overlaps at the start\n",
                       coordinates.length(led.lead));
  }
  if (is_free && scene.space.outline()) {
    text += "free: the robot's footprint is clear of every obstacle along the path\n";
  } else if (is_free) {
    text += scene.space.is_point()
                ? "free: the path is clear of obstacles\n"
                : fmt::format("free: the robot's radius of {} is clear of every obstacle\n",
                              coordinates.length(scene.space.radius_in_cells()));
  }
  text += metrics_table(std::vector{path}, coordinates.unit());
  return picture_above(text, scene, detect_screen(), arguments.pictures);
}

int run(const CheckArguments& arguments) {
  arguments.output.check();
  check_read_once({arguments.map.file, arguments.path});
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  arguments.output.check_not_among({arguments.path});
  const FreeSpace space = arguments.map.free_space(loaded.map);
  const Path path = load_path_for(space, arguments.path, PathStage::smoothed);
  const Coordinates coordinates = arguments.map.coordinates(loaded.map);
  const double escape = arguments.request.leeway(coordinates).escape_in_cells(loaded.map.frame());
  const LedPath led = check_with_lead(path, space, escape, arguments.moves.adjacency());
  if (!led.ends_free && !led.collision) {
    complain("the path is not free: it ends where the robot does not fit");
    return no_plan;
  }
  const auto& collision = led.collision;
  const MeasuredPath measures = measured(
      "path", path, space,
      corner_rounding_in_cells(arguments.corner_rounding, arguments.map.coordinates(loaded.map)));
  const Path shown = measures.metrics ? path : until_exit(path, space);
  const Scene scene = scene_of(space, shown, collision);
  const std::string json = check_json(measures, collision, loaded.map.frame(), led.lead);
  print(arguments.format == Format::json ? json : text_of(arguments, scene, measures, led));
  auto writers = picture_writers({{{}, scene}}, arguments.pictures.style);
  writers[".json"] = [&](const std::string& file) { return write_bytes(file, json); };
  arguments.output.write(writers);
  if (!collision) return success;
  complain(not_free_text(*collision, arguments.map.coordinates(loaded.map)));
  return no_plan;
}

}  // namespace

Command add_check(Parser& app) {
  Parser check = app.add_subcommand("check", "Check a path for collisions and measure it");
  const auto arguments = std::make_shared<CheckArguments>();
  arguments->map.add_to(check);
  add_path_file(check, arguments->path);
  arguments->request.add_to(check, {"escape"});
  add_corner_rule(check, arguments->moves.corner_rule);
  add_corner_rounding(check, arguments->corner_rounding);
  add_format(check, arguments->format);
  arguments->pictures.add_to(check);
  auto extensions = picture_extensions();
  extensions.emplace_back(".json");
  arguments->output.add_to(check, std::move(extensions),
                           "Also write a picture (.png, .svg, .pdf) that marks the first "
                           "collision, or the JSON; may be given several times");
  check.footer(kCheckExamples);
  return {check, [check, arguments] {
            arguments->pictures.check(check, arguments->output.any_picture(),
                                      arguments->format != Format::json);
            return run(*arguments);
          }};
}

}  // namespace wend::cli
