#include "wend/planner/costs/cost_grid.hpp"

#include <algorithm>
#include <utility>

namespace wend {
namespace {

constexpr unsigned kMiddle = 1U << 4U;  // of a 3 x 3 block
constexpr std::uint32_t kUnknown = 0;   // the least steps of a row, until they are counted

/// The eight neighbours in a block, without the middle.
constexpr unsigned neighbours_in(unsigned block) { return (block & 15U) | ((block >> 5U) << 4U); }
constexpr unsigned block_of(unsigned neighbours) {
  return (neighbours & 15U) | kMiddle | ((neighbours >> 4U) << 5U);
}

/// The cells that the parent of a cell reached by `arrival` reaches by a straight step, and the parent.
DirectionSet behind(Move arrival) {
  const Direction back = opposite(static_cast<Direction>(arrival));
  return static_cast<DirectionSet>(set_of(back) | set_of(beside(back)[0]) |
                                   set_of(beside(back)[1]));
}

/// The stride of the rows: never a multiple of a high power of two, which would make all cells of a column
/// compete for the same lines of the cache.
StateId stride_for(int width) {
  const auto stride = static_cast<StateId>(width) + 2;
  return stride % 512 == 0 ? stride + 8 : stride;
}

/// The least and the largest steps of the free cells in each column of three rows, then in each block.
class BlockRange {
 public:
  explicit BlockRange(int width)
      : least_(static_cast<std::size_t>(width) + 2, kNothing),
        most_(static_cast<std::size_t>(width) + 2, 0) {}

  /// `rows`: the steps of three rows, 0 where blocked, with a cell of border on both sides.
  void read(const std::array<const std::uint32_t*, 3>& rows) {
    for (std::size_t i = 0; i < least_.size(); ++i) {
      const std::array three{rows[0][i], rows[1][i], rows[2][i]};
      // A blocked cell counts as the largest least: 0 - 1 wraps.
      least_[i] = std::min({three[0] - 1, three[1] - 1, three[2] - 1});
      most_[i] = std::max({three[0], three[1], three[2]});
    }
  }

  CostClass class_at(std::size_t x) const {
    const std::uint64_t least =
        std::uint64_t{std::min({least_[x], least_[x + 1], least_[x + 2]})} + 1;
    const std::uint64_t most = std::max({most_[x], most_[x + 1], most_[x + 2]});
    if (least == most) return CostClass::uniform;
    return 5 * most <= 9 * least ? CostClass::smooth : CostClass::general;
  }

 private:
  static constexpr std::uint32_t kNothing = ~std::uint32_t{0};
  std::vector<std::uint32_t> least_;  // less 1
  std::vector<std::uint32_t> most_;
};

/// The 3 x 3 blocks of some cells in a row, from left to right, as BitGrid::block() has them.
class PassableWindow {
 public:
  /// The most cells of a window.
  static constexpr int kCells = 62;

  PassableWindow(const BitGrid& passable, Cell first)
      : above_(bits(passable, {first.x, first.y + 1})),
        middle_(bits(passable, first)),
        below_(bits(passable, {first.x, first.y - 1})) {}

  unsigned next_block() {
    const std::uint64_t block = (above_ & 7U) | (middle_ & 7U) << 3U | (below_ & 7U) << 6U;
    above_ >>= 1U;
    middle_ >>= 1U;
    below_ >>= 1U;
    return static_cast<unsigned>(block);
  }

 private:
  /// From the cell before on: 64 bits, those beyond the row zero.
  static std::uint64_t bits(const BitGrid& passable, Cell cell) {
    const auto words = passable.row_words(cell.y);
    const auto bit = static_cast<std::size_t>(cell.x);  // that of the cell before
    const std::size_t shift = bit % 64;
    std::uint64_t window = words[bit / 64] >> shift;
    if (shift != 0 && bit / 64 + 1 < words.size()) window |= words[bit / 64 + 1] << (64 - shift);
    return window;
  }

