#include "wend/index/hub_labels/hub_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "wend/index/all_pairs_test.hpp"
#include "wend/index/corner_graph.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/first_corners.hpp"

namespace wend {
namespace {

using test::brute_distances;
using test::expect_all_pairs;
using test::expect_path;
using test::for_small_boards;
using test::kUnreached;
using test::passable_cells;
using ::testing::HasSubstr;

BitGrid random_board(std::uint64_t seed, int width, int height, double density) {
  Random random(seed);
  BitGrid bits(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) bits.set({x, y}, random.chance(density));
  }
  return bits;
}

IndexBytes built_labels(const BitGrid& bits, const IndexBuilding& building = {}) {
  auto index = build_hub_index(bits, building);
  if (!index) ADD_FAILURE() << index.error().message;
  return index ? *std::move(index) : IndexBytes();
}

std::unique_ptr<IndexEngine> opened_labels(const IndexBytes& index, const BitGrid& bits) {
  auto engine = open_hub_index(index, bits);
  if (!engine) ADD_FAILURE() << engine.error().message;
  return engine ? *std::move(engine) : nullptr;
}

std::string opening_error(const IndexBytes& index, const BitGrid& bits) {
  const auto engine = open_hub_index(index, bits);
  return engine ? "" : engine.error().message;
}

TEST(HubIndex, AnswersAllPairsOfSmallBoardsLikeDijkstra) {
  for_small_boards(250, [](const BitGrid& bits) {
    if (!testing::Test::HasFatalFailure())
      expect_all_pairs(bits, *opened_labels(built_labels(bits), bits));
  });
}

TEST(HubIndex, AnswersAllPairsOfTensOfThousandsOfSmallBoardsInALongRun) {
  for_small_boards(40000, [](const BitGrid& bits) {
    if (!testing::Test::HasFatalFailure())
      expect_all_pairs(bits, *opened_labels(built_labels(bits), bits));
  });
}

TEST(HubIndex, AnswersThreadsThatShareIt) {
  const BitGrid bits = random_board(5, 30, 14, 0.7);
  const IndexBytes index = built_labels(bits);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] { expect_all_pairs(bits, *opened_labels(index, bits)); });
  }
  for (std::thread& thread : threads) thread.join();
}

/// Runs tasks in reverse order, and reports several workers.
class BackwardWorkers final : public Workers {
 public:
  unsigned count() const override { return 3; }
  void run(std::size_t tasks, const Action& action) override {
    while (tasks-- > 0) action(tasks, static_cast<unsigned>(tasks % 3));
  }
};

TEST(HubIndex, IsTheSameWhoeverBuildsIt) {
  const BitGrid bits = random_board(6, 90, 60, 0.75);
  BackwardWorkers backwards;
  const IndexBytes one = built_labels(bits);
  const IndexBytes other = built_labels(bits, {.workers = &backwards, .progress = {}});
  ASSERT_EQ(one.size(), other.size());
  EXPECT_EQ(std::memcmp(one.bytes().data(), other.bytes().data(), one.size()), 0);
}

TEST(HubIndex, TellsHowFarItIs) {
  std::vector<double> shares;
  built_labels(random_board(7, 60, 60, 0.7),
               {.progress = [&](double share) { shares.push_back(share); }});
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  EXPECT_GT(shares.size(), 5U);
}

TEST(HubIndex, StopsBuildingWhenToldTo) {
  for (const double when : {0.0, 0.5, 0.9}) {
    std::atomic<bool> cancel = false;
    const IndexBuilding building{.progress = [&](double share) { cancel = share >= when; },
                                 .cancel = &cancel};
    const auto index = build_hub_index(random_board(8, 60, 60, 0.7), building);
    ASSERT_FALSE(index);
    EXPECT_EQ(index.error().status, Status::cancelled);
  }
}

TEST(HubIndex, MakesNoPartOnceItIsToldToStop) {
  const BitGrid bits = random_board(9, 60, 60, 0.7);
  const std::atomic<bool> cancel = true;
  const IndexBuilding building{.cancel = &cancel};
  const CornerGraph graph(Corners(bits), building);
  EXPECT_GT(graph.size(), 0U);
  EXPECT_EQ(graph.edge_count(), 0U);
  const AllFirstCorners first(graph.corners(), building);
  for (const Cell cell : every_cell(bits)) EXPECT_TRUE(first.of(cell).empty());
}

