#include "wend/map/connected_components.hpp"

#include <functional>
#include <numeric>

namespace wend {
namespace {

/// Union-find with path halving. The smaller root wins, so that sets are numbered in the order in which
/// they were added. Almost O(1) for each call.
class DisjointSets {
 public:
  /// `count` sets of one element each.
  explicit DisjointSets(std::uint32_t count = 0) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
  }

  std::uint32_t add() {
    parents_.push_back(static_cast<std::uint32_t>(parents_.size()));
    return parents_.back();
  }

  std::uint32_t root(std::uint32_t set) {
    while (parents_[set] != set) {
      parents_[set] = parents_[parents_[set]];
      set = parents_[set];
    }
    return set;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

  std::size_t size() const { return parents_.size(); }

  /// A number for every set: 0, 1, 2, ... in the order of their roots.
  std::vector<std::uint32_t> numbered() {
    std::vector<std::uint32_t> numbers(size());
    std::uint32_t next = 0;
    for (std::uint32_t set = 0; set < size(); ++set) {
      const std::uint32_t its_root = root(set);
      numbers[set] = its_root == set ? next++ : numbers[its_root];
    }
    return numbers;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

/// The runs of all rows, one row after the other.
struct Runs {
  std::vector<RowRun> runs;
  std::vector<std::size_t> row_begins{0};

  std::span<RowRun> row(int y) {
    const auto row = static_cast<std::size_t>(y);
    return std::span(runs).subspan(row_begins[row], row_begins[row + 1] - row_begins[row]);
  }
};

Runs runs_of(const BitGrid& cells) {
  const int width = cells.width();
  Runs all;
  for (int y = 0; y < cells.height(); ++y) {
    for_each_run(cells.row_words(y), width, [&](RowRun run) { all.runs.push_back(run); });
    all.row_begins.push_back(all.runs.size());
  }
  return all;
}

/// Calls join(upper, lower) for every pair of runs in two rows that overlap once they are extended by
/// `slack` cells in total.
template <class Join>
void for_touching(std::span<const RowRun> upper, std::span<RowRun> lower, int slack, Join&& join) {
  std::size_t i = 0;
  for (RowRun& run : lower) {  // NOLINT(misc-const-correctness): join() may change it
    while (i < upper.size() && upper[i].end + slack <= run.begin) ++i;
    for (std::size_t j = i; j < upper.size() && upper[j].begin < run.end + slack; ++j) {
      join(upper[j], run);
    }
  }
}

/// Puts every run of a row into its 4-connected set. The runs of the row above already are in theirs.
void link(std::span<const RowRun> above, std::span<RowRun> row, DisjointSets& sets) {
  for_touching(above, row, 0, [&](const RowRun& upper, RowRun& run) {
    if (run.component == RowRun::kNoComponent) {
      run.component = upper.component;
    } else {
      sets.join(run.component, upper.component);
    }
  });
  for (RowRun& run : row) {
    if (run.component == RowRun::kNoComponent) run.component = sets.add();
  }
}

}  // namespace

ConnectedComponents::ConnectedComponents(const BitGrid& cells)
    : labels_(cells.width(), cells.height()) {
  const int height = cells.height();
  Runs runs = runs_of(cells);
  DisjointSets run_sets;
  for (int y = 0; y < height; ++y) {
    link(y > 0 ? runs.row(y - 1) : std::span<RowRun>(), runs.row(y), run_sets);
  }
  const std::vector<std::uint32_t> numbers = run_sets.numbered();

  for (int y = 0; y < height; ++y) {
    const auto labels = labels_.row(y);
    for (RowRun& run : runs.row(y)) {
      run.component = numbers[run.component] + 1;  // 0 is for cells that are not set
      if (run.component >= sizes_.size()) sizes_.resize(run.component + std::size_t{1});
      sizes_[run.component] += static_cast<std::size_t>(run.end - run.begin);
      std::fill(labels.begin() + run.begin, labels.begin() + run.end, run.component);
    }
  }

  DisjointSets label_sets(static_cast<std::uint32_t>(sizes_.size()));
  for (int y = 1; y < height; ++y) {
    for_touching(runs.row(y - 1), runs.row(y), 1, [&](const RowRun& a, const RowRun& b) {
      label_sets.join(a.component, b.component);
    });
  }
  merged_ = label_sets.numbered();
  merged_sizes_.assign(merged_.size(), 0);
  for (std::size_t label = 0; label < sizes_.size(); ++label) {
    merged_sizes_[merged_[label]] += sizes_[label];
  }
  merged_sizes_.resize(*std::max_element(merged_.begin(), merged_.end()) + std::size_t{1});
}

std::size_t ConnectedComponents::count(Adjacency adjacency) const {
  return (adjacency == Adjacency::edges ? sizes_ : merged_sizes_).size() - 1;
}

std::vector<std::size_t> ConnectedComponents::sizes(Adjacency adjacency) const {
  std::vector<std::size_t> sizes = adjacency == Adjacency::edges ? sizes_ : merged_sizes_;
  sizes.erase(sizes.begin());
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return sizes;
}

void ComponentCounter::add_row(std::span<const std::uint64_t> words) {
  std::vector<RowRun> row;
  for_each_run(words, width_, [&](RowRun run) { row.push_back(run); });
  DisjointSets components(static_cast<std::uint32_t>(open_.size()));
  link(above_, row, components);
  std::vector<std::size_t> sizes = open_;
  sizes.resize(components.size());
  for (const RowRun& run : row) {
    sizes[run.component] += static_cast<std::size_t>(run.end - run.begin);
  }

  std::vector<std::size_t> whole(components.size());  // by root
  for (std::uint32_t i = 0; i < components.size(); ++i) whole[components.root(i)] += sizes[i];
  constexpr std::uint32_t kClosed = UINT32_MAX;
  std::vector<std::uint32_t> numbers(components.size(), kClosed);  // in the new open_, by root
  open_.clear();
  for (RowRun& run : row) {
    const std::uint32_t root = components.root(run.component);
    if (numbers[root] == kClosed) {
      numbers[root] = static_cast<std::uint32_t>(open_.size());
      open_.push_back(whole[root]);
    }
    run.component = numbers[root];
  }
  for (std::uint32_t i = 0; i < components.size(); ++i) {
    if (components.root(i) != i || numbers[i] != kClosed) continue;
    ++closed_;
    largest_closed_ = std::max(largest_closed_, whole[i]);
  }
  above_ = std::move(row);
}

std::size_t ComponentCounter::largest() const {
  std::size_t largest = largest_closed_;
  for (const std::size_t size : open_) largest = std::max(largest, size);
  return largest;
}

}  // namespace wend
