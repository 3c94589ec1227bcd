#pragma once

// HubRecord: the record of a component's cells, or of a corner, in a label index. It names the corners
// where paths from there may turn first, and the hubs behind them with the costs from these corners.
//
// A record is an array of 32-bit words: how many corners and how many hubs it names; the corners' cells,
// x in the lower half; for each corner how many hubs are reached by it (16 bits each); the hubs, corner
// after corner (16 bits each where the map has no more than 65536 hubs); their costs; and, for a corner,
// where the paths to its hubs begin in the HeavyPaths. The record of a corner names only that corner.
// Arrays of 16 bits are padded to whole words.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/index/corner_cost.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/file/index_sections.hpp"
#include "wend/index/hub_labels/hub_labelling.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

template <class Hub>
class HubRecord {
 public:
  static constexpr std::size_t kHeaderWords = 2;

  explicit HubRecord(const std::uint32_t* words)
      : corner_count_(words[0] & kCountMask),
        hub_count_(words[1]),
        cells_(words + kHeaderWords),
        counts_(cells_ + corner_count_),
        hubs_(counts_ + words_of<std::uint16_t>(corner_count_)),
        costs_(hubs_ + words_of<Hub>(hub_count_)),
        is_corner_((words[0] & kCornerFlag) != 0) {}

  std::uint32_t corner_count() const { return corner_count_; }
  std::uint32_t hub_count() const { return hub_count_; }

  /// Is it the record of a corner, not of a component?
  bool is_corner() const { return is_corner_; }

  Cell cell(std::uint32_t corner) const { return unpacked(cells_[corner]); }

  /// The number of hubs reached by a corner.
  std::uint32_t count(std::uint32_t corner) const {
    return reinterpret_cast<const std::uint16_t*>(counts_)[corner];
  }
  Hub hub(std::uint32_t i) const { return hubs()[i]; }
  CornerCost cost(std::uint32_t i) const { return costs_[i]; }

  std::span<const Hub> hubs() const { return {reinterpret_cast<const Hub*>(hubs_), hub_count_}; }

  /// Only for the record of a corner: where the path to a hub begins in the HeavyPaths.
  std::uint32_t place(std::uint32_t i) const { return costs_[hub_count_ + i]; }

  /// The length of the record in words.
  std::size_t size() const {
    const std::size_t per_hub = is_corner_ ? 2 : 1;
    return kHeaderWords + corner_count_ + words_of<std::uint16_t>(corner_count_) +
           words_of<Hub>(hub_count_) + per_hub * hub_count_;
  }

  /// A corner of a record to write, with the hubs reached by it.
  struct Part {
    Cell cell;
    std::vector<Hub> hubs;
    std::vector<CornerCost> costs;
  };

  /// Appends the record of a component or of a corner; only a corner has places.
  static void append(std::vector<std::uint32_t>& words, std::span<const Part> parts,
                     std::span<const std::uint32_t> places, bool is_corner) {
    std::vector<std::uint32_t> cells;
    std::vector<std::uint16_t> counts;
    std::vector<Hub> hubs;
    std::vector<CornerCost> costs;
    for (const Part& part : parts) {
      cells.push_back(packed(part.cell));
      counts.push_back(static_cast<std::uint16_t>(part.hubs.size()));
      hubs.insert(hubs.end(), part.hubs.begin(), part.hubs.end());
      costs.insert(costs.end(), part.costs.begin(), part.costs.end());
    }
    const auto corner_count = static_cast<std::uint32_t>(parts.size());
    words.push_back(corner_count | (is_corner ? kCornerFlag : 0));
    words.push_back(static_cast<std::uint32_t>(hubs.size()));
    append_array<std::uint32_t>(words, cells);
    append_array<std::uint16_t>(words, counts);
    append_array<Hub>(words, hubs);
    append_array<CornerCost>(words, costs);
    append_array<std::uint32_t>(words, places);
  }

 private:
  static constexpr std::uint32_t kCornerFlag = std::uint32_t{1} << 31U;
  static constexpr std::uint32_t kCountMask = 0xFFFF;
  static constexpr unsigned kHalf = 16;  // bits

