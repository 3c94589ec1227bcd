#include "wend/planner/costs/cost_grid.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "wend/planner/costs/dear_words.hpp"

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
  static std::uint64_t bits(const BitGrid& passable, Cell cell) {
    return bits_from(passable.row_words(cell.y),
                     static_cast<std::size_t>(cell.x));  // from the cell before on
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
  compute_words(space, CellBox::of(space), stop, [this](StateId id, int y, auto row) {
    std::ranges::copy(row, words_.begin() + id);
    if (one_ != 1) count_row(y);
  });
  find_least();
}

template <class Word>
void CostGrid<Word>::repair(const FreeSpace& space, const SpaceChange& change) {
  // A log that is longer than this costs a search more than beginning anew.
  const std::size_t longest = words_.size() / 8 + 1024;
  for (const CellBox& box : change.boxes) {
    const CellBox reached = box.grown_by(1).clipped_to(space);
    compute_words(space, reached, DeadlineCheck::never(), [this](StateId id, int y, auto row) {
      for (const Word word : row) replace(id++, y, word);
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

/// Logs the word of a cell, and puts another one in its place.
template <class Word>
void CostGrid<Word>::replace(StateId id, int y, Word word) {
  Word& here = words_[id];
  if (here == word) return;
  log_.push_back({id, here});
  if (one_ != 1 && steps(here) != steps(word)) {
    LeastOfRow& row = rows_[static_cast<std::size_t>(y)];
    if (here != 0 && steps(here) == row.steps && --row.cells == 0) row.steps = kUnknown;
    if (word != 0) count(y, steps(word));
  }
  here = word;
}

/// Calls store(id, y, words) for the cells of each row of a box; the first one has the id.
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
  std::vector<Word> row(static_cast<std::size_t>(box.width()));
  for (int y = box.begin.y; y < box.end.y && !stop.now(); ++y) {
    for (int x = box.begin.x; x < box.end.x;) {
      PassableWindow window(passable, {x, y});
      const int end = std::min(box.end.x, x + PassableWindow::kCells);
      for (; x < end; ++x) {
        row[static_cast<std::size_t>(x - box.begin.x)] = words[window.next_block()];
      }
    }
    store(number({box.begin.x, y}), y, std::span<const Word>(row));
  }
}

template <class Word>
template <class Store>
void CostGrid<Word>::compute_dear_words(const FreeSpace& space, const CellBox& box,
                                        DeadlineCheck& stop, Store&& store) const {
  std::vector<DearRow> rows(3, DearRow(box.width()));
  DearWords<Word> words(box.width());
  rows[1].read(space, {box.begin.x, box.begin.y - 1});
  rows[2].read(space, box.begin);
  for (int y = box.begin.y; y < box.end.y && !stop.now(); ++y) {
    std::ranges::rotate(rows, rows.begin() + 1);
    rows[2].read(space, {box.begin.x, y + 1});
    store(number({box.begin.x, y}), y, words.of(rows[0], rows[1], rows[2]));
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
  const auto row =
      std::span<const Word>(words_).subspan(number({0, y}), static_cast<std::size_t>(width_));
  Word least = kMostSteps;  // less 1: a blocked cell wraps
  Word most = 0;
  for (const Word word : row) {
    least = least_of<Word>(least, (word >> CostMoves::kKeyBits) - 1);
    most = most_of<Word>(most, word >> CostMoves::kKeyBits);
  }
  rows_[static_cast<std::size_t>(y)] = {};
  if (most == 0) return;
  most_steps_ = std::max<std::uint64_t>(most_steps_, most);
  const auto cells =
      std::ranges::count(row, least + 1, [](Word word) { return word >> CostMoves::kKeyBits; });
  rows_[static_cast<std::size_t>(y)] = {static_cast<std::uint32_t>(least + 1),
                                        static_cast<std::uint32_t>(cells)};
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
