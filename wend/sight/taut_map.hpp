#pragma once

// TautMap: all that TautGraph can learn of a map, and which corners each cell sees, for many searches and threads.
//
//   const auto map = wend::TautMap::make(shared, wend::TautMap::usual_most_bytes(*shared));
//   if (map != nullptr) map->for_each_seen({0, 3}, mark_corner);
//
// The cells that see a corner are sets of bits, a word for each block of 8 x 8 cells, found by one sweep from the
// corner. So a cell looks up what it sees: those words of its block that have its bit.
//
// O(corners times portals seen) to make; 24 bytes an edge, 12 for each corner and each block that sees it. Who cannot
// wait so long makes it in parts:
//
//   wend::TautMapMaking making(shared, wend::TautMap::usual_most_bytes(*shared));
//   const auto state = making.go_on([&](double share) { return wants_more(share); });
//   if (state == wend::TautMapMaking::State::finished) use(making.take());

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/sight/taut_graph.hpp"

namespace wend {

class TautMap {
 public:
  /// What searches allow: 1 MiB and 64 bytes a cell.
  static std::size_t usual_most_bytes(const Portals& portals);

  /// Null where edges and words would take more memory than `most_bytes`.
  static std::shared_ptr<const TautMap> make(std::shared_ptr<const Portals> portals,
                                             std::size_t most_bytes);

  /// With all edges known.
  const TautGraph& graph() const { return graph_; }

  /// Calls tell(corner) for the corners of which CornerSweep::from_point() tells the centre of a cell, in the order of their numbers.
  template <class Tell>
  void for_each_seen(Cell cell, Tell&& tell) const {
    const std::size_t block = block_of(cell.x, cell.y);
    const std::uint64_t bit = std::uint64_t{1} << bit_of(cell.x, cell.y);
    for (std::uint32_t i = first_[block]; i < first_[block + 1]; ++i) {
      if ((words_[i] & bit) != 0) tell(corners_[i]);
    }
  }

  static constexpr int kSide = 8;  // of a block

  /// Blocks count from the cells at (0, 0), row after row.
  std::size_t blocks() const { return first_.size() - 1; }
  std::size_t blocks_a_row() const { return columns_; }
  /// Calls tell(corner, cells) for the corners that a block sees, where bit 8 y + x is set for its cells that do.
  template <class Tell>
  void for_each_word(std::size_t block, Tell&& tell) const {
    for (std::uint32_t i = first_[block]; i < first_[block + 1]; ++i) tell(corners_[i], words_[i]);
  }

 private:
  friend class TautMapMaking;

  /// Where a block sees a corner.
  struct Entry {
    std::uint32_t block;
    std::uint32_t corner;
    std::uint64_t cells;
  };

  explicit TautMap(std::shared_ptr<const Portals> portals);

  std::size_t block_of(int x, int y) const {
    return static_cast<std::size_t>(y / kSide) * columns_ + static_cast<std::size_t>(x / kSide);
  }
  static unsigned bit_of(int x, int y) {
    return static_cast<unsigned>(y % kSide * kSide + x % kSide);
  }
  void look_around(std::uint32_t corner, std::vector<Entry>& entries);
  void see(int y, int first, int last);
  void store(const std::vector<Entry>& entries);

  TautGraph graph_;
  std::size_t columns_;                 // of blocks
  std::vector<std::uint64_t> seen_;     // of each block, while a corner is looked at
  std::vector<std::uint32_t> touched_;  // blocks of which some is seen
  std::vector<std::uint32_t> first_;    // of each block, and one past the last
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> corners_;  // of each word
};

/// A TautMap while it is made. One thread at a time.
class TautMapMaking {
 public:
  enum class State { unfinished, too_large, finished };

  /// `most_bytes` as in TautMap::make().
  TautMapMaking(std::shared_ptr<const Portals> portals, std::size_t most_bytes);

  /// Looks around corners until it has seen all of them, or their edges and words take too much memory. Before each
  /// one it asks goes_on(share of the corners that are done), and stops for now if the answer is no.
  State go_on(const std::function<bool(double share)>& goes_on);

  /// The map, once it is finished.
  std::shared_ptr<const TautMap> take() { return std::move(map_); }

 private:
  std::shared_ptr<TautMap> map_;
  std::vector<TautMap::Entry> entries_;
  std::size_t most_bytes_;
  std::uint32_t next_ = 0;  // corner
};

}  // namespace wend
