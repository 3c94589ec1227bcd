#pragma once

// WholeSearch: what the searches in whole numbers on a CostGrid have in common: the loop, limits, metrics, and the
// events for an observer.
//
// Search derives from it. Its advance() expands one state or ends the search; arrival_of(id) says how a cell was
// reached, for events.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/search/limit_check.hpp"

namespace wend {

/// How a cell was reached, as people see it: costs in cells.
struct CellArrival {
  double g;
  double h;
  std::optional<Cell> parent;
};

template <class Search, class Word, class Units>
class WholeSearch : public GridEngine {
 public:
  SearchOutcome step() final {
    search().advance();
    return outcome_;
  }

  SearchOutcome run() final {
    while (outcome_ == SearchOutcome::running) search().advance();
    return outcome_;
  }

  const SearchMetrics& metrics() const final { return metrics_; }

 protected:
  const CostGrid<Word>& grid() const { return *grid_; }

  SearchOutcome outcome() const { return outcome_; }
  void end(SearchOutcome outcome) { outcome_ = outcome; }

  /// False if there is no memory to search with.
  bool begin_counting(const Limits& limits, SearchObserver* observer) {
    limits_.begin(limits);
    observer_ = observer;
    metrics_ = {};
    outcome_ = search().allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
    return outcome_ == SearchOutcome::running;
  }

  /// Ends the search if a limit forbids the next expansion.
  bool stopped() {
    if (!limits_.due(metrics_.expanded)) return false;
    const SearchOutcome looked = limits_.look(metrics_.expanded);
    if (looked == SearchOutcome::running) return false;
    outcome_ = looked;
    return true;
  }

  void count_expansion(StateId id) {
    ++metrics_.expanded;
    if (observer_ != nullptr) observer_->on_expand(event_of(id));
  }

  /// `again`: the cell had been reached before, at a higher cost.
  void count_reached(StateId id, bool again) {
    metrics_.generated += again ? 0 : 1;
    if (observer_ != nullptr) tell_reached(id, again);
  }

  void count_open(std::size_t open) {
    metrics_.max_frontier = std::max<std::uint64_t>(metrics_.max_frontier, open);
  }

  SearchEvent event_of(StateId id) const {
    const CellArrival arrival = search().arrival_of(id);
    SearchEvent event{{}, {}, arrival.g, arrival.h, arrival.g + arrival.h};
    event.cell = grid_->cell(id);
    event.parent = arrival.parent;
    return event;
  }

  double units_per_cell() const {
    return 2.0 * static_cast<double>(grid_->one()) * Units::kStraight;
  }

 private:
  friend Search;
  explicit WholeSearch(std::shared_ptr<const CostGrid<Word>> grid) : grid_(std::move(grid)) {}

  Search& search() { return static_cast<Search&>(*this); }
  const Search& search() const { return static_cast<const Search&>(*this); }

  [[gnu::noinline]] void tell_reached(StateId id, bool again) {
    if (again) {
      observer_->on_relax(event_of(id));
    } else {
      observer_->on_generate(event_of(id));
    }
  }

  std::shared_ptr<const CostGrid<Word>> grid_;
  LimitCheck limits_;
  SearchObserver* observer_ = nullptr;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
};

}  // namespace wend
