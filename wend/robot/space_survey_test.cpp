#include "wend/robot/space_survey.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "wend/base/random.hpp"

namespace wend {
namespace {

/// The same, counted cell by cell in a FreeSpace.
SpaceSurvey counted(const GridMap& map, const FreeSpaceOptions& options) {
  const FreeSpace space = *make_free_space(map, options);
  SpaceSurvey survey;
  double sum = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (!space.passable({x, y})) continue;
      const double terrain = map.terrain({x, y});
      ++survey.passable;
      survey.near_obstacles += space.terrain({x, y}) > terrain ? 1 : 0;
      sum += terrain;
      least = std::min(least, terrain);
      survey.greatest_terrain = std::max(survey.greatest_terrain, terrain);
    }
  }
  const auto sizes = space.components().sizes(Adjacency::edges);
  survey.components = sizes.size();
  survey.largest_component = sizes.empty() ? 0 : sizes.front();
  if (survey.passable == 0) return survey;
  survey.least_terrain = least;
  survey.mean_terrain = sum / static_cast<double>(survey.passable);
  return survey;
}

GridMap random_map(Random& random) {
  constexpr CellState kStates[] = {CellState::occupied, CellState::unknown, CellState::free};
  Grid<CellState> cells(1 + static_cast<int>(random.below(130)),
                        1 + static_cast<int>(random.below(60)));
  Grid<double> terrain(cells.width(), cells.height(), 1);
  const double free = random.uniform();
  const bool rough = random.chance(0.5);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      cells[{x, y}] = random.chance(free) ? CellState::free : kStates[random.below(3)];
      if (rough) terrain[{x, y}] = 1 + static_cast<double>(random.below(9));
    }
  }
  return *make_grid_map(cells, Frame{0.5, {}, true, true}, terrain);
}

TEST(SpaceSurvey, CountsWhatAFreeSpaceHasInBandsOfAnyHeight) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const GridMap map = random_map(random);
    FreeSpaceOptions options;
    options.unknown = random.chance(0.5) ? UnknownPolicy::free : UnknownPolicy::blocked;
    if (random.chance(0.5)) options.outside = OutsidePolicy::free;
    if (random.chance(0.7)) options.footprint = Footprint::disc(3 * random.uniform());
    if (random.chance(0.5)) options.clearance_distance = 3 * random.uniform();
    if (random.chance(0.1)) options.footprint = Footprint::disc(1e6);
    const SpaceSurvey expected = counted(map, options);
    EXPECT_EQ(*survey(map, options), expected) << "seed " << seed;
    for (const int rows : {1, 7}) {
      EXPECT_EQ(*survey_in_bands(map, options, rows), expected) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace wend
