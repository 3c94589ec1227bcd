#include "wend/map/component_counter.hpp"

#include <algorithm>

#include "wend/map/disjoint_sets.hpp"

namespace wend {
namespace {

/// Calls join(upper, lower) for every pair of runs in two rows that overlap.
template <class Join>
void for_touching(std::span<const RowRun> upper, std::span<RowRun> lower, Join&& join) {
  std::size_t i = 0;
  for (RowRun& run : lower) {  // NOLINT(misc-const-correctness): join() may change it
    while (i < upper.size() && upper[i].end <= run.begin) ++i;
    for (std::size_t j = i; j < upper.size() && upper[j].begin < run.end; ++j) {
      join(upper[j], run);
    }
  }
}

/// Puts every run of a row into its 4-connected set. The runs of the row above already are in theirs.
void link(std::span<const RowRun> above, std::span<RowRun> row, DisjointSets& sets) {
  for_touching(above, row, [&](const RowRun& upper, RowRun& run) {
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
