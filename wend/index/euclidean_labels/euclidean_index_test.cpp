// The Euclidean label index against an independent search on all lines between corners, in whole numbers.

#include "wend/index/euclidean_labels/euclidean_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/visibility.hpp"
#include "tests/testing/random_cells.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

constexpr double kRelative = 1e-9;

IndexBytes built(const BitGrid& free) {
  auto index = build_euclidean_index(free, {});
  if (!index) ADD_FAILURE() << index.error().message;
  return index ? *std::move(index) : IndexBytes();
}

std::unique_ptr<EuclideanEngine> opened(const IndexBytes& index, const BitGrid& free) {
  auto engine = EuclideanEngine::open(index, free);
  if (!engine) ADD_FAILURE() << engine.error().message;
  return engine ? *std::move(engine) : nullptr;
}

std::vector<Point> waypoints_of(const EuclideanEngine& engine, Cell start, Cell goal) {
  std::vector<Point> points{centre_of(start)};
  for (const std::uint32_t id : engine.corners()) {
    const TautCorner& corner = engine.portals().corners()[id];
    points.push_back({static_cast<double>(corner.x), static_cast<double>(corner.y)});
  }
  points.push_back(centre_of(goal));
  return points;
}

double length_of(const std::vector<Point>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

/// What is wrong with an answer; empty if nothing is.
std::string fault_of(EuclideanEngine& engine, const test::Visibility& visibility, Cell start,
                     Cell goal, double shortest) {
  if (!engine.find(start, goal)) return std::isfinite(shortest) ? "no path" : "";
  const std::vector<Point> points = waypoints_of(engine, start, goal);
  const double length = length_of(points);
  if (!(std::abs(length - shortest) <= kRelative * (1 + shortest))) {
    return "length " + std::to_string(length) + ", expected " + std::to_string(shortest);
  }
  if (std::abs(engine.length() - length) > kRelative) return "it says another length";
  return start == goal ? "" : visibility.fault(points, start, centre_of(goal));
}

/// From all cells, or from some of them, to all. The number of queries.
int expect_shortest_labels(const BitGrid& free, int starts, std::uint64_t seed) {
  test::Visibility visibility(
      free.width(), free.height(), [&](Cell cell) { return free[cell]; }, false);
  visibility.join_corners();
  const auto engine = opened(built(free), free);
  if (engine == nullptr) return 0;
  Random random(seed);
  int queries = 0;
  const auto from = [&](Cell start) {
    if (!free[start]) return;
    const std::vector<double> lengths = visibility.lengths_from(start);
    for (const Cell goal : every_cell(free)) {
      if (!free[goal]) continue;
      ++queries;
      const double shortest = lengths[visibility.number(goal.x, goal.y)];
      const std::string fault = fault_of(*engine, visibility, start, goal, shortest);
      if (fault.empty()) continue;
      ADD_FAILURE() << "from " << start.x << ',' << start.y << " to " << goal.x << ',' << goal.y
                    << ": " << fault << ", seed " << seed;
      return;
    }
  };
  if (starts == 0) {
    for (const Cell start : every_cell(free)) from(start);
  } else {
    for (int i = 0; i < starts; ++i) {
      const Cell start = test::random_cell(random, free.width(), free.height());
      from(start);
    }
  }
  return queries;
}

int expect_shortest_labels_on_maps(std::uint64_t first, std::uint64_t count) {
  int queries = 0;
  for (std::uint64_t seed = first; seed < first + count && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const BitGrid free = test::random_cells(random, seed % 10 == 0 ? 24 : 8, 0.4);
    queries += expect_shortest_labels(free, 3, seed);
  }
  return queries;
}

TEST(EuclideanIndex, IsShortestOnRandomMaps) {
  EXPECT_GT(expect_shortest_labels_on_maps(1, test::share_of(3000U)), 15'000);
}

TEST(EuclideanIndex, IsShortestOnAHundredThousandRandomMapsLongRun) {
  EXPECT_GT(expect_shortest_labels_on_maps(10'000, 100'000), 1'000'000);
}

BitGrid floor_of_bits(int width, int height, std::uint64_t bits) {
  BitGrid cells(width, height);
  for (int i = 0; i < width * height; ++i) {
    cells.set({i % width, i / width}, ((bits >> static_cast<unsigned>(i)) & 1U) != 0);
  }
  return cells;
}

TEST(EuclideanIndex, IsShortestOnAllMapsOfNineCells) {
  for (std::uint64_t bits = 0; bits < 512 && !HasFailure(); ++bits) {
    expect_shortest_labels(floor_of_bits(3, 3, bits), 0, bits);
  }
}

TEST(EuclideanIndex, IsShortestOnAllMapsOfSixteenCellsLongRun) {
  for (std::uint64_t bits = 0; bits < 65536 && !HasFailure(); ++bits) {
    expect_shortest_labels(floor_of_bits(4, 4, bits), 0, bits);
  }
}

TEST(EuclideanIndex, NamesItsLimitOfCorners) {
  BitGrid free(420, 420);  // posts, each with four corners
  for (const Cell cell : every_cell(free)) free.set(cell, cell.x % 3 != 1 || cell.y % 3 != 1);
  const auto index = build_euclidean_index(free, {});
  ASSERT_FALSE(index);
  EXPECT_EQ(index.error().status, Status::unsupported_map);
  EXPECT_THAT(index.error().message, HasSubstr("78400 corners"));
  EXPECT_THAT(index.error().message, HasSubstr("at most 65536"));
}

}  // namespace
}  // namespace wend
