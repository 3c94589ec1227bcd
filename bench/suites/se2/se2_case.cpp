#include "bench/suites/se2/se2_case.hpp"

#include <optional>
#include <utility>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/map/connected_components.hpp"

namespace wend::bench {
namespace {

/// Cells of a map in cells become 0.1 m.
GridMap with_metres(const GridMap& map) {
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

std::vector<NamedMap> se2_maps(const std::vector<std::filesystem::path>& files, bool generated) {
  std::vector<NamedMap> maps = loaded_maps(files);
  const auto add = [&](const std::string& name, const std::string& kind, int width, int height,
                       const OptionValues& options) {
    maps.push_back({name, generated_map(kind, width, height, options)});
  };
  if (generated) {
    add("warehouse", "warehouse", 1000, 1700, {});
    add("office", "office", 600, 400, {});
    add("car_park", "car_park", 400, 300, {{"bay_width", "1"}});
    add("rooms", "rooms", 300, 300, {{"room_size", "30"}});
    add("clutter", "random", 200, 200, {{"density", "0.02"}});
  }
  for (NamedMap& named : maps) {
    if (!named.map.frame().metric) named.map = with_metres(named.map);
  }
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
