// The file of a Euclidean label index: what is damaged or foreign is refused, and what is forged stays within itself.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/index/euclidean_labels/euclidean_index.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

BitGrid half_open_floor(std::uint64_t seed, int width, int height) {
  Random random(seed);
  BitGrid cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_free = random.chance(0.7);
      cells.set({x, y}, is_free);
    }
  }
  return cells;
}

std::vector<Cell> free_cells(const BitGrid& free) {
  std::vector<Cell> cells;
  for (const Cell cell : every_cell(free)) {
    if (free[cell]) cells.push_back(cell);
  }
  return cells;
}

std::vector<std::byte> bytes_of_index(const BitGrid& free) {
  const auto index = build_euclidean_index(free, {});
  if (!index) return {};
  return {index->bytes().begin(), index->bytes().end()};
}

std::string refusal(std::span<const std::byte> bytes, const BitGrid& free) {
  const auto engine = EuclideanEngine::open(IndexBytes::copy_of(bytes), free);
  if (engine) return "";
  EXPECT_EQ(engine.error().status, Status::index_mismatch);
  return engine.error().message;
}

/// With the right checksum.
std::string refusal_of_forged(std::vector<std::byte>& bytes, const BitGrid& free) {
  const std::uint64_t checksum = index_file::checksum_of(bytes);
  std::memcpy(bytes.data() + offsetof(IndexHeader, checksum), &checksum, sizeof checksum);
  return refusal(bytes, free);
}

TEST(EuclideanIndexFile, IsOfOneMapAndTheSameInEveryRun) {
  const BitGrid free = half_open_floor(1, 30, 30);
  const std::vector<std::byte> bytes = bytes_of_index(free);
  ASSERT_FALSE(bytes.empty());
  EXPECT_EQ(bytes, bytes_of_index(free));
  EXPECT_EQ(refusal(bytes, free), "");
  BitGrid other = free;
  other.set({3, 3}, !other[{3, 3}]);
  EXPECT_THAT(refusal(bytes, other), HasSubstr("another map"));
}

TEST(EuclideanIndexFile, IsRefusedWhereItIsDamagedOrCutOff) {
  const BitGrid free = half_open_floor(2, 12, 9);
  const std::vector<std::byte> bytes = bytes_of_index(free);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::byte> damaged = bytes;
    damaged[i] ^= std::byte{static_cast<unsigned char>(1U << (i % 8))};
    ASSERT_NE(refusal(damaged, free), "") << "byte " << i;
  }
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    ASSERT_NE(refusal(std::span(bytes).first(size), free), "") << size << " bytes";
  }
}

/// Where an element of a section lies in the file.
template <class T>
std::size_t place_in_file(std::span<const std::byte> bytes, TautLabelSections::Section section,
                          std::size_t number) {
  IndexHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  return header.table[static_cast<std::size_t>(section)].offset + number * sizeof(T);
}

/// What is said of a file of which one element was changed.
template <class T, class Change>
std::string refusal_of_changed(std::vector<std::byte> bytes, const BitGrid& free,
                               TautLabelSections::Section section, std::size_t number,
                               Change&& change) {
  const std::size_t at = place_in_file<T>(bytes, section, number);
  T element;
  std::memcpy(&element, bytes.data() + at, sizeof element);
  change(element);
  std::memcpy(bytes.data() + at, &element, sizeof element);
  return refusal_of_forged(bytes, free);
}

