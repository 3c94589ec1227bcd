#pragma once

// HubSections: what a label index is made of, where it lies in the index's file.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/file/index_reader.hpp"
#include "wend/index/hub_labels/heavy_paths.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

struct HubSections {
  static constexpr std::uint32_t kVersion = 1;
  static constexpr std::uint32_t kNoRecord = static_cast<std::uint32_t>(-1);
  static constexpr std::size_t kMostShortHubs = 65536;  // that 16 bits can name

  /// In the order in which they are written.
  enum class Section : std::size_t { hub_count, record_of_cell, records, runs };

  std::size_t hub_count = 0;
  std::span<const std::uint32_t> record_of_cell;  // row by row: its first word in `records`
  std::span<const std::uint32_t> records;         // HubRecords
  std::span<const RunWord> runs;                  // HeavyPaths::words()

  /// The sections of an index, so checked that reading them as the engine does stays inside of them
  /// whatever they say. Or what is wrong.
  static Expected<HubSections, std::string> of(const IndexReader& reader, const BitGrid& passable);
};

}  // namespace wend
