// wend smooth: a path simplified, smoothed and resampled.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/refine_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/arguments/trajectory_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/plan_text.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/path/path_csv.hpp"

namespace wend::cli {
namespace {

constexpr std::string_view kNoSmoother = "none";
constexpr NumberRange kSmoothedRadii{0, 1e6, kMapUnit};

struct SmoothArguments {
  MapArguments map;
  std::string path;
  GridMoves moves;
  std::string smoother = "gradient";
  OptionFlags options{"smoother"};
  std::optional<double> turning_radius;  // in the user's units
  std::optional<double> max_distance;    // the same
  RefineArguments points;
  TrajectoryArguments trajectory;
  Format format = Format::text;
  PictureArguments pictures;
  OutputFiles output;
};

constexpr const char* kSmoothExamples = R"(Examples:
  wend smooth office.yaml plan.csv --robot-radius 0.2 -o smooth.csv -o both.png
  wend smooth office.yaml plan.json --alpha 0.02 --simplify=sight --resample 0.1
  wend smooth office.yaml plan.csv --smoother curvature --turning-radius 0.5
  wend smooth office.yaml plan.csv --smoother none --simplify=sight -o taut.csv
  wend smooth office.yaml plan.csv --unsafe --format json
  wend smooth office.yaml plan.csv --trajectory t.csv --velocity-limits speed=1

A path is a file of `wend plan -o` (.csv, .json; the planned path of a plan), or
a centreline in metres. The path is simplified first (--simplify), then
smoothed, then resampled. Without --unsafe the result is clear of obstacles.
Exit codes: 0 done, 1 the given path is not free (standard error gives the
reason), 2 bad usage or input.)";

/// Options that the command sets with flags of its own.
bool is_said_by_a_flag(const OptionInfo& option) {
  return option.name == "squeeze" || option.name == "radius" || option.name == "turning_radius" ||
         option.name == "max_distance";
}

bool is_unsafe(const SmootherChoice& choice) {
  bool unsafe = false;
  for (const auto& [name, value] : choice.options) {
    if (name == "unsafe") unsafe = value == option_text::format(true);
  }
  return unsafe;
}

std::optional<SmootherChoice> smoother_of(const SmoothArguments& arguments,
                                          const Coordinates& coordinates) {
  if (arguments.smoother == kNoSmoother) {
    arguments.options.values_for(arguments.smoother);  // refuses them
    if (arguments.turning_radius)
      throw InputError("--turning-radius has no effect with --smoother none");
    if (arguments.max_distance)
      throw InputError("--max-distance has no effect with --smoother none");
    return std::nullopt;
  }
  SmootherChoice choice = parse_smoother(arguments.smoother);
  const OptionValues flags = arguments.options.values_for(choice.name);
  choice.options.insert(choice.options.end(), flags.begin(), flags.end());
  if (arguments.turning_radius) {
    const std::vector<OptionInfo>& known = smoothers().find(choice.name)->options;
    if (has_option(known, "radius")) {
      choice.options.emplace_back("radius",
                                  format_number(coordinates.in_cells(*arguments.turning_radius)));
    } else if (has_option(known, "turning_radius")) {
      choice.options.emplace_back("turning_radius",
                                  format_number(coordinates.in_metres(*arguments.turning_radius)));
    } else {
      throw InputError(
          fmt::format("--turning-radius changes nothing: the smoother {} has no turning radius; "
                      "add --smoother curvature or, for a path of poses, --smoother drive",
                      choice.name));
    }
  }
  return choice;
}

/// The extension of the format that -o - writes.
std::string printed_extension(Format format) { return format == Format::json ? ".json" : ".csv"; }

std::map<std::string, FileWriter> writers_of(const SmoothArguments& arguments,
                                             const RefinedPath& path,
                                             const std::optional<SampledTrajectory>& trajectory,
                                             const FreeSpace& space, const Scene& scene) {
  const Frame& frame = space.map().frame();
  auto writers = picture_writers({{{}, scene}}, arguments.pictures.style);
  writers[".json"] = [&path, &trajectory, frame](const std::string& file) {
    return write_bytes(file, smoothing_json(path, frame, trajectory));
  };
  writers[".csv"] = [&path, frame](const std::string& file) {
    return write_bytes(file, path_csv(path.refined.path, frame));
  };
  return writers;
}

/// The path's collision that prevents safe smoothing, if that is asked for.
std::optional<PathCollision> collision_of(const Path& path, const FreeSpace& space,
                                          const Refinement& refinement) {
  if (!refinement.smoother || is_unsafe(*refinement.smoother)) return std::nullopt;
  return first_collision(path, space, refinement.adjacency);
}

/// Replaces output files of earlier commands with the reason for the failure.
void write_failure(const SmoothArguments& arguments, const FailedPlan& plan, const Scene& scene) {
  arguments.trajectory.write_failure(plan);
  auto writers =
      picture_writers({{"no path: " + plan.status, scene, plan.reason}}, arguments.pictures.style);
  writers[".json"] = [&](const std::string& file) {
    return write_bytes(file, failed_plan_json(plan));
  };
  writers[".csv"] = [&](const std::string& file) { return write_bytes(file, no_path_csv(plan)); };
  arguments.output.write(writers, printed_extension(arguments.format));
}

/// The path to smooth. If its file says that there is no path, the written files say so too.
Path path_to_smooth(const SmoothArguments& arguments, const FreeSpace& space,
                    const Coordinates& coordinates) {
  try {
    return load_path_on(space, coordinates, arguments.path, PathStage::planned);
  } catch (const NoPathError& error) {
    write_failure(arguments, error.plan(), Scene{.space = space});
    throw;
  }
}

void refuse_collision(const SmoothArguments& arguments, const FreeSpace& space, const Path& path,
                      const PathCollision& collision, const Coordinates& coordinates) {
  const FailedPlan failed{
      "not_free", fmt::format("the path is not free and can only be smoothed with --unsafe: {}",
                              collision_text(collision, coordinates))};
  Scene scene = scene_of(space, path);
  scene.collision = collision.point;
  write_failure(arguments, failed, scene);
  throw NoPathError(failed.reason, failed);
}

std::optional<SampledTrajectory> trajectory_of(const SmoothArguments& arguments, const Path& path,
                                               const FreeSpace& space, Adjacency adjacency) {
  if (!arguments.trajectory.wanted()) return std::nullopt;
  const double window = arguments.points.rounding(arguments.map.coordinates(space.map()));
  auto sampled =
      arguments.trajectory.along(path, space, window, adjacency, arguments.trajectory.limits());
  arguments.trajectory.write(sampled);
  return sampled;
}

int run(const SmoothArguments& arguments) {
  arguments.output.check();
  check_read_once({arguments.map.file, arguments.path});
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  arguments.trajectory.check_not_among(loaded.files);
  arguments.output.check_not_among({arguments.path});  // a failure would replace the path
  arguments.trajectory.check_not_among({arguments.path});
  const FreeSpace space = arguments.map.free_space(loaded.map);
  const Coordinates coordinates = arguments.map.coordinates(loaded.map);
  const Path path = path_to_smooth(arguments, space, coordinates);
  Refinement refinement = arguments.points.refinement(coordinates);
  refinement.adjacency = arguments.moves.adjacency();
  refinement.smoother = smoother_of(arguments, coordinates);
  if (arguments.max_distance) {
    refinement.max_distance = coordinates.in_cells(*arguments.max_distance);
  }
  if (const auto collision = collision_of(path, space, refinement)) {
    refuse_collision(arguments, space, path, *collision, coordinates);
  }
  const RefinedPath refined =
      refine(path, space, refinement, arguments.points.rounding(coordinates));
  const auto trajectory =
      trajectory_of(arguments, refined.refined.path, space, refinement.adjacency);
  const Scene scene = scene_of(space, lines_of(refined));
  if (!arguments.output.print()) {
    print(arguments.format == Format::json
              ? smoothing_json(refined, loaded.map.frame(), trajectory)
              : picture(scene, detect_screen(), arguments.pictures) +
                    refined_text(refined, coordinates) +
                    (trajectory ? trajectory_text(trajectory->trajectory) : ""));
  }
  arguments.output.write(writers_of(arguments, refined, trajectory, space, scene),
                         printed_extension(arguments.format));
  return success;
}

void add_smoothers(Parser& app, SmoothArguments& arguments) {
  std::string names;
  for (const SmootherInfo& smoother : smoothers()) {
    names += fmt::format("{}: {}; ", smoother.name, smoother.summary);
    std::vector<OptionInfo> options = smoother.options;
    std::erase_if(options, is_said_by_a_flag);
    arguments.options.collect(smoother.name, options);
  }
  app.add_option(
         "--smoother", arguments.smoother,
         wrapped("Smoother (default gradient; of a path of poses drive). " + names + "none"))
      .type_name(kSmootherType);
  add_number(
      app, "--turning-radius", arguments.turning_radius, kSmoothedRadii,
      "Lower limit on the turning radius, for --smoother curvature and --smoother drive (units as "
      "--robot-radius)");
  add_max_distance(app, arguments.max_distance);
  arguments.points.add_points_to(app);
  arguments.trajectory.add_file_to(app);
  arguments.trajectory.add_limits_to(app);
  arguments.options.add_to(app, "--smoother");
  app.further({"--simplify", "--resample", "--corner-rule"});
}

}  // namespace

