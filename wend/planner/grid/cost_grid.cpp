#include "wend/planner/grid/cost_grid.hpp"

#include <algorithm>
#include <utility>

namespace wend {
namespace {

constexpr unsigned kMiddle = 1U << 4U;  // of a 3 x 3 block

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
CostGrid<Word>::CostGrid(const FreeSpace& space, GridMoves moves)
    : width_(space.width()),
      stride_(stride_for(space.width())),
      inverse_(~std::uint64_t{0} / stride_ + 1),
      moves_(moves),
      one_(space.uniform_terrain() ? 1 : CostMap::kOne),
      row_steps_(static_cast<std::size_t>(space.height())) {
  for (std::size_t i = 0; i < kDirections; ++i) {
    offsets_[i] = static_cast<StateId>(kDirectionSteps[i].y) * stride_ +
                  static_cast<StateId>(kDirectionSteps[i].x);
  }
  words_.resize(std::size_t{stride_} * (static_cast<std::size_t>(space.height()) + 2));
  compute_words(space, CellBox::of(space), [this](Cell cell, Word word) {
    words_[number(cell)] = word;
    if (word == 0) return;
    Range& range = row_steps_[static_cast<std::size_t>(cell.y)];
    range.least = std::min(range.least, static_cast<std::uint32_t>(steps(word)));
    range.most = std::max(range.most, static_cast<std::uint32_t>(steps(word)));
  });
  join_rows();
}

template <class Word>
void CostGrid<Word>::repair(const FreeSpace& space, const SpaceChange& change) {
  // A log that is longer than this costs a search more than beginning anew.
  const std::size_t longest = words_.size() / 8 + 1024;
  for (const CellBox& box : change.boxes) {
    const CellBox reached = box.grown_by(1).clipped_to(space);
    compute_words(space, reached, [this](Cell cell, Word word) {
      Word& here = words_[number(cell)];
      if (here == word) return;
      log_.push_back({number(cell), here});
      here = word;
    });
    for (int y = reached.begin.y; y < reached.end.y; ++y) {
      row_steps_[static_cast<std::size_t>(y)] = range_of_row(y);
    }
  }
  join_rows();
  if (log_.size() > longest) {
    log_begin_ += log_.size();
    log_.clear();
  }
}

/// Calls store(cell, word) for each cell of a box.
template <class Word>
template <class Store>
void CostGrid<Word>::compute_words(const FreeSpace& space, const CellBox& box,
                                   Store&& store) const {
  std::array<std::vector<std::uint32_t>, 3> rows;  // with a column more on both sides
  for (auto& row : rows) row.assign(static_cast<std::size_t>(box.width()) + 2, 0);
  const auto read = [&](int y, std::vector<std::uint32_t>& row) {
    std::fill(row.begin(), row.end(), 0);
    if (y < 0 || y >= space.height()) return;
    const int end = std::min(box.end.x + 1, space.width());
    for (int x = std::max(box.begin.x - 1, 0); x < end; ++x) {
      const Cell cell{x, y};
      if (!space.passable()[cell]) continue;
      const std::uint32_t steps = space.uniform_terrain() ? 1 : space.costs().steps(cell);
      row[static_cast<std::size_t>(x - box.begin.x + 1)] = steps;
    }
  };
  BlockRange range(box.width());
  read(box.begin.y - 1, rows[1]);
  read(box.begin.y, rows[2]);
  for (int y = box.begin.y; y < box.end.y; ++y) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    read(y + 1, rows[2]);
    range.read({rows[0].data(), rows[1].data(), rows[2].data()});
    for (int x = box.begin.x; x < box.end.x; ++x) {
      const auto at = static_cast<std::size_t>(x - box.begin.x);
      const Word steps = rows[1][at + 1];
      Word word = 0;
      if (steps != 0) {
        const auto kind = static_cast<unsigned>(range.class_at(at));
        word = static_cast<Word>((steps << CostMoves::kKeyBits) | (kind << 8U) |
                                 neighbours_in(space.passable().block({x, y})));
      }
      store(Cell{x, y}, word);
    }
  }
}

template <class Word>
typename CostGrid<Word>::Range CostGrid<Word>::range_of_row(int y) const {
  Range range;
  const StateId begin = number({0, y});
  for (StateId id = begin; id < begin + static_cast<StateId>(width_); ++id) {
    // A blocked cell counts as the largest least: 0 - 1 wraps.
    const auto here = static_cast<std::uint32_t>(steps(words_[id]));
    range.least = std::min(range.least - 1, here - 1) + 1;
    range.most = std::max(range.most, here);
  }
  return range;
}

template <class Word>
void CostGrid<Word>::join_rows() {
  steps_ = {};
  for (const Range& row : row_steps_) {
    steps_.least = std::min(steps_.least, row.least);
    steps_.most = std::max(steps_.most, row.most);
  }
}

template class CostGrid<std::uint32_t>;
template class CostGrid<std::uint64_t>;

}  // namespace wend
