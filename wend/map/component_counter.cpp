#include "wend/map/component_counter.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "wend/map/disjoint_sets.hpp"

namespace wend {

void ComponentCounter::add_row(std::span<const std::uint64_t> words) {
  DisjointSets components(static_cast<std::uint32_t>(open_.size()));
  std::vector<std::size_t> sizes = open_;
  std::vector<LabelledRun> row;
  auto above = above_.begin();
  for_each_run(words, width_, [&](RowRun run) {
    constexpr std::uint32_t kNone = UINT32_MAX;
    std::uint32_t component = kNone;
    while (above != above_.end() && above->run.end <= run.begin) ++above;
    for (auto it = above; it != above_.end() && it->run.begin < run.end; ++it) {
      if (component == kNone) {
        component = it->component;
      } else {
        components.join(it->component, component);
      }
    }
    if (component == kNone) {
      component = components.add();
      sizes.push_back(0);
    }
    sizes[component] += static_cast<std::size_t>(run.end - run.begin);
    row.push_back({run, component});
  });

  std::vector<std::size_t> whole(components.size());  // by root
  for (std::uint32_t i = 0; i < components.size(); ++i) whole[components.root(i)] += sizes[i];
  constexpr std::uint32_t kClosed = UINT32_MAX;
  std::vector<std::uint32_t> numbers(components.size(), kClosed);  // in the new open_, by root
  open_.clear();
  for (LabelledRun& run : row) {
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
