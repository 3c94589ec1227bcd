// Tests the index on all pairs of cells of small boards, and saved, opened, shared and damaged indexes.

#include "wend/index/corner_hierarchy/corner_hierarchy.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

#include "wend/index/all_pairs_test.hpp"
#include "wend/index/file/index_bytes.hpp"

namespace wend {
namespace {

using test::brute_distances;
using test::expect_all_pairs;
using test::for_small_boards;
using test::kUnreached;
using test::passable_cells;

IndexBytes built(const BitGrid& bits, const ContractionEffort& effort = {}) {
  auto index = build_corner_hierarchy(bits, {}, effort);
  EXPECT_TRUE(index);
  return *std::move(index);
}

std::unique_ptr<IndexEngine> opened(const IndexBytes& index, const BitGrid& bits) {
  auto engine = open_corner_hierarchy(index, bits);
  EXPECT_TRUE(engine) << engine.error().message;
  return *std::move(engine);
}

TEST(CornerHierarchy, AnswersAllPairsOfSmallBoards) {
  std::uint64_t board = 0;
  for_small_boards(120, [&](const BitGrid& bits) {
    constexpr std::uint64_t kWork[] = {2000, 0, 30};  // all removed, none, some
    const auto engine = opened(built(bits, {.work_per_node = kWork[++board % 3]}), bits);
    expect_all_pairs(bits, *engine);
  });
}

BitGrid noise(std::uint64_t seed, int width, int height, double density) {
  Random random(seed);
  BitGrid bits(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) bits.set({x, y}, random.chance(density));
  }
  return bits;
}

TEST(CornerHierarchy, IsAnsweredFromByManyThreads) {
  const BitGrid bits = noise(11, 20, 14, 0.75);
  const IndexBytes index = built(bits);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] { expect_all_pairs(bits, *opened(index, bits)); });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(CornerHierarchy, IsTheSameEveryTime) {
  const BitGrid bits = noise(3, 70, 40, 0.7);
  const IndexBytes a = built(bits);
  const IndexBytes b = built(bits);
  EXPECT_TRUE(std::equal(a.bytes().begin(), a.bytes().end(), b.bytes().begin(), b.bytes().end()));
}

TEST(CornerHierarchy, RefusesTheIndexOfAnotherMapAndWhatIsCutOff) {
  const BitGrid bits = noise(5, 20, 20, 0.8);
  const IndexBytes index = built(bits);
  EXPECT_FALSE(open_corner_hierarchy(index, noise(6, 20, 20, 0.8)));
  for (std::size_t size = 0; size < index.size(); size += 61) {
    EXPECT_FALSE(open_corner_hierarchy(IndexBytes::copy_of(index.bytes().first(size)), bits));
  }
}

/// Changed files with a corrected checksum are rejected, or give some answer without reading out of
/// bounds.
TEST(CornerHierarchy, IsNotLedAstrayByForgedFiles) {
  const BitGrid bits = noise(9, 14, 14, 0.8);
  const IndexBytes index = built(bits);
  const auto cells = passable_cells(bits);
  int refused = 0;
  constexpr int kTries = 1500;
  for (std::uint64_t seed = 1; seed <= kTries; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<std::byte> file(index.bytes().begin(), index.bytes().end());
    for (std::uint64_t left = 1 + random.below(3); left > 0; --left) {
      const std::size_t at = sizeof(IndexHeader) + random.below(file.size() - sizeof(IndexHeader));
      file[at] = static_cast<std::byte>(random.chance(0.5) ? random.below(20) : random.below(256));
    }
    const std::uint64_t checksum = index_file::checksum_of(file);
    std::memcpy(file.data() + offsetof(IndexHeader, checksum), &checksum, sizeof checksum);
    auto engine = open_corner_hierarchy(IndexBytes::copy_of(file), bits);
    if (!engine) {
      ++refused;
      continue;
    }
    for (int i = 0; i < 20; ++i) {
      const Cell start = cells[random.below(cells.size())];
      const Cell goal = cells[random.below(cells.size())];
      if (start == goal || brute_distances(bits, start)[goal] == kUnreached) continue;
      const OctileSteps steps = (*engine)->find(start, goal);
      std::vector<Cell> path(steps.cells());
      (*engine)->write(path);
    }
  }
  EXPECT_GT(refused, kTries / 4);
}

TEST(CornerHierarchy, RefusesMapsWhosePathsMayBeTooLong) {
  BitGrid corridor(130'000, 1);
  for (int x = 0; x < corridor.width(); ++x) corridor.set({x, 0}, true);
  const auto index = build_corner_hierarchy(corridor, {});
  ASSERT_FALSE(index);
  EXPECT_EQ(index.error().status, Status::unsupported_map);
}

}  // namespace
}  // namespace wend