TEST(EuclideanIndexFile, IsRefusedWhereAReferenceLeadsOutOfIt) {
  using Section = TautLabelSections::Section;
  const BitGrid free = half_open_floor(3, 24, 17);
  const std::vector<std::byte> bytes = bytes_of_index(free);
  const auto changed = [&]<class T>(Section section, std::size_t number, T&&, auto change) {
    return refusal_of_changed<std::remove_cvref_t<T>>(bytes, free, section, number, change);
  };
  using Entry = TautLabelEntry;
  EXPECT_EQ(changed(Section::corners, 0, std::uint32_t{}, [](auto&) {}), "");
  const auto set_far = [](std::uint32_t& number) { number = 1'000'000; };
  const auto set_zero = [](std::uint32_t& number) { number = 0; };
  EXPECT_THAT(changed(Section::corners, 1, std::uint32_t{}, set_far), HasSubstr("its corners"));
  EXPECT_THAT(changed(Section::first_seen, 1, std::uint32_t{}, set_far), HasSubstr("its blocks"));
  EXPECT_THAT(changed(Section::first_seen, 9, std::uint32_t{}, set_zero), HasSubstr("its blocks"));
  EXPECT_THAT(changed(Section::seen, 2, SeenCorner{}, [](auto& seen) { seen.corner = 65535; }),
              HasSubstr("its blocks"));
  EXPECT_THAT(changed(Section::seen, 2, SeenCorner{}, [](auto& seen) { seen.count = 65535; }),
              HasSubstr("its blocks"));
  EXPECT_THAT(changed(Section::seen, 2, SeenCorner{}, [](auto& seen) { seen.begin = 1U << 31U; }),
              HasSubstr("its blocks"));
  EXPECT_THAT(changed(Section::entries, 5, Entry{}, [](auto& entry) { entry.hub = 65535; }),
              HasSubstr("its paths"));
  EXPECT_THAT(changed(Section::entries, 5, Entry{}, [](auto& entry) { entry.corner = 65535; }),
              HasSubstr("its paths"));
  EXPECT_THAT(changed(Section::entries, 5, Entry{}, [](auto& entry) { entry.next = 5; }),
              HasSubstr("its paths"))
      << "it would go round for ever";
  EXPECT_THAT(changed(Section::entries, 5, Entry{}, [](auto& entry) { entry.next = 1U << 31U; }),
              HasSubstr("its paths"));
  EXPECT_THAT(
      changed(Section::entries, 5, Entry{}, [](auto& entry) { entry.length = kNoTautLength; }),
      HasSubstr("its paths"));
}

TEST(EuclideanIndexFile, NeverLeavesItselfWhereItIsForged) {
  const BitGrid free = half_open_floor(4, 20, 18);
  const std::vector<Cell> cells = free_cells(free);
  const std::vector<std::byte> bytes = bytes_of_index(free);
  int opened = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    Random random(seed);
    std::vector<std::byte> forged = bytes;
    const int changes = random.between(1, 3);
    for (int i = 0; i < changes; ++i) {
      const std::size_t at =
          sizeof(IndexHeader) + random.below(forged.size() - sizeof(IndexHeader));
      const bool is_high = random.chance(0.3);
      forged[at] = static_cast<std::byte>(is_high ? 0xFF : random.below(256));
    }
    if (!refusal_of_forged(forged, free).empty()) continue;
    const auto engine = EuclideanEngine::open(IndexBytes::copy_of(forged), free);
    ASSERT_TRUE(engine);
    ++opened;
    for (const Cell goal : cells) {
      (*engine)->find(cells.front(), goal);
      for (const std::uint32_t corner : (*engine)->corners()) {
        ASSERT_LT(corner, (*engine)->portals().corners().size());
      }
    }
  }
  EXPECT_GT(opened, 100) << "too few to say anything";
  EXPECT_LT(opened, 1500) << "nothing is checked";
}

TEST(EuclideanIndexFile, TellsHowFarItIsAndStopsWhenToldTo) {
  const BitGrid free = half_open_floor(5, 60, 60);
  std::vector<double> shares;
  ASSERT_TRUE(
      build_euclidean_index(free, {.progress = [&](double share) { shares.push_back(share); }}));
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  EXPECT_GT(shares.size(), 5U);
  for (const double when : {0.0, 0.1, 0.3, 0.5}) {
    std::atomic<bool> cancel = false;
    double last = 0;
    const IndexBuilding building{.progress =
                                     [&](double share) {
                                       last = share;
                                       cancel = share >= when;
                                     },
                                 .cancel = &cancel};
    const auto index = build_euclidean_index(free, building);
    ASSERT_FALSE(index);
    EXPECT_EQ(index.error().status, Status::cancelled);
    EXPECT_LT(last, when + 0.1) << "went on for long";
  }
}

}  // namespace
}  // namespace wend