Command add_smooth(Parser& app) {
  Parser smooth = app.add_subcommand("smooth", "Smooth or simplify a path, clear of obstacles");
  const auto arguments = std::make_shared<SmoothArguments>();
  arguments->map.add_to(smooth);
  add_path_file(smooth, arguments->path);
  add_corner_rule(smooth, arguments->moves.corner_rule);
  add_format(smooth, arguments->format);
  arguments->pictures.add_to(smooth);
  arguments->output.add_to(
      smooth, {".csv", ".json", ".png", ".svg", ".pdf"},
      "Also write the path (.csv, .json) or a picture of both paths (.png, .svg, .pdf); may be "
      "given several times. If the path is not free, the file states the reason instead",
      "the path (JSON with --format json, else CSV)");
  add_smoothers(smooth, *arguments);
  smooth.footer(kSmoothExamples);
  return {smooth, [smooth, arguments] {
            arguments->pictures.check(smooth, arguments->output.any_picture(),
                                      arguments->format != Format::json);
            if (arguments->smoother == kNoSmoother && !arguments->points.any() &&
                !arguments->trajectory.wanted() && !smooth.given("--corner-rounding")) {
              throw InputError("--smoother none changes nothing: add --simplify or --resample");
            }
            arguments->trajectory.check(smooth, arguments->output);
            arguments->trajectory.limits();  // wrong ones are refused before the work
            return run(*arguments);
          }};
}

}  // namespace wend::cli
