#pragma once

// TautLabelSections: the arrays of a Euclidean label index, as they lie in its file.
//
// Corners are named by their hubs, of which each corner is one: 0 is the most important. The entries of labels are
// sorted by the corner and the first edge of their paths. So those whose paths go on taut from a cell lie side by side,
// and where a block of 8 x 8 cells sees a corner, it says which these are: for its cells above the corner's row and for
// those below. For some of its cells they may be more than go on taut; this is harmless.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/index/euclidean_labels/taut_labelling.hpp"
#include "wend/index/file/index_sections.hpp"
#include "wend/sight/portals.hpp"
#include "wend/sight/taut_map.hpp"

namespace wend {

/// A length in units of 2^-36 cells.
using TautLength = std::uint64_t;
inline constexpr TautLength kTautLengthUnit = TautLength{1} << 36U;
/// More than any length in a file.
inline constexpr TautLength kNoTautLength = TautLength{1} << 62U;

/// A hub of a corner, and the path to it.
struct TautLabelEntry {
  static constexpr std::uint32_t kHub = UINT32_MAX;

  TautLength length;
  std::uint32_t next;  // the entry of the corner behind it; kHub: that is the hub
  std::uint16_t hub;
  std::uint16_t corner;
};

/// Where some cells of a block see a corner, and the entries that go on from there.
struct SeenCorner {
  std::uint32_t begin;  // of the entries
  std::uint16_t count;
  std::uint16_t corner;
};

struct TautLabelSections {
  static constexpr std::uint32_t kVersion = 1;
  static constexpr std::size_t kMostCorners = 65536;
  static constexpr double kLongestPath = 1U << 24U;  // to a hub, in cells
  static constexpr int kSide = TautMap::kSide;       // of a block

  enum class Section : std::uint8_t { corners, first_seen, seen, cells, entries };

  std::span<const std::uint32_t> corners;     // of Portals, by hub
  std::span<const std::uint32_t> first_seen;  // of each block, and one past the last
  std::span<const SeenCorner> seen;
  std::span<const std::uint64_t> cells;  // of each that is seen: by which cells
  std::span<const TautLabelEntry> entries;

  /// Those of a file; the error is index_mismatch. No reference leads out of them, and all paths end. O(bytes).
  static Expected<TautLabelSections, Error> of(const IndexReader& reader, const Portals& portals);
};

/// The arrays of an index that is built.
class TautLabelArrays {
 public:
  /// All corners must be hubs.
  TautLabelArrays(const TautMap& map, const TautLabelling& labelling);

  void write(IndexWriter& writer) const;

 private:
  void add_entries(const TautLabelling& labelling);
  void add_block(std::size_t block, const TautLabelling& labelling);
  void add_seen(std::size_t block, std::uint32_t corner, std::uint64_t cells,
                const TautLabelling& labelling);

  const TautMap& map_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> first_seen_;
  std::vector<SeenCorner> seen_;
  std::vector<std::uint64_t> cells_;
  std::vector<TautLabelEntry> entries_;
  std::vector<std::uint32_t> first_entry_;  // of each edge, and one past the last
};

}  // namespace wend
