#include "wend/map/connected_components.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <optional>
#include <utility>

#include "wend/map/disjoint_sets.hpp"

namespace wend {
namespace {

constexpr std::size_t kSize = ComponentTile::kSize;

/// The words of a tile; rows beyond the map have no set cells.
ComponentTile::Words words_of(const BitGrid& cells, std::size_t column, std::size_t row) {
  ComponentTile::Words words{};
  const std::size_t first = row * kSize;
  const std::size_t count = std::min(kSize, static_cast<std::size_t>(cells.height()) - first);
  for (std::size_t i = 0; i < count; ++i) {
    words[i] = cells.row_words(static_cast<int>(first + i))[column];
  }
  return words;
}

/// The cells beside the set ones of two rows of which only one is set in each: they touch at corners.
struct CornerPairs {
  std::uint64_t rising;   // bit b of the lower row and b + 1 of the upper one
  std::uint64_t falling;  // bit b + 1 of the lower row and b of the upper one

  /// `lower` and `upper` are words of the rows, the others the same words one bit farther on.
  CornerPairs(std::uint64_t lower, std::uint64_t lower_on, std::uint64_t upper,
              std::uint64_t upper_on)
      : rising(lower & upper_on & ~lower_on & ~upper),
        falling(lower_on & upper & ~lower & ~upper_on) {}
};

}  // namespace

ConnectedComponents::ConnectedComponents(const BitGrid& cells, DeadlineCheck& stop)
    : columns_(cells.row_words(0).size()),
      rows_((static_cast<std::size_t>(cells.height()) + kSize - 1) / kSize),
      tiles_(columns_ * rows_) {
  for (std::size_t tile = 0; tile < tiles_.size() && !stop.now(); ++tile) {
    tiles_[tile].label_cells(words_of(cells, tile % columns_, tile / columns_));
  }
  for (std::size_t tile = 0; tile < tiles_.size() && !stop.now(); ++tile) link_to_next(tile);
  count_labels();
}

bool ConnectedComponents::prepare(Adjacency adjacency, DeadlineCheck& stop) const {
  const auto unless_stopped = [&](Numbers made) -> std::optional<Numbers> {
    if (stop.has_passed()) return std::nullopt;
    return made;
  };
  const auto edges = [&] { return unless_stopped(joined_over_edges(stop)); };
  if (joined_.try_get(edges) == nullptr) return false;
  if (adjacency == Adjacency::edges) return true;
  return merged_.try_get([&] { return unless_stopped(joined_over_corners(stop)); }) != nullptr;
}

void ConnectedComponents::repair(const BitGrid& cells, const CellBox& box) {
  if (box.empty()) return;
  const std::size_t first = tile_of(box.begin);
  const std::size_t last = tile_of({box.end.x - 1, box.end.y - 1});
  bool changed = false;
  for (std::size_t row = first / columns_; row <= last / columns_; ++row) {
    for (std::size_t column = first % columns_; column <= last % columns_; ++column) {
      const std::size_t tile = row * columns_ + column;
      const auto words = words_of(cells, column, row);
      if (words == tiles_[tile].words()) continue;
      tiles_[tile].label_cells(words);
      changed = true;
    }
  }
  if (!changed) return;
  const std::size_t first_row = first / columns_ - (first / columns_ > 0 ? 1 : 0);
  const std::size_t first_column = first % columns_ - (first % columns_ > 0 ? 1 : 0);
  for (std::size_t row = first_row; row <= last / columns_; ++row) {
    for (std::size_t column = first_column; column <= last % columns_; ++column) {
      link_to_next(row * columns_ + column);
    }
  }
  count_labels();
  joined_.reset();
  merged_.reset();
}

void ConnectedComponents::link_to_next(std::size_t tile) {
  const bool last_column = tile % columns_ + 1 == columns_;
  const bool last_row = tile / columns_ + 1 == rows_;
  tiles_[tile].link(last_column ? nullptr : &tiles_[tile + 1],
                    last_row ? nullptr : &tiles_[tile + columns_]);
}

void ConnectedComponents::count_labels() {
  labels_ = 0;
  for (ComponentTile& tile : tiles_) {
    tile.set_first_label(labels_ - 1);  // modulo 2^32: labels begin at 1
    labels_ += tile.label_count();
  }
}

ConnectedComponents::Numbers ConnectedComponents::joined_over_edges(DeadlineCheck& stop) const {
  DisjointSets sets(labels_);
  for (std::size_t i = 0; i < tiles_.size() && !stop.now(); ++i) {
    const ComponentTile& tile = tiles_[i];
    const auto join = [&](const ComponentTile::Links& links, std::size_t next) {
      for (const auto& [from, to] : links) {
        sets.join(tile.first_label() + from, tiles_[next].first_label() + to);
      }
    };
    join(tile.right(), i + 1);
    join(tile.above(), i + columns_);
  }
  Numbers numbers;
  if (stop.has_passed()) return numbers;
  numbers.of_label = sets.numbered();
  for (std::uint32_t& number : numbers.of_label) ++number;
  for (const ComponentTile& tile : tiles_) {
    std::uint32_t label = tile.first_label();
    for (const std::uint16_t size : tile.sizes()) {
      const std::uint32_t number = numbers.of_label[++label];
      if (number >= numbers.sizes.size()) numbers.sizes.resize(number + std::size_t{1});
      numbers.sizes[number] += size;
    }
  }
  return numbers;
}

ConnectedComponents::Numbers ConnectedComponents::joined_over_corners(DeadlineCheck& stop) const {
  const Numbers& edges = numbers(Adjacency::edges);
  DisjointSets sets(static_cast<std::uint32_t>(edges.sizes.size()));
  // A cell by the tile of a word and a bit counted from there, which may be the next tile's first.
  const auto component = [&](std::size_t column, std::size_t y, unsigned bit) {
    const ComponentTile& tile = tiles_[y / kSize * columns_ + column + bit / kSize];
    const std::uint32_t label = tile.label_at(y % kSize, bit % kSize);
    return edges.of_label[tile.first_label() + label];
  };
  for (std::size_t y = 0; y + 1 < rows_ * kSize && !stop.now(); ++y) {
    const auto word = [&](std::size_t column, std::size_t row) {
      return column < columns_ ? tiles_[row / kSize * columns_ + column].words()[row % kSize] : 0;
    };
    for (std::size_t column = 0; column < columns_; ++column) {
      const auto one_on = [&](std::size_t row) {
        return word(column, row) >> 1U | word(column + 1, row) << (kSize - 1);
      };
      const CornerPairs pairs(word(column, y), one_on(y), word(column, y + 1), one_on(y + 1));
      for (std::uint64_t bits = pairs.rising; bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(bits));
        sets.join(component(column, y, bit), component(column, y + 1, bit + 1));
      }
      for (std::uint64_t bits = pairs.falling; bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(bits));
        sets.join(component(column, y, bit + 1), component(column, y + 1, bit));
      }
    }
  }
  const std::vector<std::uint32_t> merged = sets.numbered();
  Numbers numbers;
  numbers.of_label = edges.of_label;
  for (std::uint32_t& number : numbers.of_label) number = merged[number];
  numbers.sizes.assign(*std::ranges::max_element(merged) + std::size_t{1}, 0);
  for (std::size_t i = 0; i < merged.size(); ++i) numbers.sizes[merged[i]] += edges.sizes[i];
  return numbers;
}

std::vector<std::size_t> ConnectedComponents::sizes(Adjacency adjacency) const {
  std::vector<std::size_t> sizes = numbers(adjacency).sizes;
  sizes.erase(sizes.begin());
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return sizes;
}

}  // namespace wend
