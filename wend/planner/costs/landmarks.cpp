#include "wend/planner/costs/landmarks.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "wend/planner/costs/cost_field.hpp"

namespace wend {
namespace {

/// The costs from a cell to all others, to each a function; false if they outgrow 32 bits, or the deadline passes.
template <class Units, class Word, class Take>
bool costs_from(const CostGrid<Word>& grid, Cell cell, DeadlineCheck& stop, Take&& take) {
  CostField<std::uint64_t, Word, Units> field(grid);
  if (!field.allocated()) return false;
  const Limits limits = stop.deadline() == nullptr ? Limits() : stop.deadline()->left();
  const SearchOutcome outcome = field.run({&cell, 1}, limits);
  if (outcome != SearchOutcome::exhausted) {
    stop.now();
    return false;
  }
  if (field.bound() > std::numeric_limits<std::uint32_t>::max()) return false;
  for (int y = 0; y < grid.height(); ++y) {
    if (stop.now()) return false;
    for (int x = 0; x < grid.width(); ++x) {
      if (field.reached({x, y})) take(Cell{x, y}, static_cast<std::uint32_t>(field.units({x, y})));
    }
  }
  return true;
}

template <class Word, class Take>
bool costs_on(const CostGrid<Word>& grid, Cell cell, DeadlineCheck& stop, Take&& take) {
  if constexpr (sizeof(Word) == sizeof(std::uint32_t)) {
    if (grid.one() == 1) return costs_from<OctileUnits<std::uint32_t>>(grid, cell, stop, take);
    if (CostField<std::uint64_t, Word, CostUnits>::suits(grid)) {
      return costs_from<CostUnits>(grid, cell, stop, take);
    }
  }
  return false;
}

template <class Word>
std::optional<Cell> first_free_cell(const CostGrid<Word>& grid) {
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.word(grid.number({x, y})) != 0) return Cell{x, y};
    }
  }
  return std::nullopt;
}

}  // namespace

template <class Word>
std::shared_ptr<const Landmarks> Landmarks::make(const CostGrid<Word>& grid, unsigned count,
                                                 DeadlineCheck& stop) {
  auto made = std::make_shared<Landmarks>();
  const auto first = first_free_cell(grid);
  if (!first || count == 0) return made;
  // By cell: how far the nearest landmark is. At first, how far the first cell is, which is none.
  std::vector<std::uint32_t> nearest(grid.state_count(), 0);
  if (stop.now()) return made;
  Cell next = *first;
  if (!costs_on(grid, *first, stop,
                [&](Cell cell, std::uint32_t cost) { nearest[grid.number(cell)] = cost; })) {
    return made;
  }
  made->costs_.reserve(std::size_t{grid.state_count()} * count);
  while (made->costs_.size() < made->costs_.capacity() && !stop.now()) {
    constexpr std::size_t kAtOnce = std::size_t{1} << 18U;
    made->costs_.resize(std::min(made->costs_.size() + kAtOnce, made->costs_.capacity()),
                        kUnreached);
  }
  if (stop.has_passed()) return made;
  for (unsigned i = 0; i < count; ++i) {
    const auto farthest = std::ranges::max_element(nearest);
    next = grid.cell(static_cast<StateId>(farthest - nearest.begin()));
    if (i == 0) {
      std::ranges::replace_if(nearest, [](std::uint32_t cost) { return cost > 0; }, kUnreached);
    }
    const bool done = costs_on(grid, next, stop, [&](Cell cell, std::uint32_t cost) {
      const StateId id = grid.number(cell);
      made->costs_[id * std::size_t{count} + i] = cost;
      nearest[id] = std::min(nearest[id], cost);
    });
    if (!done) break;
    made->count_ = i + 1;
  }
  if (made->count_ < count) made->count_ = 0;
  return made;
}

Landmarks::Bounds::Bounds(std::shared_ptr<const Landmarks> landmarks, StateId start, StateId goal)
    : landmarks_(std::move(landmarks)),
      costs_(landmarks_->costs_.data()),
      stride_(landmarks_->count_) {
  // The best ones so far, the best first.
  std::array<std::uint32_t, kMost> best{};
  for (std::size_t i = 0; i < stride_; ++i) {
    const std::uint32_t here = costs_[start * stride_ + i];
    const std::uint32_t there = costs_[goal * stride_ + i];
    // Another component: it says nothing about this one.
    if (here == kUnreached || there == kUnreached) continue;
    const std::uint32_t bound = here > there ? here - there : there - here;
    std::size_t place = used_;
    while (place > 0 && best[place - 1] < bound) --place;
    if (place == kMost) continue;
    used_ = std::min(used_ + 1, kMost);
    for (std::size_t later = used_ - 1; later > place; --later) {
      best[later] = best[later - 1];
      which_[later] = which_[later - 1];
    }
    best[place] = bound;
    which_[place] = i;
  }
  for (std::size_t i = 0; i < used_; ++i) at_goal_[i] = costs_[goal * stride_ + which_[i]];
}

template std::shared_ptr<const Landmarks> Landmarks::make(const CostGrid<std::uint32_t>&, unsigned,
                                                          DeadlineCheck&);
template std::shared_ptr<const Landmarks> Landmarks::make(const CostGrid<std::uint64_t>&, unsigned,
                                                          DeadlineCheck&);

}  // namespace wend
