#include "wend/map/component_tile.hpp"

#include "wend/map/disjoint_sets.hpp"

namespace wend {
namespace {

constexpr std::size_t kMostRuns = std::size_t{ComponentTile::kSize} * ComponentTile::kSize / 2;

/// A run of set bits, as a word in which only they are set.
using Run = std::uint64_t;

/// The lowest run of a word that is not 0. Adding the lowest bit carries over the run.
Run lowest_run(std::uint64_t word) {
  const std::uint64_t lowest = word & (~word + 1);
  return word & ~(word + lowest);
}

/// Sets of runs, in arrays that never grow: the root of a set is its first run.
class RunSets {
 public:
  std::uint16_t add(Run run) {
    runs_[count_] = run;
    parents_[count_] = count_;
    return count_++;
  }

  std::uint16_t root(std::uint16_t run) { return root_in(parents_, run); }
  void join(std::uint16_t a, std::uint16_t b) { join_in(parents_, a, b); }

  Run bits(std::uint16_t run) const { return runs_[run]; }
  std::uint16_t size() const { return count_; }

 private:
  std::uint16_t count_ = 0;
  std::array<Run, kMostRuns> runs_;               // unset beyond count_
  std::array<std::uint16_t, kMostRuns> parents_;  // unset beyond count_
};

/// Adds a link unless it is the last one: neighbouring cells mostly have the same.
void add_link(ComponentTile::Links& links, std::uint32_t from, std::uint32_t to) {
  const std::pair link{static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(to)};
  if (links.empty() || links.back() != link) links.push_back(link);
}

}  // namespace

void ComponentTile::label_cells(const Words& words) {
  words_ = words;
  RunSets sets;
  std::uint16_t above = 0;  // the first run of the row before
  for (std::size_t row = 0; row < words.size(); ++row) {
    const std::uint16_t first = sets.size();
    first_runs_[row] = first;
    for (std::uint64_t rest = words[row]; rest != 0;) {
      const Run run = lowest_run(rest);
      rest &= ~run;
      const std::uint16_t here = sets.add(run);
      // Runs of the row before that end before this one touch none of the next ones either.
      while (above < first && sets.bits(above) < (run & (~run + 1))) ++above;
      for (std::uint16_t i = above; i < first; ++i) {
        if ((sets.bits(i) & run) != 0) {
          sets.join(i, here);
        } else if (sets.bits(i) > run) {
          break;
        }
      }
    }
    above = first;
  }

  labels_.resize(sets.size());
  sizes_.clear();
  for (std::uint16_t run = 0; run < sets.size(); ++run) {
    const std::uint16_t root = sets.root(run);
    if (root == run) sizes_.push_back(0);
    labels_[run] = root == run ? static_cast<std::uint16_t>(sizes_.size()) : labels_[root];
    std::uint16_t& size = sizes_[labels_[run] - std::size_t{1}];
    size = static_cast<std::uint16_t>(size + std::popcount(sets.bits(run)));
  }
}

void ComponentTile::link(const ComponentTile* right, const ComponentTile* above) {
  constexpr unsigned kLast = kSize - 1;
  right_.clear();
  above_.clear();
  for (std::size_t row = 0; right != nullptr && row < words_.size(); ++row) {
    if ((words_[row] >> kLast & right->words_[row] & 1U) == 0) continue;
    add_link(right_, label_at(row, kLast), right->label_at(row, 0));
  }
  if (above == nullptr) return;
  for (std::uint64_t both = words_[kLast] & above->words_[0]; both != 0;) {
    const auto bit = static_cast<unsigned>(std::countr_zero(both));
    add_link(above_, label_at(kLast, bit), above->label_at(0, bit));
    both &= ~lowest_run(both);
  }
}

}  // namespace wend
