#include "wend/report/map_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/io/text.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

/// "1 cell", "12 cells"
std::string cells_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "cell" : "cells");
}

/// "12.5 %". What is not all or nothing never reads "100.0 %" or "0.0 %".
std::string percent_text(std::size_t part, std::size_t whole) {
  if (part == 0 || part == whole) return fmt::format("{:.0f} %", percent(part, whole));
  constexpr double kLeast = 0.1;
  return fmt::format("{:.1f} %", std::clamp(percent(part, whole), kLeast, 100 - kLeast));
}

std::string share(std::size_t part, std::size_t whole) {
  return fmt::format("{} ({})", cells_text(part), percent_text(part, whole));
}

std::string size_text(const MapInfo& info) {
  const bool one = info.width == 1 && info.height == 1;
  std::string text = fmt::format("{} x {} {}", info.width, info.height, one ? "cell" : "cells");
  if (info.frame.metric) {
    text += fmt::format(", {:.6g} x {:.6g} m", info.width * info.frame.resolution,
                        info.height * info.frame.resolution);
  }
  return text;
}

std::string terrain_text(const MapInfo& info) {
  if (info.space.least_terrain == 1 && info.space.greatest_terrain == 1)
    return "costs the same everywhere";
  return fmt::format(
      "costs {:.4g} to {:.4g} times the length, {:.4g} on average; "
      "planners round to 1/{}",
      info.space.least_terrain, info.space.greatest_terrain, info.space.mean_terrain,
      CostMap::kOne);
}

std::string components_text(const MapInfo& info) {
  if (info.space.components == 0) return "none: the robot fits nowhere";
  if (info.space.components == 1 && info.space.passable == 1) return "1, of one cell";
  if (info.space.components == 1) return "1: every free cell can be reached from every other";
  return fmt::format("{}; the largest has {}, {} of the free ones", info.space.components,
                     cells_text(info.space.largest_component),
                     percent_text(info.space.largest_component, info.space.passable));
}

std::string frame_text(const Frame& frame) {
  const std::string up = frame.y_up ? "y up" : "y down, cell 0,0 top left";
  if (!frame.metric) return "cells, " + up;
  return fmt::format("{} m a cell, origin ({}, {}) m, yaw {} rad ({:.1f} degrees), {}",
                     format_number(frame.resolution), format_number(frame.origin.x),
                     format_number(frame.origin.y), format_number(frame.origin.heading),
                     degrees_from(frame.origin.heading), up);
}

}  // namespace

Expected<MapInfo, Error> map_info(std::string file, const LoadedMap& loaded,
                                  const FreeSpaceOptions& robot) {
  const GridMap& map = loaded.map;
  MapInfo info;
  info.file = std::move(file);
  info.format = loaded.format;
  info.width = map.width();
  info.height = map.height();
  info.occupied = map.occupied().count();
  info.unknown = map.unknown().count();
  info.free = map.size() - info.occupied - info.unknown;
  info.footprint = robot.footprint;
  info.outside = robot.outside.value_or(default_outside_policy(map.frame()));
  info.clearance_distance = robot.clearance_distance;
  auto space = survey(map, robot);
  if (!space) return Unexpected<Error>(std::move(space).error());
  info.space = *space;
  info.frame = map.frame();
  info.notes = loaded.notes;
  return info;
}

std::string map_info_json(const MapInfo& info) {
  const MapPose& origin = info.frame.origin;
  const Json json{
      {"file", info.file},
      {"format", to_string(info.format)},
      {"width", info.width},
      {"height", info.height},
      {"free", info.free},
      {"occupied", info.occupied},
      {"unknown", info.unknown},
      {"terrain",
       {{"least", info.space.least_terrain},
        {"mean", info.space.mean_terrain},
        {"greatest", info.space.greatest_terrain},
        {"step", 1.0 / CostMap::kOne}}},
      {"robot_radius", info.footprint.circumscribed_radius()},
      {"footprint", text_of(info.footprint)},
      {"outside", info.outside == OutsidePolicy::blocked ? "blocked" : "free"},
      {"passable", info.space.passable},
      {"keep_away", {{"distance", info.clearance_distance}, {"cells", info.space.near_obstacles}}},
      {"components", {{"count", info.space.components}, {"largest", info.space.largest_component}}},
      {"frame",
       {{"resolution", info.frame.resolution},
        {"origin", Json::array({origin.x, origin.y, origin.heading})},
        {"y_up", info.frame.y_up},
        {"metric", info.frame.metric}}},
      {"notes", info.notes}};
  return text_of(json);
}

std::string map_info_text(const MapInfo& info) {
  const std::size_t all = info.free + info.occupied + info.unknown;
  const std::string_view unit = info.frame.metric ? " m" : " cells";
  std::string text = fmt::format("{}: {}\n", visible(info.file), to_string(info.format));
  const auto line = [&text](std::string_view name, const std::string& what) {
    text += fmt::format("  {:<12}{}\n", name, what);
  };
  line("size", size_text(info));
  line("free", share(info.free, all));
  line("occupied", share(info.occupied, all));
  line("unknown", share(info.unknown, all));
  line("terrain", terrain_text(info));
  const double radius = info.footprint.circumscribed_radius();
  if (radius > 0) {
    line("passable",
         share(info.space.passable, all) +
             fmt::format(
                 " for a {} of radius {:.4g}{}{}",
                 info.footprint.outline() ? "disc around the footprint" : "robot", radius, unit,
                 info.outside == OutsidePolicy::blocked ? " that stays on the map"
                                                        : " that may hang over the map's edge"));
  }
  if (info.clearance_distance > 0) {
    line("keep away", share(info.space.near_obstacles, info.space.passable) +
                          fmt::format(" cost more: an obstacle is within {:.4g}{} of the robot; "
                                      "planners round to 1/{}",
                                      info.clearance_distance, unit, CostMap::kOne));
  }
  line("components", components_text(info));
  line("frame", frame_text(info.frame));
  for (const std::string& note : info.notes) line("note", visible(note));
  return text;
}

}  // namespace wend
