#include "wend/space/jump_graph.hpp"

#include <algorithm>
#include <bit>

namespace wend {
namespace {

constexpr std::size_t kWordBits = 64;
constexpr int kTileRows = 32;

}  // namespace

JumpGraph::JumpGraph(std::shared_ptr<const JumpBoards> boards)
    : boards_(std::move(boards)), board_(boards_->jump_points()) {
  const std::size_t row_words = board_.words(0).size();
  before_.resize(row_words * static_cast<std::size_t>(board_.lines()));
  for (int top = 0; top < board_.lines(); top += kTileRows) {
    for (std::size_t word = 0; word < row_words; ++word) {
      for (int y = top; y < std::min(top + kTileRows, board_.lines()); ++y) number_word(y, word);
    }
  }
  forced_.reserve(cells_.size());
  for (const Cell cell : cells_) forced_.push_back(forced_at(cell));
  lists_.assign(kArrivals * cells_.size(), kUnknown);
}

void JumpGraph::number_word(int y, std::size_t word) {
  const auto words = board_.words(y);
  before_[static_cast<std::size_t>(y) * words.size() + word] =
      static_cast<std::uint32_t>(cells_.size());
  for (std::uint64_t bits = words[word]; bits != 0; bits &= bits - 1) {
    const auto bit = word * kWordBits + static_cast<std::size_t>(std::countr_zero(bits));
    cells_.push_back({static_cast<int>(bit) - 1, y});
  }
}

std::uint32_t JumpGraph::number_of(Cell cell) const {
  const auto words = board_.words(cell.y);
  const auto bit = static_cast<std::size_t>(cell.x + 1);
  const std::uint64_t below = (std::uint64_t{1} << (bit % kWordBits)) - 1;
  const std::size_t word = bit / kWordBits;
  return before_[static_cast<std::size_t>(cell.y) * words.size() + word] +
         static_cast<std::uint32_t>(std::popcount(words[word] & below));
}

/// Which obstacles beside a cell one can turn around, for each direction it is reached in.
std::uint8_t JumpGraph::forced_at(Cell cell) const {
  unsigned forced = 0;
  for (unsigned arrival = 0; arrival < kArrivals; ++arrival) {
    const auto ahead = static_cast<Direction>(2 * arrival);
    const Cell last = moved(cell, ahead, -1);
    if (!boards_->passable(last)) continue;
    for (const int eighths : {2, -2}) {
      const Direction side = turned(ahead, eighths);
      const bool open = boards_->passable(moved(cell, side, 1));
      if (!open || boards_->passable(moved(last, side, 1))) continue;
      forced |= (eighths > 0 ? 1U : 2U) << (2 * arrival);
    }
  }
  return static_cast<std::uint8_t>(forced);
}

std::uint32_t JumpGraph::find(std::uint32_t number, unsigned arrival) {
  const std::size_t list = jumps_.size();
  jumps_.emplace_back();
  append_jumps(cells_[number], directions(number, arrival), jumps_);
  jumps_[list] = Jump(static_cast<std::uint32_t>(jumps_.size() - list - 1));
  return static_cast<std::uint32_t>(list);
}

void JumpGraph::append_jumps(Cell from, DirectionSet directions, std::vector<Jump>& jumps) const {
  using enum Direction;
  directions &= boards_->moves(from);
  if ((directions & set_of(down)) != 0) shoot<down>(from, jumps);
  if ((directions & set_of(right)) != 0) shoot<right>(from, jumps);
  if ((directions & set_of(up)) != 0) shoot<up>(from, jumps);
  if ((directions & set_of(left)) != 0) shoot<left>(from, jumps);
  if ((directions & set_of(down_right)) != 0) sweep<down_right>(from, jumps);
  if ((directions & set_of(up_right)) != 0) sweep<up_right>(from, jumps);
  if ((directions & set_of(up_left)) != 0) sweep<up_left>(from, jumps);
  if ((directions & set_of(down_left)) != 0) sweep<down_left>(from, jumps);
}

template <Direction kStraight>
void JumpGraph::shoot(Cell from, std::vector<Jump>& jumps) const {
  const Cell stop = moved(from, kStraight, boards_->distance_to_stop<kStraight>(from));
  jumps.emplace_back(number_of(stop), static_cast<unsigned>(kStraight) / 2);
}

/// A diagonal run sends out straight ones along its way; where it turns no search has to stop.
template <Direction kDiagonal>
void JumpGraph::sweep(Cell from, std::vector<Jump>& jumps) const {
  constexpr Direction kOne = turned(kDiagonal, -1);
  constexpr Direction kOther = turned(kDiagonal, 1);
  Cell at = from;
  DirectionSet moves = 0;
  do {
    at = moved(at, kDiagonal, boards_->distance_to_diagonal_stop<kDiagonal>(at));
    moves = boards_->moves(at);
    if ((moves & set_of(kOne)) != 0) shoot<kOne>(at, jumps);
    if ((moves & set_of(kOther)) != 0) shoot<kOther>(at, jumps);
  } while ((moves & set_of(kDiagonal)) != 0);
}

}  // namespace wend
