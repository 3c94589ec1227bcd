// Coverages of real and of generated maps: how long the paths are, and how long planning takes.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "bench/measure/measuring.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/cover/plan_coverage.hpp"
#include "wend/path/path_collision.hpp"

namespace wend::bench {
namespace {

constexpr double kRadius = 0.175;  // metres
constexpr double kTool = 0.35;
constexpr std::array<std::string_view, 6> kRealMaps{
    "ros/pal_small_office/map.yaml", "ros/pal_office/map.yaml",
    "ros/rmp/museum.yaml",           "ros/rmp/warehouse.yaml",
    "ros/nav2/depot.yaml",           "ros/fetch/3_1_16_localization.yaml"};

std::vector<NamedMap> maps_to_cover() {
  std::vector<std::filesystem::path> files;
  if (!data_folder().empty()) {
    for (const std::string_view file : kRealMaps) files.push_back(data_folder() / file);
  }
  std::vector<NamedMap> maps = loaded_maps(files);
  maps.push_back({"office 320x200", in_metres(generated_map("office", 320, 200), 0.05)});
  maps.push_back({"warehouse 400x300", in_metres(generated_map("warehouse", 400, 300), 0.05)});
  return maps;
}

/// Prints a row of the table in docs/coverage.md. Throws Wrong for a path with a collision.
void measure_one(const NamedMap& map, int rounds) {
  const FreeSpace space =
      value_or_refuse(make_free_space(map.map, {.footprint = Footprint::disc(kRadius)}));
  double least = std::numeric_limits<double>::infinity();
  Coverage coverage;
  for (int round = 0; round < rounds; ++round) {
    const double began = thread_cpu_seconds();
    coverage = value_or_refuse(plan_coverage(space, {.tool_width = kTool}));
    least = std::min(least, thread_cpu_seconds() - began);
  }
  if (first_collision(coverage.path, space)) throw Wrong(map.name + ": the path is not free");
  const double resolution = map.map.frame().resolution;
  const double area = static_cast<double>(coverage.wanted.count()) * resolution * resolution;
  fmt::print("| {} | {:.0f} m2 | {} | {:.2f} % | {:.3f} | {:.2f} | {:.2f} |\n", map.name, area,
             coverage.strokes, 100 * coverage.covered_share, coverage.length / coverage.lower_bound,
             static_cast<double>(coverage.turns) / coverage.length, least);
}

}  // namespace

Measure add_coverage(CLI::App& app) {
  const auto rounds = std::make_shared<int>(3);
  add_rounds(app, *rounds);
  return [rounds] {
    stay_on_one_core();
    fmt::print(
        "| map | area | strokes | covered | path / bound | turns a metre | seconds |\n"
        "|---|---|---|---|---|---|---|\n");
    for (const NamedMap& map : maps_to_cover()) measure_one(map, *rounds);
    return 0;
  };
}

}  // namespace wend::bench
