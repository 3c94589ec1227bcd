// What single operations cost on large maps, with Google Benchmark. Ratios between
// planners are the business of the suite speed; these are the guarantees about one operation.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/suites/suite.hpp"
#include "wend/base/random.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/save_map.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

constexpr int kSide = 4096;

GridMap free_map(int side) { return *make_grid_map(Grid<CellState>(side, side, CellState::free)); }

GridMap noisy_map(int side) {
  Random random(1);
  Grid<CellState> cells(side, side, CellState::free);
  for (int y = 0; y < side; ++y) {
    for (CellState& state : cells.row(y)) {
      if (random.chance(0.01)) state = CellState::occupied;
    }
  }
  return *make_grid_map(cells);
}

/// A path of 20 cells: its cost must not depend on the map's size.
void short_query(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const auto planner = make_planner("astar", *make_free_space(free_map(side)));
  const Query query = Query::between({side / 2, side / 2}, {side / 2 + 19, side / 2 + 7});
  Plan plan;
  for (auto _ : state) {
    benchmark::DoNotOptimize((*planner)->plan(query, plan));
  }
}
BENCHMARK(short_query)->Arg(64)->Arg(kSide)->Unit(benchmark::kMicrosecond);

/// A goal that cannot be reached is known from the connected components.
void unreachable_query(benchmark::State& state) {
  Grid<CellState> cells(kSide, kSide, CellState::free);
  for (int y = 0; y < kSide; ++y) cells[{kSide / 2, y}] = CellState::occupied;
  const auto planner = make_planner("astar", *make_free_space(*make_grid_map(cells)));
  const Query query = Query::between({0, 0}, {kSide - 1, kSide - 1});
  Plan plan;
  for (auto _ : state) {
    benchmark::DoNotOptimize((*planner)->plan(query, plan));
  }
}
BENCHMARK(unreachable_query)->Unit(benchmark::kMicrosecond);

/// From a PNG file to the free space of a robot with a radius of 3 cells.
void load_png_and_free_space(benchmark::State& state) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "wend-micro-4096.png";
  if (const auto saved = save_map(noisy_map(kSide), file); !saved) {
    state.SkipWithError(saved.error().message.c_str());
    return;
  }
  for (auto _ : state) {
    const auto loaded = load_map(file);
    const FreeSpace space = *make_free_space(loaded->map, {.footprint = Footprint::disc(3)});
    benchmark::DoNotOptimize(space.passable({0, 0}));
  }
  std::filesystem::remove(file);
}
BENCHMARK(load_png_and_free_space)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wend

namespace wend::bench {

Measure add_operations(CLI::App& app) {
  app.allow_extras();
  app.set_help_flag();  // --help is Google Benchmark's
  return [&app] {
    std::vector<std::string> flags = app.remaining();
    std::string name = app.get_name();
    std::vector<char*> arguments{name.data()};
    for (std::string& flag : flags) arguments.push_back(flag.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  };
}

}  // namespace wend::bench
