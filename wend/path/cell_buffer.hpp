#pragma once

// CellBuffer: a list of cells that is written anew again and again, and pays for its memory once:
// making room for cells that are to be written costs nothing where there were as many before.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/cell.hpp"

namespace wend {

class CellBuffer {
 public:
  CellBuffer() = default;
  explicit CellBuffer(std::vector<Cell> cells) : memory_(std::move(cells)), size_(memory_.size()) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::span<const Cell> cells() const { return {memory_.data(), size_}; }
  std::span<Cell> cells() { return {memory_.data(), size_}; }

  void clear() { size_ = 0; }
  void append(Cell cell) {
    if (size_ == memory_.size()) {
      memory_.push_back(cell);
    } else {
      memory_[size_] = cell;
    }
    ++size_;
  }

  /// So many cells, whatever stood there before.
  void resize_unset(std::size_t size) {
    if (size > memory_.size()) memory_.resize(size);
    size_ = size;
  }

  friend bool operator==(const CellBuffer& a, const CellBuffer& b) {
    return std::ranges::equal(a.cells(), b.cells());
  }

 private:
  std::vector<Cell> memory_;  // as large as it ever was
  std::size_t size_ = 0;
};

}  // namespace wend
