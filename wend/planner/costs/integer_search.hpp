#pragma once

// IntegerSearch: what the searches in whole numbers on a CostGrid have in common: limits, metrics, and the events for
// an observer. Each has its own loop.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "wend/planner/grid/grid_planner.hpp"
#include "wend/search/limit_check.hpp"

namespace wend {

/// How a cell was reached, as people see it: costs in cells.
struct CellArrival {
  Cell cell;
  double g;
  double h;
  std::optional<Cell> parent;
};

class IntegerSearch : public GridEngine {
 public:
  const SearchMetrics& metrics() const final { return metrics_; }

 protected:
  SearchOutcome outcome() const { return outcome_; }
  void end(SearchOutcome outcome) { outcome_ = outcome; }

  /// False if there is no memory to search with.
  bool begin_counting(const Limits& limits, SearchObserver* observer) {
    limits_.begin(limits);
    observer_ = observer;
    metrics_ = {};
    outcome_ = allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
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
    const CellArrival arrival = arrival_of(id);
    SearchEvent event{{}, {}, arrival.g, arrival.h, arrival.g + arrival.h};
    event.cell = arrival.cell;
    event.parent = arrival.parent;
    return event;
  }

 private:
  virtual CellArrival arrival_of(StateId id) const = 0;

  [[gnu::noinline]] void tell_reached(StateId id, bool again) {
    if (again) {
      observer_->on_relax(event_of(id));
    } else {
      observer_->on_generate(event_of(id));
    }
  }

  LimitCheck limits_;
  SearchObserver* observer_ = nullptr;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
};

}  // namespace wend