  template <class T>
  static std::size_t words_of(std::size_t count) {
    return (count * sizeof(T) + sizeof(std::uint32_t) - 1) / sizeof(std::uint32_t);
  }
  static std::uint32_t packed(Cell cell) {
    return static_cast<std::uint32_t>(cell.x) | static_cast<std::uint32_t>(cell.y) << kHalf;
  }
  static Cell unpacked(std::uint32_t word) {
    return {static_cast<int>(word & kCountMask), static_cast<int>(word >> kHalf)};
  }
  template <class T>
  static void append_array(std::vector<std::uint32_t>& words, std::span<const T> array) {
    const std::size_t begin = words.size();
    words.resize(begin + words_of<T>(array.size()));
    if (!array.empty()) std::memcpy(words.data() + begin, array.data(), array.size_bytes());
  }

  std::uint32_t corner_count_;
  std::uint32_t hub_count_;
  const std::uint32_t* cells_;
  const std::uint32_t* counts_;
  const std::uint32_t* hubs_;
  const CornerCost* costs_;
  bool is_corner_;
};

// HeavyPaths: the paths from corners to their hubs as runs of steps, which can be written cell by cell
// without a search.
//
// The shortest-path tree of a hub is split into heavy paths: each continues from a corner to the child
// with the largest subtree. A heavy path is a string of runs from its far end towards the hub; where it
// joins the heavy path of its parent, a joint says where to read on. So a path to a hub is read from few
// places in memory.
//
// A string consists of 16-bit words. A run is its steps times 8 plus its Direction. A joint is a 0
// followed by the place where reading continues, lower half first; this is kHub at the hub.

using RunWord = std::uint16_t;

namespace run_word {

inline constexpr RunWord kJoint = 0;
inline constexpr std::uint32_t kHub = static_cast<std::uint32_t>(-1);
inline constexpr int kMostSteps = (1 << 13) - 1;

constexpr RunWord of(int steps, Direction direction) {
  return static_cast<RunWord>(steps * kDirections + static_cast<int>(direction));
}
constexpr std::uint32_t steps(RunWord word) { return word / kDirections; }
constexpr Direction direction(RunWord word) { return static_cast<Direction>(word % kDirections); }

}  // namespace run_word

class HeavyPaths {
 public:
  /// Needs a complete labelling. O(its entries).
  HeavyPaths(const Corners& corners, const HubLabelling& labelling,
             const IndexBuilding& building = {});

  std::span<const RunWord> words() const { return words_; }

  /// Where the paths from a corner to its hubs begin in words(), in the order of its label; kHub where
  /// the corner is the hub.
  std::span<const std::uint32_t> places(std::uint32_t corner) const {
    return std::span(places_).subspan(begins_[corner], begins_[corner + 1] - begins_[corner]);
  }

 private:
  void add_tree(std::span<const HubTreeNode> tree);
  void add_path(std::span<const HubTreeNode> tree, std::uint32_t top);
  void add_way(Cell from, Cell to);
  void add_joint(std::uint32_t place);

  const Corners& corners_;
  std::vector<RunWord> words_;
  std::vector<std::size_t> begins_;    // by corner, and the end: in places_
  std::vector<std::uint32_t> places_;  // by corner, label after label

  // State of the tree that is being added, by node.
  std::vector<std::uint32_t> below_;   // nodes in its subtree
  std::vector<std::uint32_t> heavy_;   // the child with the largest subtree
  std::vector<std::uint32_t> starts_;  // where its path begins
  std::vector<std::uint32_t> path_;
  std::vector<std::size_t> next_;  // by corner: the next of its places to fill
};

// HubSections: the sections of a label index, read in place from its file.

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

  /// Returns the sections of an index, or what is wrong. They are checked so that the engine never reads
  /// out of bounds, whatever they contain.
  static Expected<HubSections, Error> of(const IndexReader& reader, const BitGrid& passable);
};

// hub_engine.cpp: the engine that answers queries from these sections.

/// Keeps the bytes that contain the sections.
std::unique_ptr<IndexEngine> make_hub_engine(IndexBytes index, const HubSections& sections,
                                             const BitGrid& passable);

}  // namespace wend
