#include "docs/planner_page/benchmark_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "wend/generate/generators.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/planner/planners.hpp"

namespace wend::planner_page {
namespace {

constexpr std::uint64_t kMapSeed = 7;
constexpr std::size_t kMapQueries = 200;
constexpr std::size_t kQuickMapQueries = 3;
constexpr std::array<std::string_view, 2> kVariants{"astar:weight=2", "astar:heuristic=euclidean"};

/// A generated map.
struct Recipe {
  std::string title;
  std::string about;
  std::string_view kind;
  int width;
  int height;
  OptionValues options;
  FreeSpaceOptions robot = {};
  std::string planner_option = {};  // "connectivity=4"
};

std::vector<Recipe> recipes() {
  const FreeSpaceOptions point;
  const FreeSpaceOptions disc{.footprint = Footprint::disc(0.2)};
  const OptionValues none;
  const OptionValues open{{"density", "0.1"}};
  const OptionValues clutter{{"density", "0.33"}};
  const OptionValues rooms{{"room_size", "15"}};
  const OptionValues wide{{"corridor_width", "7"}};
  return {
      Recipe{"Open ground", "10 % of the cells blocked at random", "random", 512, 512, open},
      Recipe{"Clutter", "33 % of the cells blocked at random", "random", 512, 512, clutter},
      Recipe{"Rooms", "rooms in rows and columns, joined by doors", "rooms", 512, 512, rooms},
      Recipe{"Office", "corridors, rooms and furniture; 0.1 m a cell, a disc of 0.2 m", "office",
             600, 400, none, disc},
      Recipe{"Warehouse", "racks and aisles; 0.1 m a cell, a disc of 0.2 m", "warehouse", 600, 400,
             none, disc},
      Recipe{"Maze", "a perfect maze, corridors one cell wide", "maze", 511, 511, none},
      Recipe{"Wide maze", "a perfect maze, corridors seven cells wide", "maze", 513, 513, wide},
      Recipe{"Rooms, 4 neighbours", "*Rooms* without diagonal steps", "rooms", 512, 512, rooms,
             point, "connectivity=4"},
      Recipe{"Rough ground", "rocks, and hills whose cells cost 2 to 9 times as much", "rough", 400,
             400, none},
  };
}

/// A MovingAI map.
struct Benchmark {
  std::string_view file;
  std::string_view title;
  std::string_view about;
};

constexpr std::string_view kFolder = "nine";

constexpr std::array kBenchmarks{
    Benchmark{"den520d", "Game map", "halls and caves of a game level (den520d)"},
    Benchmark{"Berlin_0_1024", "City", "streets of a city (Berlin_0_1024)"},
};

/// The size of a map that is made in no time: a quarter, but large enough for an office.
int quick_size(int cells) {
  constexpr int kSmallest = 100;
  return std::max(cells / 4, kSmallest);
}

PlannerSpec planner_spec(const std::string& text) {
  auto specs = parse_planner_specs(text);
  assert(specs && specs->size() == 1);
  return specs->front();
}

/// Does it keep the answer of a query that is repeated? Then its time says nothing.
bool keeps_answers(const PlannerInfo& planner) {
  return planner.capabilities.resumes && planner.preprocessing == Preprocessing::none;
}

/// Every complete grid planner without an index whose paths are steps and that does not keep its answers, and variants
/// of astar, each with `option` besides: those that have this option and can plan on the map.
std::vector<Configuration> planners_for(const FreeSpace& space, const std::string& option) {
  std::vector<std::string> names;
  for (const PlannerInfo& planner : planners()) {
    if (!planner.capabilities.headings && !planner.capabilities.any_angle &&
        !planner.index_support && planner.guarantee != Guarantee::none && !keeps_answers(planner)) {
      names.push_back(planner.name);
    }
  }
  names.insert(names.end(), kVariants.begin(), kVariants.end());

  std::vector<Configuration> configurations;
  for (const std::string& name : names) {
    const char separator = name.find(':') == std::string::npos ? ':' : ',';
    const PlannerSpec spec =
        planner_spec(option.empty() ? name : fmt::format("{}{}{}", name, separator, option));
    if (planners().find(spec.name)->make(space, spec.options)) {
      configurations.push_back({name, spec});
    }
  }
  return configurations;
}

BenchmarkMap generated(Recipe recipe, Effort effort) {
  const bool quick = effort == Effort::quick;
  if (quick) {
    recipe.width = quick_size(recipe.width);
    recipe.height = quick_size(recipe.height);
  }
  const FreeSpace space = *make_free_space(
      generated_map(recipe.kind, recipe.width, recipe.height, kMapSeed, recipe.options),
      recipe.robot);
  return {recipe.title, recipe.about, space,
          random_pairs(space, quick ? kQuickMapQueries : kMapQueries, kMapSeed),
          planners_for(space, recipe.planner_option)};
}

Expected<BenchmarkMap, Error> loaded(const Benchmark& benchmark,
                                     const std::filesystem::path& folder) {
  const auto file = folder / kFolder / (std::string(benchmark.file) + ".map");
  const auto loaded = load_map(file);
  if (!loaded) return Unexpected<Error>(loaded.error());
  const auto scenario = load_scenario(file.string() + ".scen");
  if (!scenario) return Unexpected<Error>(scenario.error());
  const auto fits = check_map_size(*scenario, loaded->map.width(), loaded->map.height());
  if (!fits) return Unexpected<Error>(fits.error());
  const FreeSpace space = *make_free_space(loaded->map);
  std::vector<CellPair> queries;
  for (const ScenarioQuery& query : evenly_sampled(scenario->queries, kMapQueries)) {
    queries.push_back({query.start, query.goal});
  }
  return BenchmarkMap{std::string(benchmark.title), std::string(benchmark.about), space,
                      std::move(queries), planners_for(space, {})};
}

}  // namespace

GridMap generated_map(std::string_view kind, int width, int height, std::uint64_t seed,
                      const OptionValues& options) {
  auto map = make_map(kind, width, height, seed, options);
  assert(map);
  return *std::move(map);
}

std::vector<BenchmarkMap> generated_maps(Effort effort) {
  std::vector<BenchmarkMap> maps;
  for (Recipe& recipe : recipes()) maps.push_back(generated(std::move(recipe), effort));
  return maps;
}

Expected<std::vector<BenchmarkMap>, Error> movingai_maps(const std::filesystem::path& folder) {
  std::vector<BenchmarkMap> maps;
  for (const Benchmark& benchmark : kBenchmarks) {
    auto map = loaded(benchmark, folder);
    if (!map) return Unexpected<Error>(map.error());
    maps.push_back(*std::move(map));
  }
  return maps;
}

}  // namespace wend::planner_page
