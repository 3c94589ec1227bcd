// A written file can be read back; a truncated, damaged or foreign file is rejected.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/index/file/index_sections.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

BitGrid random_cells(std::uint64_t seed, int width = 70, int height = 9) {
  Random random(seed);
  BitGrid cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) cells.set({x, y}, random.chance(0.5));
  }
  return cells;
}

IndexBytes small_index(const BitGrid& cells) {
  IndexWriter writer("tester", 3, cells);
  const std::array<std::uint32_t, 3> words{7, 8, 9};
  const std::array<std::uint8_t, 5> bytes{1, 2, 3, 4, 5};
  writer.add(std::span<const std::uint32_t>(words));
  writer.add(std::span<const std::uint8_t>(bytes));
  writer.add(std::span<const std::uint32_t>());
  return writer.finish();
}

std::string error_of(const IndexBytes& index, const BitGrid& cells, const char* planner = "tester",
                     std::uint32_t version = 3) {
  const auto reader = IndexReader::open(index, planner, version, cells);
  return reader ? "" : reader.error().message;
}

TEST(IndexFile, GivesBackWhatWasWritten) {
  const BitGrid cells = random_cells(1);
  const auto reader = IndexReader::open(small_index(cells), "tester", 3, cells);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(reader->sections(), 3U);
  EXPECT_THAT(*reader->section<std::uint32_t>(0), ElementsAre(7, 8, 9));
  EXPECT_THAT(*reader->section<std::uint8_t>(1), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(*reader->section<std::uint32_t>(2), ElementsAre());
  EXPECT_FALSE(reader->section<std::uint32_t>(3)) << "there is no such section";
  EXPECT_FALSE(reader->section<std::uint32_t>(1)) << "five bytes are no whole words";
}

TEST(IndexFile, SectionsBeginAtCacheLines) {
  const BitGrid cells = random_cells(2);
  const auto reader = IndexReader::open(small_index(cells), "tester", 3, cells);
  ASSERT_TRUE(reader);
  for (std::size_t i = 0; i < reader->sections(); ++i) {
    const auto address = reinterpret_cast<std::uintptr_t>(reader->section<std::uint8_t>(i)->data());
    EXPECT_EQ(address % IndexBytes::kAlignment, 0U);
  }
}

TEST(IndexFile, OfAnotherPlannerVersionOrMapIsRefused) {
  const BitGrid cells = random_cells(3);
  const IndexBytes index = small_index(cells);
  EXPECT_EQ(error_of(index, cells), "");
  EXPECT_THAT(error_of(index, cells, "other"), HasSubstr("for the planner tester, not for other"));
  EXPECT_THAT(error_of(index, cells, "tester", 4), HasSubstr("of version 3"));
  EXPECT_THAT(error_of(index, random_cells(3, 71)), HasSubstr("70 x 9 cells, this one has 71 x 9"));
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      BitGrid other = cells;
      other.set({x, y}, !cells[{x, y}]);
      EXPECT_THAT(error_of(index, other), HasSubstr("another map")) << x << ',' << y;
    }
  }
}

TEST(IndexFile, CutOffAnywhereIsRefused) {
  const BitGrid cells = random_cells(4);
  const IndexBytes index = small_index(cells);
  for (std::size_t size = 0; size < index.size(); ++size) {
    EXPECT_NE(error_of(IndexBytes::copy_of(index.bytes().first(size)), cells), "") << size;
  }
}

TEST(IndexFile, WithAnyBitTurnedIsRefused) {
  const BitGrid cells = random_cells(5);
  const IndexBytes index = small_index(cells);
  std::vector<std::byte> bytes(index.bytes().begin(), index.bytes().end());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_NE(error_of(IndexBytes::copy_of(bytes), cells), "") << "bit " << bit;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
  }
}

TEST(IndexFile, WithSectionsOutsideIsRefusedThoughItsChecksumIsRight) {
  const BitGrid cells = random_cells(6);
  const IndexBytes index = small_index(cells);
  IndexHeader header;
  std::memcpy(&header, index.bytes().data(), sizeof header);
  const auto forged = [&](IndexSection section) {
    std::vector<std::byte> bytes(index.bytes().begin(), index.bytes().end());
    header.table[0] = section;
    std::memcpy(bytes.data(), &header, sizeof header);
    header.checksum = index_file::checksum_of(bytes);
    std::memcpy(bytes.data(), &header, sizeof header);
    return error_of(IndexBytes::copy_of(bytes), cells);
  };
  const IndexSection right = header.table[0];
  EXPECT_EQ(forged(right), "");
  EXPECT_THAT(forged({right.offset + 1, right.bytes}), HasSubstr("section 0"));
  EXPECT_THAT(forged({0, right.bytes}), HasSubstr("section 0"));
  EXPECT_THAT(forged({right.offset, index.size()}), HasSubstr("section 0"));
  EXPECT_THAT(forged({~std::uint64_t{63}, 128}), HasSubstr("section 0"));
}

}  // namespace
}  // namespace wend
