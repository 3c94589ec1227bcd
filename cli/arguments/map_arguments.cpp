#include "cli/arguments/map_arguments.hpp"

#include <fmt/format.h>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/explanations.hpp"
#include "wend/base/parse.hpp"
#include "wend/base/status.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/available_memory.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/map/masked.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/session/session.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kResolutions{1e-6, 1e6, "metres per cell"};
constexpr NumberRange kMegabytes{0, 1e9, "MB"};

/// Does it say what cells cost, which not every command uses?
bool is_of_costs(const RobotField& field) { return field.info.name.starts_with("clearance_"); }

/// "5.3 GB", "120 MB"
std::string size_of(double bytes) {
  const double megabytes = bytes / 1e6;
  return megabytes < 1000 ? fmt::format("{:.3g} MB", megabytes)
                          : fmt::format("{:.3g} GB", megabytes / 1000);
}

void lay_mask(const MaskSpec& spec, LoadedMap& loaded) {
  LoadedMap mask = value_or_throw(load_mask(spec.file, spec.reading));
  auto under_it = masked(loaded.map, mask.map);
  if (!under_it) {
    throw InputError(fmt::format("--mask {}: {}", spec.file.string(), under_it.error().message));
  }
  loaded.map = *std::move(under_it);
  for (const std::string& note : mask.notes) {
    loaded.notes.push_back(fmt::format("{}: {}", spec.file.string(), note));
  }
  loaded.files.insert(loaded.files.end(), mask.files.begin(), mask.files.end());
}

}  // namespace

void MapFileArguments::add_to(Parser& app, const std::string& name) {
  app.add_option(
         name, file,
         wrapped("Map file: " + map_formats_text(MapUse::load) + "; - reads standard input"))
      .required()
      .type_name(kFileType);
  add_number(app, "--resolution", resolution, kResolutions,
             "Resolution of a bare image in metres per cell; its unit of length is then the metre");
  const auto assign_masks = [this](const std::vector<std::string>& texts) {
    masks.clear();
    for (const std::string& text : texts) {
      auto spec = parse_mask_spec(text);
      if (!spec) refuse_value("--mask", spec.error().message);
      masks.push_back(*std::move(spec));
    }
  };
  app.add_list(
         "--mask", assign_masks,
         wrapped("Mask over the map, [keepout:]FILE or speed:FILE; can be repeated. Occupied "
                 "cells of a keep-out mask (a map file) are blocked, and its costs multiply "
                 "those of the map. Values 1 to 100 of a speed mask (a map.yaml with mode: "
                 "scale or raw) are percent of the top speed, and make a cell cost its time; "
                 "speed:base=B:multiplier=M:FILE reads v as B + M v, and top_speed=T: as m/s"))
      .one_at_a_time()
      .type_name(kFileType);
  app.further({"--resolution", "--mask"});
}

LoadedMap MapFileArguments::load() const {
  LoadedMap loaded = load_silently();
  complain_of_notes(file, loaded);
  return loaded;
}

LoadedMap MapFileArguments::load_silently() const {
  LoadOptions options;
  options.resolution = resolution;
  LoadedMap loaded = read_map(file, options);
  if (resolution && !info_of(loaded.format).takes_resolution) {
    throw InputError(fmt::format("--resolution is for bare images, and {} is {}", file,
                                 info_of(loaded.format).noun));
  }
  for (const MaskSpec& mask : masks) lay_mask(mask, loaded);
  return loaded;
}

void RobotArguments::add_robot_to(Parser& app) {
  for (const RobotField& field : robot_fields()) {
    if (is_of_costs(field)) continue;
    const Argument added = fields.add_to(app, field);
    if (field.info.is_called("robot_radius")) {
      add_footprint_to(app, added);
    } else {
      app.further({flag_of(field.info)});
    }
  }
  app.add_flag("--cells", cells, wrapped("Use cells as the unit of length on maps in metres"));
  app.further({"--cells"});
}

void RobotArguments::add_footprint_to(Parser& app, const Argument& radius) {
  const auto assign_footprint = [this](const std::string& text) {
    auto parsed = parse_footprint(text);
    if (!parsed) refuse_value("--footprint", parsed.error().message);
    footprint = *std::move(parsed);
  };
  app.add_option(
         "--footprint", assign_footprint,
         wrapped("Shape of the robot: the corners of a polygon 'x,y;x,y;x,y', seen from its "
                 "base point (0,0), x ahead and y to its left, 'rect:LENGTHxWIDTH[,AHEAD]', "
                 "whose centre lies AHEAD of the base point (default 0), or 'disc:RADIUS' "
                 "(units as --robot-radius). Planners on cells use the smallest disc "
                 "around the base point that covers a polygon"))
      .type_name("SHAPE")
      .excludes(radius);
}

