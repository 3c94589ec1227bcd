#include "wend/jump/jump_graph.hpp"

#include <algorithm>
#include <utility>

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
  cells_.reserve(size_after_edits());
  forced_.reserve(size_after_edits());
  for (const Cell cell : cells_) forced_.push_back(forced_at(cell));
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

/// The patch of the word of a cell, made of the numbers that its jump points have.
JumpGraph::Patch& JumpGraph::patch_of(Cell cell) {
  const auto words = board_.words(cell.y);
  const std::size_t word = static_cast<std::size_t>(cell.x + 1) / kWordBits;
  std::uint32_t& before = before_[static_cast<std::size_t>(cell.y) * words.size() + word];
  if ((before & kPatched) == 0) {
    Patch patch;
    patch.fill(kNone);
    std::uint32_t number = before;
    for (std::uint64_t bits = words[word]; bits != 0; bits &= bits - 1) {
      patch[static_cast<std::size_t>(std::countr_zero(bits))] = number++;
    }
    before = static_cast<std::uint32_t>(patches_.size()) | kPatched;
    patches_.push_back(patch);
  }
  return patches_[before & ~kPatched];
}

void JumpGraph::repair(std::span<const CellBox> boxes) {
  for (const CellBox& box : boxes) {
    const CellBox around = box.grown_by(1).clipped_to(*boards_);
    for (int y = around.begin.y; y < around.end.y; ++y) {
      for (int x = around.begin.x; x < around.end.x; ++x) {
        const Cell cell{x, y};
        const bool jumps = boards_->is_jump_point(cell);
        if (jumps != is_jump_point(cell)) {
          Patch& patch = patch_of(cell);
          board_.assign(y, x, jumps);
          std::uint32_t& number = patch[static_cast<std::size_t>(x + 1) % kWordBits];
          if (jumps && number == kNone) {
            number = static_cast<std::uint32_t>(cells_.size());
            cells_.push_back(cell);
            forced_.push_back(0);
          }
        }
        if (jumps) forced_[number_of(cell)] = forced_at(cell);
      }
    }
  }
}

/// The obstacles beside a cell that a path can turn around, for each direction of arrival.
std::uint8_t JumpGraph::forced_at(Cell cell) const {
  unsigned forced = 0;
  for (unsigned arrival = 0; arrival < kArrivals; ++arrival) {
    const auto ahead = static_cast<Direction>(2 * arrival);
    const Cell last = step(cell, ahead, -1);
    if (!boards_->passable(last)) continue;
    for (const int eighths : {2, -2}) {
      const Direction side = turned(ahead, eighths);
      const bool open = boards_->passable(step(cell, side, 1));
      if (!open || boards_->passable(step(last, side, 1))) continue;
      forced |= (eighths > 0 ? 1U : 2U) << (2 * arrival);
    }
  }
  return static_cast<std::uint8_t>(forced);
}

}  // namespace wend
