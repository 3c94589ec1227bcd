#pragma once

// CostGrid: the cells of a FreeSpace, packed for searches in whole numbers that leap or repair.
//
// The word of a cell holds its cost in CostMap steps (1 on a map where every cell costs the same), which of its
// neighbours are free, and its class. The class says which moves a search can leave out after an arrival,
// because a way around the cell is at least as good:
//
//   uniform  all free cells of the 3 x 3 block cost the same: as on a uniform map (canonical pruning)
//   smooth   no free cell of the block costs more than 9/5 of another: moves with a strictly shorter way
//            around, which 9/5 cannot make dearer (two straight steps around a right angle of two diagonal
//            ones are the closest case: 3.6 < 3.65)
//   general  moves to cells that the parent reaches by one straight step
//
// Cells of the uniform class whose whole block is free are "interior".
//
// Cells are numbered with a border of blocked cells around the map, so that a neighbour needs no check.
//
// repair() follows an edit of the map. It keeps a log of the words that it changed, from which searches catch up
// with the grid when they are next used.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/base/large_pages.hpp"
#include "wend/base/state_id.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/space_change.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

enum class CostClass : unsigned char { uniform, smooth, general };

/// The moves from a cell by its class, its free neighbours and how it was reached.
class CostMoves {
 public:
  explicit CostMoves(GridMoves moves);

  /// `key` has the lowest bits of a cell's word.
  DirectionSet moves(Move arrival, unsigned key) const { return moves_[arrival * kKeys + key]; }

  static constexpr unsigned kKeyBits = 10;  // 8 free neighbours, then the class

 private:
  static constexpr std::size_t kKeys = std::size_t{1} << kKeyBits;
  std::array<DirectionSet, (kNoMove + 1) * kKeys> moves_{};
};

/// Word is 32 bits for multipliers below 16,384, or 64 for any.
template <class Word>
class CostGrid {
 public:
  /// A word that a repair changed.
  struct Change {
    StateId id;
    Word before;
  };

  /// The largest multiplier in CostMap steps.
  static constexpr std::uint64_t kMostSteps = static_cast<Word>(~Word{0}) >> CostMoves::kKeyBits;

  /// Can the word of a cell hold these costs? O(cells) where a multiplier is 256 or more.
  static bool holds(const CostMap& costs);

  CostGrid(const FreeSpace& space, GridMoves moves, DeadlineCheck& stop = DeadlineCheck::never());

  /// Can the grid be repaired to be that of this space, which has the same size?
  bool can_become(const FreeSpace& space) const {
    return space.uniform_terrain() == (one_ == 1) && (one_ == 1 || holds(space.costs()));
  }

  /// Makes it the grid of this space, which it can_become(), after `change` (not everything). O(cells of the
  /// boxes + their rows).
  void repair(const FreeSpace& space, const SpaceChange& change);

  /// The number of changes logged so far: where a search that has caught up stands in the log.
  std::uint64_t log_end() const { return log_begin_ + log_.size(); }
  /// The changes since then, oldest first; nothing if the log no longer goes back so far.
  std::optional<std::span<const Change>> changes_since(std::uint64_t position) const {
    if (position < log_begin_) return std::nullopt;
    return std::span(log_).subspan(static_cast<std::size_t>(position - log_begin_));
  }

  StateId state_count() const { return static_cast<StateId>(words_.size()); }
  StateId number(Cell cell) const {
    return static_cast<StateId>(cell.y + 1) * stride_ + static_cast<StateId>(cell.x + 1);
  }
  Cell cell(StateId number) const {
    // A multiplication by 2^64 / stride, rounded up: exact for 32 bits.
    const auto y = static_cast<StateId>((static_cast<Wide>(inverse_) * number) >> 64U);
    return {static_cast<int>(number - y * stride_) - 1, static_cast<int>(y) - 1};
  }
  /// Modulo 2^32.
  StateId neighbour(StateId number, unsigned direction, StateId steps = 1) const {
    return number + offsets_[direction] * steps;
  }

  /// Can a path over the cell cost less than before a change, because it is free now, cheaper, or has more moves?
  bool became_better(const Change& change) const {
    const Word now = words_[change.id];
    if (now == 0) return false;
    if (change.before == 0 || steps(now) < steps(change.before)) return true;
    return (moves(kNoMove, now) & ~moves(kNoMove, change.before)) != 0;
  }

  Word word(StateId number) const { return words_[number]; }
  const Word* words() const { return words_.data(); }
  static std::uint64_t steps(Word word) { return word >> CostMoves::kKeyBits; }
  static unsigned key(Word word) { return static_cast<unsigned>(word) & kKeyMask; }
  static bool interior(Word word) { return key(word) == kInteriorKey; }
  static CostClass class_of(Word word) { return static_cast<CostClass>((word & kClassMask) >> 8U); }

  DirectionSet moves(Move arrival, Word word) const { return moves_.moves(arrival, key(word)); }
  /// The steps of a multiplier of 1: CostMap::kOne, or 1 where every cell costs the same.
  std::uint64_t one() const { return one_; }
  /// The least steps of a free cell.
  std::uint64_t least_steps() const { return least_steps_; }
  /// No free cell has more steps than this.
  std::uint64_t most_steps() const { return most_steps_; }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  __extension__ using Wide = unsigned __int128;

  static constexpr unsigned kKeyMask = (1U << CostMoves::kKeyBits) - 1;
  static constexpr Word kClassMask = 3U << 8U;
  static constexpr unsigned kInteriorKey = 255;  // all neighbours, uniform

  /// The free cells of a row that have the least steps.
  struct LeastOfRow {
    std::uint32_t steps = CostMap::kMost;
    std::uint32_t cells = 0;
  };

  template <class Store>
  void compute_words(const FreeSpace& space, const CellBox& box, DeadlineCheck& stop,
                     Store&& store) const;
  template <class Store>
  void compute_uniform_words(const BitGrid& passable, const CellBox& box, DeadlineCheck& stop,
                             Store&& store) const;
  template <class Store>
  void compute_dear_words(const FreeSpace& space, const CellBox& box, DeadlineCheck& stop,
                          Store&& store) const;
  void replace(StateId id, int y, Word word);
  void count(int y, std::uint64_t steps);
  void count_row(int y);
  void find_least();

  int width_;
  int height_;
  StateId stride_;
  std::uint64_t inverse_;
  std::array<StateId, kDirections> offsets_{};
  CostMoves moves_;
  std::uint64_t one_;
  std::vector<Word, LargePages<Word>> words_;
  std::vector<LeastOfRow> rows_;  // of a map with costs
  std::uint64_t least_steps_ = 1;
  std::uint64_t most_steps_ = 1;
  std::vector<Change> log_;
  std::uint64_t log_begin_ = 0;  // the number of changes dropped from it
};

extern template class CostGrid<std::uint32_t>;
extern template class CostGrid<std::uint64_t>;

}  // namespace wend
