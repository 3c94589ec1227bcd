#include "docs/planner_page/generated_families.hpp"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"

namespace wend::planner_page {
namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::uint64_t kQueries = 200;
constexpr std::uint64_t kQuickQueries = 3;
constexpr double kRobotRadius = 0.2;

/// A generator, the size of its map, and what comes of them.
struct Recipe {
  std::string title;
  std::string about;
  std::string kind;
  int width;
  int height;
  OptionValues options;
  FreeSpaceOptions robot = {};
  std::string moves = {};  // as "connectivity=4"
  bool is_maze = false;
};

std::vector<Recipe> recipes() {
  return {
      {"Open ground",
       "One cell in ten is blocked, at random.",
       "random",
       512,
       512,
       {{"density", "0.1"}}},
      {"Clutter",
       "A third of the cells is blocked, at random.",
       "random",
       512,
       512,
       {{"density", "0.33"}}},
      {"Rooms",
       "Rooms in rows and columns with doors in their walls.",
       "rooms",
       512,
       512,
       {{"room_size", "15"}}},
      {"Office",
       "Corridors, rooms and furniture, 0.1 m a cell, for a disc of 0.2 m.",
       "office",
       600,
       400,
       {},
       {.robot_radius = kRobotRadius}},
      {"Warehouse",
       "Racks in rows with aisles, 0.1 m a cell, for a disc of 0.2 m.",
       "warehouse",
       600,
       400,
       {},
       {.robot_radius = kRobotRadius}},
      {"Maze",
       "A perfect maze: one way between any two places. Corridors are one cell wide.",
       "maze",
       511,
       511,
       {},
       {},
       {},
       true},
      {"Wide maze",
       "A perfect maze whose corridors are seven cells wide.",
       "maze",
       513,
       513,
       {{"corridor_width", "7"}},
       {},
       {},
       true},
      {"Rooms, 4 neighbours",
       "The map of the rooms, without diagonal steps.",
       "rooms",
       512,
       512,
       {{"room_size", "15"}},
       {},
       "connectivity=4"},
      {"Rough ground",
       "Hills whose cells cost 2 to 9 times as much as the valleys, and rocks.",
       "rough",
       400,
       400,
       {}},
  };
}

/// The size of a map that is made in no time: a quarter, but large enough for an office.
int quick_size(int cells) {
  constexpr int kSmallest = 100;
  return std::max(cells / 4, kSmallest);
}

Family make(Recipe recipe, Effort effort) {
  if (effort == Effort::quick) {
    recipe.width = quick_size(recipe.width);
    recipe.height = quick_size(recipe.height);
  }
  const FreeSpace space(
      generated_map(recipe.kind, recipe.width, recipe.height, kSeed, recipe.options), recipe.robot);
  auto queries = random_pairs(space, effort == Effort::quick ? kQuickQueries : kQueries, kSeed);
  const std::string about =
      fmt::format("{} {} x {} cells, {} of them passable; {} random queries.", recipe.about,
                  space.width(), space.height(), space.passable().count(), queries.size());
  return {recipe.title,
          about,
          space,
          std::move(queries),
          those_that_take(space, configurations(recipe.moves)),
          recipe.is_maze};
}

/// Pairs of cells of different components.
std::vector<CellPair> separated_pairs(const FreeSpace& space, std::uint64_t count) {
  Random random(kSeed);
  const auto drawn = [&] {
    for (;;) {
      const Cell cell{random.between(0, space.width() - 1), random.between(0, space.height() - 1)};
      if (space.passable(cell)) return cell;
    }
  };
  std::vector<CellPair> pairs;
  while (pairs.size() < count) {
    const CellPair pair{drawn(), drawn()};
    if (!space.components().connected(pair.start, pair.goal, Adjacency::edges))
      pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

GridMap generated_map(std::string_view kind, int width, int height, std::uint64_t seed,
                      const OptionValues& options) {
  auto map = generators().find(kind)->make(width, height, seed, options);
  assert(map);
  return *std::move(map);
}

std::vector<Family> generated_families(Effort effort) {
  std::vector<Family> families;
  for (Recipe& recipe : recipes()) families.push_back(make(std::move(recipe), effort));
  return families;
}

Family small_family(Effort effort) {
  constexpr int kWidth = 61;
  constexpr int kHeight = 41;
  const FreeSpace space(generated_map("rooms", kWidth, kHeight, kSeed));
  auto queries = random_pairs(space, effort == Effort::quick ? kQuickQueries : kQueries, kSeed);
  const std::string about = fmt::format(
      "{} x {} cells: so small that a random walk gets somewhere. {} random queries, every planner "
      "with its default options.",
      kWidth, kHeight, queries.size());
  return {"Small rooms", about, space, std::move(queries), all_planners()};
}

Family unreachable_family(Effort effort) {
  constexpr int kSide = 512;
  const int side = effort == Effort::quick ? quick_size(kSide) : kSide;
  const FreeSpace space(generated_map("random", side, side, kSeed, {{"density", "0.45"}}));
  auto queries = separated_pairs(space, effort == Effort::quick ? kQuickQueries : kQueries);
  const std::string about = fmt::format(
      "{0} x {0} cells of which 45 % are blocked, at random, and {1} queries whose start and goal "
      "lie in regions that nothing joins.",
      side, queries.size());
  return {"No path", about, space, std::move(queries), all_planners()};
}

}  // namespace wend::planner_page
