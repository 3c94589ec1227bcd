#include "wend/report/map_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

void add_terrain(MapInfo& info, const FreeSpace& space) {
  double sum = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      if (!space.passable({x, y})) continue;
      const double terrain = space.map().terrain({x, y});
      info.near_obstacles += space.terrain({x, y}) > terrain ? 1 : 0;
      sum += terrain;
      least = std::min(least, terrain);
      info.greatest_terrain = std::max(info.greatest_terrain, terrain);
    }
  }
  if (info.passable == 0) return;
  info.least_terrain = least;
  info.mean_terrain = sum / static_cast<double>(info.passable);
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string share(std::size_t part, std::size_t whole) {
  return fmt::format("{} cells ({:.1f} %)", part, percent(part, whole));
}

std::string size_text(const MapInfo& info) {
  std::string text = fmt::format("{} x {} cells", info.width, info.height);
  if (info.frame.metric) {
    text += fmt::format(", {:.6g} x {:.6g} m", info.width * info.frame.resolution,
                        info.height * info.frame.resolution);
  }
  return text;
}

std::string terrain_text(const MapInfo& info) {
  if (info.least_terrain == 1 && info.greatest_terrain == 1) return "costs the same everywhere";
  return fmt::format("costs {:.4g} to {:.4g} times the length, {:.4g} on average",
                     info.least_terrain, info.greatest_terrain, info.mean_terrain);
}

std::string components_text(const MapInfo& info) {
  if (info.components == 0) return "none: there is no cell to stand on";
  if (info.components == 1) return "1: every free cell can be reached from every other";
  return fmt::format("{}; the largest has {} cells, {:.1f} % of the free ones", info.components,
                     info.largest_component, percent(info.largest_component, info.passable));
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

MapInfo map_info(std::string file, const LoadedMap& loaded, const FreeSpace& space) {
  const GridMap& map = space.map();
  MapInfo info;
  info.file = std::move(file);
  info.format = loaded.format;
  info.width = map.width();
  info.height = map.height();
  info.occupied = map.occupied().count();
  info.unknown = map.unknown().count();
  info.free = map.size() - info.occupied - info.unknown;
  info.robot_radius = space.options().robot_radius;
  info.outside = space.outside();
  info.keep_away = space.options().keep_away;
  info.passable = space.passable().count();
  const auto components = space.regions().sizes(Adjacency::edges);
  info.components = components.size();
  info.largest_component = components.empty() ? 0 : components.front();
  info.frame = map.frame();
  info.notes = loaded.notes;
  add_terrain(info, space);
  return info;
}

std::string map_info_json(const MapInfo& info) {
  const Pose& origin = info.frame.origin;
  const Json json{{"file", info.file},
                  {"format", to_string(info.format)},
                  {"width", info.width},
                  {"height", info.height},
                  {"free", info.free},
                  {"occupied", info.occupied},
                  {"unknown", info.unknown},
                  {"terrain",
                   {{"least", info.least_terrain},
                    {"mean", info.mean_terrain},
                    {"greatest", info.greatest_terrain}}},
                  {"robot_radius", info.robot_radius},
                  {"outside", info.outside == OutsidePolicy::blocked ? "blocked" : "free"},
                  {"passable", info.passable},
                  {"keep_away", {{"distance", info.keep_away}, {"cells", info.near_obstacles}}},
                  {"components", {{"count", info.components}, {"largest", info.largest_component}}},
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
  std::string text = fmt::format("{}: {}\n", info.file, to_string(info.format));
  const auto line = [&text](std::string_view name, const std::string& what) {
    text += fmt::format("  {:<12}{}\n", name, what);
  };
  line("size", size_text(info));
  line("free", share(info.free, all));
  line("occupied", share(info.occupied, all));
  line("unknown", share(info.unknown, all));
  line("terrain", terrain_text(info));
  if (info.robot_radius > 0) {
    line("passable", share(info.passable, all) +
                         fmt::format(" for a robot of radius {:.4g}{}{}", info.robot_radius, unit,
                                     info.outside == OutsidePolicy::blocked
                                         ? " that stays on the map"
                                         : " that may hang over the map's edge"));
  }
  if (info.keep_away > 0) {
    line("keep away", share(info.near_obstacles, info.passable) +
                          fmt::format(" cost more: an obstacle is within {:.4g}{} of the robot",
                                      info.keep_away, unit));
  }
  line("components", components_text(info));
  line("frame", frame_text(info.frame));
  for (const std::string& note : info.notes) line("note", note);
  return text;
}

}  // namespace wend
