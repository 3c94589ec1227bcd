#include "wend/robot/space_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wend/map/connected_components.hpp"

namespace wend {
namespace {

constexpr double kCellsOfBand = 1 << 20;

/// Rows [begin, end) of a map.
GridMap rows_of(const GridMap& map, int begin, int end) {
  BitGrid occupied(map.width(), 0);
  BitGrid unknown(map.width(), 0);
  for (int y = begin; y < end; ++y) {
    std::ranges::copy(map.occupied().row_words(y), occupied.append_row().begin());
    std::ranges::copy(map.unknown().row_words(y), unknown.append_row().begin());
  }
  std::vector<double> terrain;
  for (int y = begin; y < end && !map.uniform_terrain(); ++y) {
    const auto row = map.terrain().row(y);
    terrain.insert(terrain.end(), row.begin(), row.end());
  }
  return *make_grid_map(std::move(occupied), std::move(unknown), map.frame(),
                        terrain.empty()
                            ? Grid<double>()
                            : Grid<double>(map.width(), end - begin, std::move(terrain)));
}

/// The number of rows over which an obstacle can still matter.
int reach_of(const GridMap& map, const FreeSpaceOptions& options) {
  const double cells = (options.footprint.circumscribed_radius() + options.clearance_distance) /
                       map.frame().resolution;
  return static_cast<int>(std::min<double>(std::ceil(cells) + 2, map.height()));
}

/// Does it only matter whether a cell is an obstacle?
bool is_point(const FreeSpaceOptions& options) {
  return options.footprint.is_point() &&
         (options.clearance_distance == 0 || options.clearance_cost == 0);
}

int rows_of_band(const GridMap& map) {
  return static_cast<int>(std::min<double>(kCellsOfBand / map.width(), map.height()));
}

class Surveyor {
 public:
  explicit Surveyor(const GridMap& map) : map_(map), components_(map.width()) {}

  /// Adds a row of the map for a point, which may be in every cell that is not an obstacle.
  void add_row_of_point(int y, UnknownPolicy unknown) {
    const auto occupied = map_.occupied().row_words(y);
    const auto unknowns = map_.unknown().row_words(y);
    BitGrid passable(map_.width(), 1);
    const auto words = passable.row_words(0);
    for (std::size_t i = 0; i < words.size(); ++i) {
      words[i] = ~(unknown == UnknownPolicy::free ? occupied[i] : occupied[i] | unknowns[i]);
    }
    words.front() &= ~std::uint64_t{1};  // the border
    const std::size_t end = static_cast<std::size_t>(map_.width()) + 1;
    words[end / 64] &= (std::uint64_t{1} << (end % 64)) - 1;
    std::fill(words.begin() + static_cast<std::ptrdiff_t>(end / 64) + 1, words.end(), 0);
    add_row(y, words);
  }

  /// Adds row `in_band` of the free space of a band, which is row y of the map.
  void add_row_of_band(int y, const FreeSpace& band, int in_band) {
    add_row(y, band.passable().row_words(in_band));
    if (band.uniform_terrain()) return;
    for (int x = 0; x < map_.width(); ++x) {
      const bool dearer = band.costs().steps({x, in_band}) > CostMap::rounded(map_.terrain({x, y}));
      if (dearer && band.passable({x, in_band})) ++result_.near_obstacles;
    }
  }

  SpaceSurvey finish() {
    result_.components = components_.count();
    result_.largest_component = components_.largest();
    if (result_.passable == 0) return result_;
    result_.least_terrain = map_.uniform_terrain() ? 1 : least_;
    result_.mean_terrain =
        map_.uniform_terrain() ? 1 : sum_ / static_cast<double>(result_.passable);
    return result_;
  }

 private:
  void add_row(int y, std::span<const std::uint64_t> words) {
    components_.add_row(words);
    for_each_run(words, map_.width(), [&](RowRun run) {
      result_.passable += static_cast<std::size_t>(run.end - run.begin);
      if (map_.uniform_terrain()) return;
      for (int x = run.begin; x < run.end; ++x) {
        const double terrain = map_.terrain({x, y});
        sum_ += terrain;
        least_ = std::min(least_, terrain);
        result_.greatest_terrain = std::max(result_.greatest_terrain, terrain);
      }
    });
  }

  const GridMap& map_;
  ComponentCounter components_;
  SpaceSurvey result_;
  double sum_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Expected<SpaceSurvey, Error> survey(const GridMap& map, const FreeSpaceOptions& options) {
  return survey_in_bands(map, options, rows_of_band(map));
}

double survey_bytes(const GridMap& map, const FreeSpaceOptions& options) {
  if (is_point(options)) return 0;
  const int reach = reach_of(map, options);
  const double rows =
      std::min<double>(std::max(rows_of_band(map), reach) + 2.0 * reach, map.height());
  const double map_bytes = 0.25 + (map.uniform_terrain() ? 0.0 : sizeof(double));
  return rows * map.width() * (map_bytes + free_space_bytes_per_cell(map, options));
}

Expected<SpaceSurvey, Error> survey_in_bands(const GridMap& map, const FreeSpaceOptions& options,
                                             int rows) {
  Surveyor surveyor(map);
  if (is_point(options)) {
    for (int y = 0; y < map.height(); ++y) surveyor.add_row_of_point(y, options.unknown);
    return surveyor.finish();
  }
  const int reach = reach_of(map, options);
  // At least as many rows as are read on each side, so that the work is at most three times the map.
  rows = std::max(rows, reach);
  for (int begin = 0; begin < map.height(); begin += rows) {
    const int end = std::min(begin + rows, map.height());
    const int above = std::max(begin - reach, 0);
    const int below = std::min(reach, map.height() - end);
    const auto band = make_free_space(rows_of(map, above, end + below), options);
    if (!band) return Unexpected<Error>(band.error());
    for (int y = begin; y < end; ++y) surveyor.add_row_of_band(y, *band, y - above);
  }
  return surveyor.finish();
}

}  // namespace wend
