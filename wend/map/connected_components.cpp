#include "wend/map/connected_components.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "wend/map/disjoint_sets.hpp"
#include "wend/map/row_runs.hpp"

namespace wend {
namespace {

constexpr std::uint32_t kNoSet = UINT32_MAX;

/// Set cells [begin, end) of one row.
struct Run {
  int begin;
  int end;
  std::uint32_t set = kNoSet;
};

/// The runs of all rows, one row after the other.
struct Runs {
  std::vector<Run> runs;
  std::vector<std::size_t> row_begins{0};

  std::span<Run> row(int y) {
    const auto row = static_cast<std::size_t>(y);
    return std::span(runs).subspan(row_begins[row], row_begins[row + 1] - row_begins[row]);
  }
};

Runs runs_of(const BitGrid& cells) {
  const int width = cells.width();
  Runs all;
  for (int y = 0; y < cells.height(); ++y) {
    for_each_run(cells.row_words(y), width,
                 [&](RowRun run) { all.runs.push_back({run.begin, run.end}); });
    all.row_begins.push_back(all.runs.size());
  }
  return all;
}

/// Calls join(upper, lower) for every pair of runs of two rows that overlap, once both are
/// stretched by `slack` cells together.
template <class Join>
void for_touching(std::span<const Run> upper, std::span<Run> lower, int slack, Join&& join) {
  std::size_t i = 0;
  for (auto&& run : lower) {
    while (i < upper.size() && upper[i].end + slack <= run.begin) ++i;
    for (std::size_t j = i; j < upper.size() && upper[j].begin < run.end + slack; ++j) {
      join(upper[j], run);
    }
  }
}

/// Puts every run into its 4-connected set.
void link(Runs& runs, int height, DisjointSets& sets) {
  for (int y = 0; y < height; ++y) {
    if (y > 0) {
      for_touching(runs.row(y - 1), runs.row(y), 0, [&](const Run& upper, Run& run) {
        if (run.set == kNoSet) {
          run.set = upper.set;
        } else {
          sets.join(run.set, upper.set);
        }
      });
    }
    for (Run& run : runs.row(y)) {
      if (run.set == kNoSet) run.set = sets.add();
    }
  }
}

}  // namespace

ConnectedComponents::ConnectedComponents(const BitGrid& cells)
    : labels_(cells.width(), cells.height()) {
  const int height = cells.height();
  Runs runs = runs_of(cells);
  DisjointSets run_sets;
  link(runs, height, run_sets);
  const std::vector<std::uint32_t> numbers = run_sets.numbered();

  for (int y = 0; y < height; ++y) {
    const auto labels = labels_.row(y);
    for (Run& run : runs.row(y)) {
      run.set = numbers[run.set] + 1;  // 0 is for cells that are not set
      if (run.set >= sizes_.size()) sizes_.resize(run.set + std::size_t{1});
      sizes_[run.set] += static_cast<std::size_t>(run.end - run.begin);
      std::fill(labels.begin() + run.begin, labels.begin() + run.end, run.set);
    }
  }

  DisjointSets label_sets;
  while (label_sets.size() < sizes_.size()) label_sets.add();
  for (int y = 1; y < height; ++y) {
    for_touching(runs.row(y - 1), runs.row(y), 1,
                 [&](const Run& a, const Run& b) { label_sets.join(a.set, b.set); });
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

}  // namespace wend