TEST(HubIndex, RefusesBoardsThatAreTooWide) {
  const auto index = build_hub_index(BitGrid(40000, 1), {});
  ASSERT_FALSE(index);
  EXPECT_EQ(index.error().status, Status::unsupported_map);
  EXPECT_THAT(index.error().message, HasSubstr("32768"));
}

/// One corridor that runs to and fro, row by row.
BitGrid serpentine(int width, int rows) {
  BitGrid bits(width, 2 * rows - 1);
  for (int row = 0; row < rows; ++row) {
    for (int x = 0; x < width; ++x) bits.set({x, 2 * row}, true);
    if (row + 1 < rows) bits.set({row % 2 == 0 ? width - 1 : 0, 2 * row + 1}, true);
  }
  return bits;
}

TEST(HubIndex, AnswersOnAWindingWayAndRefusesWhatOutgrowsItsNumbers) {
  const BitGrid bits = serpentine(300, 70);
  const auto engine = opened_labels(built_labels(bits), bits);
  const OctileSteps steps = engine->find({0, 0}, {0, 138});
  EXPECT_EQ(steps, (OctileSteps{70 * 299 + 69 * 2, 0}));
  std::vector<Cell> path(steps.cells());
  engine->write(path);
  expect_path(bits, path, steps, {0, 0}, {0, 138});

  const auto longer = build_hub_index(serpentine(500, 300), {});
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().status, Status::unsupported_map);
  EXPECT_THAT(longer.error().message, HasSubstr("too long"));
}

TEST(HubIndex, IsOfOneMap) {
  const BitGrid bits = random_board(9, 30, 30, 0.7);
  BitGrid other = bits;
  other.set({3, 3}, !other[{3, 3}]);
  EXPECT_NE(opening_error(built_labels(bits), other), "");
  EXPECT_EQ(opening_error(built_labels(bits), bits), "");
}

std::vector<std::byte> copied(const IndexBytes& index) {
  return {index.bytes().begin(), index.bytes().end()};
}

TEST(HubIndex, RefusesDamagedFiles) {
  const BitGrid bits = random_board(10, 12, 9, 0.6);
  const IndexBytes index = built_labels(bits);
  for (std::size_t i = 0; i < index.size(); ++i) {
    std::vector<std::byte> damaged = copied(index);
    damaged[i] ^= std::byte{static_cast<unsigned char>(1U << (i % 8))};
    ASSERT_NE(opening_error(IndexBytes::copy_of(damaged), bits), "") << "byte " << i;
  }
  for (std::size_t size = 0; size < index.size(); size += 7) {
    const auto cut = index.bytes().first(size);
    ASSERT_NE(opening_error(IndexBytes::copy_of(cut), bits), "") << size << " bytes";
  }
}

/// Sets the right checksum for arbitrary bytes.
void forge(std::vector<std::byte>& file) {
  const std::uint64_t checksum = index_file::checksum_of(file);
  std::memcpy(file.data() + offsetof(IndexHeader, checksum), &checksum, sizeof checksum);
}

// A forged index may give any answer, but must not read or write out of bounds.
TEST(HubIndex, NeverLeavesAForgedFile) {
  const BitGrid bits = random_board(11, 14, 10, 0.65);
  const std::vector<Cell> cells = passable_cells(bits);
  const IndexBytes index = built_labels(bits);
  const Grid<std::uint64_t> reached = brute_distances(bits, cells.front());
  std::vector<Cell> path;
  int passed = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    Random random(seed);
    std::vector<std::byte> forged = copied(index);
    for (int i = random.between(1, 3); i > 0; --i) {
      const std::size_t at =
          sizeof(IndexHeader) + random.below(forged.size() - sizeof(IndexHeader));
      forged[at] = static_cast<std::byte>(random.chance(0.3) ? 0xFF : random.below(256));
    }
    forge(forged);
    const auto engine = open_hub_index(IndexBytes::copy_of(forged), bits);
    if (!engine) continue;
    ++passed;
    for (const Cell to : cells) {
      if (to == cells.front() || reached[to] == kUnreached) continue;
      const OctileSteps steps = (*engine)->find(cells.front(), to);
      if (steps.cells() < 2 || steps.cells() > 100000) continue;
      path.assign(steps.cells(), {});
      (*engine)->write(path);
    }
  }
  EXPECT_GT(passed, 100) << "too few to say anything";
}

}  // namespace
}  // namespace wend