void RobotArguments::add_clearance_cost_to(Parser& app) {
  for (const RobotField& field : robot_fields()) {
    if (is_of_costs(field)) fields.add_to(app, field);
  }
  app.further({"--clearance-cost"});
}

void RobotArguments::add_primitives_to(Parser& app) {
  app.add_option(
         "--primitives", primitives,
         wrapped("Motion primitives of the robot, for the planner lattice: SBPL's .mprim or "
                 "the JSON of Nav2's lattice generator. Without them the robot drives "
                 "straight in 16 directions and turns in place, or on arcs of its "
                 "--turning-radius"))
      .type_name(kFileType);
  app.further({"--primitives"});
}

FreeSpaceOptions RobotArguments::as_typed() const {
  FreeSpaceOptions robot;
  fields.put(robot);
  if (footprint) robot.footprint = *footprint;
  return robot;
}

FreeSpaceOptions RobotArguments::options(const GridMap& map) const {
  if (fields.typed("clearance_cost") && as_typed().clearance_distance == 0) {
    throw InputError("--clearance-cost changes nothing without --clearance-distance");
  }
  const Coordinates units = coordinates(map);
  FreeSpaceOptions robot;
  fields.put(robot, units);
  if (footprint) robot.footprint = footprint->scaled(units.in_metres(1));
  if (!primitives.empty()) robot.primitives = value_or_throw(load_primitives(primitives));
  return robot;
}

FreeSpace RobotArguments::free_space(const GridMap& map) const {
  return value_or_throw(make_free_space(map, options(map)));
}

void MapArguments::add_to(Parser& app) {
  MapFileArguments::add_to(app, "MAP");
  add_robot_to(app);
  add_number(app, "--limit-memory", limit_memory, kMegabytes,
             "Limit on memory in megabytes; a map that needs more is rejected (default: the memory "
             "available on the system)");
  app.further({"--limit-memory"});
}

LoadedMap MapArguments::load_map() const {
  LoadedMap loaded = MapFileArguments::load();
  if (!primitives.empty()) loaded.files.emplace_back(primitives);
  return loaded;
}

void MapArguments::check_memory(const GridMap& map, double need) const {
  constexpr double kMegabyte = 1e6;
  std::optional<double> available = available_memory();
  if (limit_memory) available = *limit_memory * kMegabyte;
  cli::check_memory(file, map, need, available);
}

FreeSpace MapArguments::free_space(const GridMap& map, double planner_bytes_per_cell) const {
  const FreeSpaceOptions robot = options(map);
  const double per_cell = free_space_bytes_per_cell(map, robot) + planner_bytes_per_cell;
  check_memory(map, per_cell * static_cast<double>(map.size()));
  return value_or_throw(make_free_space(map, robot));
}

std::unique_ptr<Session> MapArguments::session(const GridMap& map, std::size_t planners,
                                               double planner_bytes_per_cell,
                                               const Deadline& deadline) const {
  FreeSpaceOptions robot = options(map);
  const double per_cell = free_space_bytes_per_cell(map, robot) +
                          static_cast<double>(planners) * planner_bytes_per_cell;
  check_memory(map, per_cell * static_cast<double>(map.size()));
  auto session = std::make_unique<Session>(
      map, std::move(robot),
      SessionOptions{
          .idle_planners = planners, .hints = command_line_hints(), .clock = thread_cpu_seconds});
  const auto view = session->view(deadline);
  if (view) return session;
  const std::string& why = view.error().message;
  if (!deadline.passed()) throw InputError(why);
  throw NoPathError(why, {std::string(to_string(view.error().status)), why});
}

void check_memory(const std::string& file, const GridMap& map, double need,
                  std::optional<double> available) {
  if (!available || need <= *available) return;
  const std::string reason = fmt::format(
      "{}: {} x {} cells need about {} of memory, and {} are available; a coarser map needs less, "
      "and --limit-memory MB overrides the check",
      file, map.width(), map.height(), size_of(need), size_of(*available));
  throw NoPathError(reason, {std::string(to_string(Status::memory_limit)), reason});
}

}  // namespace wend::cli
