#include "bench/suites/speed/speed_maps.hpp"

#include <array>
#include <utility>

#include "bench/scenario/scenario_queries.hpp"
#include "wend/generate/generators.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/map/load_map.hpp"

namespace wend::bench {
namespace {

Expected<SpeedMap, Error> load(const std::filesystem::path& scenario_file) {
  auto scenario = load_scenario(scenario_file);
  if (!scenario) return Unexpected<Error>(scenario.error());
  const auto map_file = scenario_map_path(*scenario);
  if (!map_file) return Unexpected<Error>(map_file.error());
  auto loaded = load_map(*map_file);
  if (!loaded) return Unexpected<Error>(loaded.error());
  const auto fits = check_map_size(*scenario, loaded->map.width(), loaded->map.height());
  if (!fits) return Unexpected<Error>(fits.error());
  if (scenario->queries.empty())
    return file_failure(scenario->file, 0, "the scenario has no queries");
  return SpeedMap{map_file->stem().string(), std::move(loaded->map), std::move(scenario->queries)};
}

}  // namespace

Expected<std::vector<SpeedMap>, Error> maps_of_folder(const std::filesystem::path& folder) {
  const auto files = scenarios_in(folder);
  if (!files) return Unexpected<Error>(files.error());
  std::vector<SpeedMap> maps;
  for (const std::filesystem::path& file : *files) {
    auto map = load(file);
    if (!map) return Unexpected<Error>(map.error());
    maps.push_back(*std::move(map));
  }
  return maps;
}

std::vector<SpeedMap> generated_maps() {
  constexpr std::uint64_t kSeed = 7;
  struct Kind {
    const char* generator;
    int size;
    OptionValues options;
  };
  const std::array kinds{Kind{"rooms", 512, {}}, Kind{"office", 512, {}}, Kind{"maze", 511, {}},
                         Kind{"random", 256, {{"density", "0.3"}}}};
  std::vector<SpeedMap> maps;
  for (const Kind& kind : kinds) {
    auto map = make_map(kind.generator, kind.size, kind.size, kSeed, kind.options);
    auto queries = scenario_queries(*make_free_space(*map), {}, {.seed = kSeed, .per_bucket = 2});
    maps.push_back({kind.generator, *std::move(map), *std::move(queries)});
  }
  return maps;
}

}  // namespace wend::bench
