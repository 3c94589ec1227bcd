#include "docs/planner_page/data_families.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "wend/io/map/load_map.hpp"
#include "wend/io/query/scenario.hpp"

namespace wend::planner_page {
namespace {

struct Course {
  std::string_view map;
  std::string_view title;
  std::string_view about;
  bool is_maze = false;
};

constexpr std::string_view kFolder = "nine";
constexpr std::size_t kSample = 200;

constexpr std::array kCourses{
    Course{"den520d", "Game map", "A level of a game: halls and caves (den520d)."},
    Course{"orz700d", "Winding game map", "A level of a game: long and winding (orz700d)."},
    Course{"Berlin_0_1024", "City", "A city seen from above (Berlin_0_1024)."},
    Course{"64room_000", "Large rooms", "Rooms of 64 x 64 cells with narrow doors (64room_000)."},
    Course{"maze512-1-0", "Benchmark maze", "A maze with corridors of one cell (maze512-1-0).",
           true},
    Course{"random512-35-0", "Benchmark clutter",
           "35 % of the cells are blocked, at random (random512-35-0)."},
};

Expected<Family, IoError> load(const Course& course, const std::filesystem::path& folder) {
  const auto map_file = folder / kFolder / (std::string(course.map) + ".map");
  const auto loaded = load_map(map_file);
  if (!loaded) return Unexpected<IoError>(loaded.error());
  const auto scenario = load_scenario(map_file.string() + ".scen");
  if (!scenario) return Unexpected<IoError>(scenario.error());
  const auto fits = check_map_size(*scenario, loaded->map.width(), loaded->map.height());
  if (!fits) return Unexpected<IoError>(fits.error());
  const FreeSpace space(loaded->map);
  std::vector<CellPair> queries;
  for (const ScenarioQuery& query : evenly_sampled(scenario->queries, kSample)) {
    queries.push_back({query.start, query.goal});
  }
  std::string about = fmt::format(
      "{} {} x {} cells, {} of them passable; {} queries of its scenario, evenly spread.",
      course.about, space.width(), space.height(), space.passable().count(), queries.size());
  return Family{std::string(course.title), std::move(about), space,
                std::move(queries),        configurations(), course.is_maze};
}

}  // namespace

Expected<std::vector<Family>, IoError> data_families(const std::filesystem::path& folder) {
  std::vector<Family> families;
  for (const Course& course : kCourses) {
    auto family = load(course, folder);
    if (!family) return Unexpected<IoError>(family.error());
    families.push_back(*std::move(family));
  }
  return families;
}

}  // namespace wend::planner_page