  std::uint64_t above_;
  std::uint64_t middle_;
  std::uint64_t below_;
};

}  // namespace

CostMoves::CostMoves(GridMoves moves) {
  const std::array tables{MoveTable(moves, MoveTable::Pruning::canonical),
                          MoveTable(moves, MoveTable::Pruning::longer), MoveTable(moves)};
  for (std::size_t kind = 0; kind < tables.size(); ++kind) {
    for (unsigned neighbours = 0; neighbours < 256; ++neighbours) {
      const unsigned block = block_of(neighbours);
      for (Move arrival = 0; arrival <= kNoMove; ++arrival) {
        if (arrival >= kDirections && arrival != kNoMove) continue;
        DirectionSet set = tables[kind].moves(arrival, block);
        if (static_cast<CostClass>(kind) == CostClass::general && arrival != kNoMove) {
          set &= static_cast<DirectionSet>(~behind(arrival));
        }
        moves_[arrival * kKeys + kind * 256 + neighbours] = set;
      }
    }
  }
}

template <class Word>
bool CostGrid<Word>::holds(const CostMap& costs) {
  return costs.most_steps() <= kMostSteps;
}

template <class Word>
CostGrid<Word>::CostGrid(const FreeSpace& space, GridMoves moves, DeadlineCheck& stop)
    : width_(space.width()),
      height_(space.height()),
      stride_(stride_for(space.width())),
      inverse_(~std::uint64_t{0} / stride_ + 1),
      moves_(moves),
      one_(space.uniform_terrain() ? 1 : CostMap::kOne),
      rows_(space.uniform_terrain() ? 0 : static_cast<std::size_t>(space.height())) {
  for (std::size_t i = 0; i < kDirections; ++i) {
    offsets_[i] = static_cast<StateId>(kDirectionSteps[i].y) * stride_ +
                  static_cast<StateId>(kDirectionSteps[i].x);
  }
  const std::size_t words = std::size_t{stride_} * (static_cast<std::size_t>(space.height()) + 2);
  words_.reserve(words);
  while (words_.size() < words && !stop.now()) {
    constexpr std::size_t kAtOnce = std::size_t{1} << 18U;
    words_.resize(std::min(words_.size() + kAtOnce, words));
  }
  compute_words(space, CellBox::of(space), stop, [this](StateId id, int y, Word word) {
    words_[id] = word;
    if (one_ != 1 && word != 0) count(y, steps(word));
  });
  find_least();
}

template <class Word>
void CostGrid<Word>::repair(const FreeSpace& space, const SpaceChange& change) {
  // A log that is longer than this costs a search more than beginning anew.
  const std::size_t longest = words_.size() / 8 + 1024;
  for (const CellBox& box : change.boxes) {
    const CellBox reached = box.grown_by(1).clipped_to(space);
    compute_words(space, reached, DeadlineCheck::never(), [this](StateId id, int y, Word word) {
      Word& here = words_[id];
      if (here == word) return;
      log_.push_back({id, here});
      if (one_ != 1 && steps(here) != steps(word)) {
        LeastOfRow& row = rows_[static_cast<std::size_t>(y)];
        if (here != 0 && steps(here) == row.steps && --row.cells == 0) row.steps = kUnknown;
        if (word != 0) count(y, steps(word));
      }
      here = word;
    });
    for (int y = reached.begin.y; y < reached.end.y && one_ != 1; ++y) {
      if (rows_[static_cast<std::size_t>(y)].steps == kUnknown) count_row(y);
    }
  }
  find_least();
  if (log_.size() > longest) {
    log_begin_ += log_.size();
    log_.clear();
  }
}

/// Calls store(id, y, word) for each cell of a box.
template <class Word>
template <class Store>
void CostGrid<Word>::compute_words(const FreeSpace& space, const CellBox& box, DeadlineCheck& stop,
                                   Store&& store) const {
  if (one_ == 1) {
    compute_uniform_words(space.passable(), box, stop, store);
  } else {
    compute_dear_words(space, box, stop, store);
  }
}

/// Every word follows from the 3 x 3 block of passable bits.
template <class Word>
template <class Store>
void CostGrid<Word>::compute_uniform_words(const BitGrid& passable, const CellBox& box,
                                           DeadlineCheck& stop, Store&& store) const {
  std::array<Word, 512> words{};
  for (unsigned block = 0; block < words.size(); ++block) {
    if ((block & kMiddle) == 0) continue;
    words[block] = static_cast<Word>((1U << CostMoves::kKeyBits) | neighbours_in(block));
  }
  for (int y = box.begin.y; y < box.end.y && !stop.now(); ++y) {
    StateId id = number({box.begin.x, y});
    for (int x = box.begin.x; x < box.end.x;) {
      PassableWindow window(passable, {x, y});
      const int end = std::min(box.end.x, x + PassableWindow::kCells);
      for (; x < end; ++x, ++id) store(id, y, words[window.next_block()]);
    }
  }
}

template <class Word>
template <class Store>
void CostGrid<Word>::compute_dear_words(const FreeSpace& space, const CellBox& box,
                                        DeadlineCheck& stop, Store&& store) const {
  std::array<std::vector<std::uint32_t>, 3> rows;  // with a column more on both sides
  for (auto& row : rows) row.assign(static_cast<std::size_t>(box.width()) + 2, 0);
  const auto read = [&](int y, std::vector<std::uint32_t>& row) {
    std::fill(row.begin(), row.end(), 0);
    if (y < 0 || y >= height_) return;
    const int begin = std::max(box.begin.x - 1, 0);
    const int end = std::min(box.end.x + 1, width_);
    const auto steps = std::span(row).subspan(static_cast<std::size_t>(begin - box.begin.x + 1),
                                              static_cast<std::size_t>(end - begin));
    space.costs().read_row(begin, y, steps);
    const auto passable = space.passable().row_words(y);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::size_t bit = static_cast<std::size_t>(begin) + 1 + i;
      steps[i] &= 0U - static_cast<std::uint32_t>((passable[bit / 64] >> (bit % 64)) & 1U);
    }
  };
  BlockRange range(box.width());
  read(box.begin.y - 1, rows[1]);
  read(box.begin.y, rows[2]);
  for (int y = box.begin.y; y < box.end.y && !stop.now(); ++y) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    read(y + 1, rows[2]);
    range.read({rows[0].data(), rows[1].data(), rows[2].data()});
    StateId id = number({box.begin.x, y});
    for (int x = box.begin.x; x < box.end.x;) {
      PassableWindow window(space.passable(), {x, y});
      const int end = std::min(box.end.x, x + PassableWindow::kCells);
      for (; x < end; ++x, ++id) {
        const auto at = static_cast<std::size_t>(x - box.begin.x);
        const Word steps = rows[1][at + 1];
        const unsigned neighbours = neighbours_in(window.next_block());
        const auto kind = static_cast<unsigned>(range.class_at(at));
        const Word word = (steps << CostMoves::kKeyBits) | (kind << 8U) | neighbours;
        store(id, y, steps == 0 ? Word{0} : word);
      }
    }
  }
}

/// A free cell of a row has these steps.
template <class Word>
void CostGrid<Word>::count(int y, std::uint64_t steps) {
  LeastOfRow& row = rows_[static_cast<std::size_t>(y)];
  most_steps_ = std::max(most_steps_, steps);
  if (steps == row.steps) {
    ++row.cells;
  } else if (steps < row.steps) {
    row = {static_cast<std::uint32_t>(steps), 1};
  }
}

/// Finds the least steps of a row anew.
template <class Word>
void CostGrid<Word>::count_row(int y) {
  rows_[static_cast<std::size_t>(y)] = {};
  const StateId begin = number({0, y});
  for (StateId id = begin; id < begin + static_cast<StateId>(width_); ++id) {
    if (words_[id] != 0) count(y, steps(words_[id]));
  }
}

template <class Word>
void CostGrid<Word>::find_least() {
  if (one_ == 1) return;
  least_steps_ = CostMap::kMost;
  for (const LeastOfRow& row : rows_)
    least_steps_ = std::min<std::uint64_t>(least_steps_, row.steps);
}

template class CostGrid<std::uint32_t>;
template class CostGrid<std::uint64_t>;

}  // namespace wend
