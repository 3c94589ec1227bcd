#include "wend/map/region_counter.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "wend/map/disjoint_sets.hpp"

namespace wend {

void RegionCounter::add_row(std::span<const std::uint64_t> words) {
  DisjointSets regions(static_cast<std::uint32_t>(open_.size()));
  std::vector<std::size_t> sizes = open_;
  std::vector<LabelledRun> row;
  auto above = above_.begin();
  for_each_run(words, width_, [&](RowRun run) {
    constexpr std::uint32_t kNone = UINT32_MAX;
    std::uint32_t region = kNone;
    while (above != above_.end() && above->run.end <= run.begin) ++above;
    for (auto it = above; it != above_.end() && it->run.begin < run.end; ++it) {
      if (region == kNone) {
        region = it->region;
      } else {
        regions.join(it->region, region);
      }
    }
    if (region == kNone) {
      region = regions.add();
      sizes.push_back(0);
    }
    sizes[region] += static_cast<std::size_t>(run.end - run.begin);
    row.push_back({run, region});
  });

  std::vector<std::size_t> whole(regions.size());  // by root
  for (std::uint32_t i = 0; i < regions.size(); ++i) whole[regions.root(i)] += sizes[i];
  constexpr std::uint32_t kClosed = UINT32_MAX;
  std::vector<std::uint32_t> numbers(regions.size(), kClosed);  // in the new open_, by root
  open_.clear();
  for (LabelledRun& run : row) {
    const std::uint32_t root = regions.root(run.region);
    if (numbers[root] == kClosed) {
      numbers[root] = static_cast<std::uint32_t>(open_.size());
      open_.push_back(whole[root]);
    }
    run.region = numbers[root];
  }
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    if (regions.root(i) != i || numbers[i] != kClosed) continue;
    ++closed_;
    largest_closed_ = std::max(largest_closed_, whole[i]);
  }
  above_ = std::move(row);
}

std::size_t RegionCounter::largest() const {
  std::size_t largest = largest_closed_;
  for (const std::size_t size : open_) largest = std::max(largest, size);
  return largest;
}

}  // namespace wend
