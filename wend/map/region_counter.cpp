#include "wend/map/region_counter.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace wend {
namespace {

/// Regions by number, some of which turn out to be the same.
class Joined {
 public:
  explicit Joined(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }

  std::size_t add() {
    parents_.push_back(parents_.size());
    return parents_.back();
  }

  std::size_t root(std::size_t region) {
    while (parents_[region] != region) {
      parents_[region] = parents_[parents_[region]];
      region = parents_[region];
    }
    return region;
  }

  void join(std::size_t a, std::size_t b) { parents_[root(a)] = root(b); }

  std::size_t size() const { return parents_.size(); }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace

void RegionCounter::add_row(std::span<const std::uint64_t> words) {
  Joined regions(open_.size());
  std::vector<std::size_t> sizes = open_;
  std::vector<LabelledRun> row;
  auto above = above_.begin();
  for_each_run(words, width_, [&](RowRun run) {
    constexpr auto kNone = static_cast<std::size_t>(-1);
    std::size_t region = kNone;
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
  for (std::size_t i = 0; i < sizes.size(); ++i) whole[regions.root(i)] += sizes[i];
  constexpr auto kClosed = static_cast<std::size_t>(-1);
  std::vector<std::size_t> numbers(regions.size(), kClosed);  // in the new open_, by root
  open_.clear();
  for (LabelledRun& run : row) {
    const std::size_t root = regions.root(run.region);
    if (numbers[root] == kClosed) {
      numbers[root] = open_.size();
      open_.push_back(whole[root]);
    }
    run.region = numbers[root];
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
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
