#include "bench/se2/se2_case.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/map/connected_components.hpp"

namespace wend::bench {
namespace {

constexpr std::uint64_t kMapSeed = 7;

/// Cells of a map in cells become 0.1 m.
GridMap in_metres(const GridMap& map) {
  if (map.frame().metric) return map;
  return *make_grid_map(map.occupied(), map.unknown(),
                        {.resolution = 0.1, .origin = {}, .y_up = true, .metric = true});
}

/// A pose in a cell at which the robot fits, after some tries.
std::optional<Pose> fitting_pose(const FreeSpace& space, Cell cell, Random& random) {
  constexpr int kTries = 8;
  for (int i = 0; i < kTries; ++i) {
    const Pose pose = pose_at(cell, (2 * random.uniform() - 1) * kPi);
    if (space.fits(pose)) return pose;
  }
  return std::nullopt;
}

}  // namespace

std::vector<NamedMap> loaded_maps(const std::vector<std::filesystem::path>& files) {
  std::vector<NamedMap> maps;
  for (const std::filesystem::path& file : files) {
    auto loaded = load_map(file);
    if (!loaded) {
      fmt::print(stderr, "{}: not measured: {}\n", file.string(), loaded.error().message);
      continue;
    }
    // A folder for each map is usual, with the same name for every file.
    const std::string stem = file.stem().string();
    const std::string name = stem == "map" ? file.parent_path().filename().string() : stem;
    maps.push_back({name, in_metres(loaded->map)});
  }
  return maps;
}

std::vector<NamedMap> generated_maps() {
  std::vector<NamedMap> maps;
  const auto add = [&](const std::string& name, const std::string& kind, int width, int height,
                       const OptionValues& options) {
    auto map = make_map(kind, width, height, kMapSeed, options);
    if (!map) {
      fmt::print(stderr, "{}: not measured: {}\n", name, map.error().message);
      return;
    }
    maps.push_back({name, in_metres(*map)});
  };
  add("warehouse", "warehouse", 1000, 1700, {});
  add("office", "office", 600, 400, {});
  add("car_park", "car_park", 400, 300, {{"bay_width", "1"}});
  add("rooms", "rooms", 300, 300, {{"room_size", "30"}});
  add("clutter", "random", 200, 200, {{"density", "0.02"}});
  return maps;
}

std::vector<NamedRobot> se2_robots() {
  const auto rectangle = parse_footprint("0.3,0.2; -0.3,0.2; -0.3,-0.2; 0.3,-0.2");
  return {{"disc 0.22 m, clearance cost",
           {.footprint = Footprint::disc(0.22), .clearance_distance = 0.33}},
          {"rectangle 0.6 x 0.4 m", {.footprint = *rectangle}}};
}

std::vector<Query> random_pose_queries(const FreeSpace& space, std::uint64_t count,
                                       std::uint64_t seed) {
  std::vector<Cell> cells;
  for (const Cell cell : every_cell(space)) {
    if (space.possible()[cell]) cells.push_back(cell);
  }
  std::vector<Query> queries;
  if (cells.empty()) return queries;
  const ConnectedComponents components(space.possible());
  Random random(seed);
  const std::uint64_t most_tries = 1000 * count;
  for (std::uint64_t i = 0; i < most_tries && queries.size() < count; ++i) {
    const Cell from = cells[random.below(cells.size())];
    const Cell to = cells[random.below(cells.size())];
    if (from == to || !components.connected(from, to, Adjacency::edges)) continue;
    const auto start = fitting_pose(space, from, random);
    const auto goal = fitting_pose(space, to, random);
    if (start && goal) queries.push_back({*start, {Goal(*goal)}});
  }
  return queries;
}

}  // namespace wend::bench
