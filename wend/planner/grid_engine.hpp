#pragma once

// GridEngine: a search on the cells of a grid behind a small virtual face, so that a planner can
// choose its parts (space, frontier, priority, duplicate rule) when it is made.

#include <optional>
#include <span>
#include <utility>

#include "wend/base/limits.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/observer.hpp"
#include "wend/search/forward_search.hpp"

namespace wend {

class GridEngine {
 public:
  virtual ~GridEngine() = default;

  /// False if there was no memory: every search ends as out_of_memory.
  virtual bool allocated() const = 0;

  /// `limits` and `observer` (may be null) must live as long as the search.
  virtual void begin(Cell start, std::span<const Cell> goals, const Limits& limits,
                     SearchObserver* observer) = 0;
  virtual SearchOutcome step() = 0;
  virtual SearchOutcome run() = 0;

  virtual const SearchMetrics& metrics() const = 0;

  /// The estimate from a cell to the goals of the search begun last, in cells.
  virtual double heuristic(Cell cell) const = 0;

  /// The path of a search that has found a goal, into memory that is kept.
  virtual void write_path(Path& path) const = 0;
};

/// Passes the events of a search on to a SearchObserver, in cells.
template <class Search>
class ObserverAdapter {
 public:
  using State = typename Search::State;
  using Cost = typename Search::Cost;

  ObserverAdapter(Search& search, SearchObserver& observer)
      : search_(search), observer_(observer) {}

  void on_generate(const State& state, Move arrival, Cost g) {
    observer_.on_generate(event(state, arrival, g));
  }
  void on_expand(const State& state, Move arrival, Cost g) {
    observer_.on_expand(event(state, arrival, g));
  }
  void on_relax(const State& state, Move arrival, Cost g) {
    observer_.on_relax(event(state, arrival, g));
  }

 private:
  SearchEvent event(const State& state, Move arrival, Cost cost) const {
    const double g = static_cast<double>(cost) / Search::SpaceType::kUnitsPerCell;
    std::optional<Cell> parent;
    if (arrival != kNoMove) parent = search_.space().parent(state, arrival).cell;
    return {state.cell, parent, g, search_.priority().h(state.cell),
            search_.priority().f(state.cell, g)};
  }

  Search& search_;
  SearchObserver& observer_;
};

template <class Space, class Frontier, class Priority, DuplicateRule kDuplicates>
class GridEngineOf final : public GridEngine {
 public:
  GridEngineOf(Space space, Priority priority) : search_(std::move(space), std::move(priority)) {}

  bool allocated() const override { return search_.allocated(); }

  void begin(Cell start, std::span<const Cell> goals, const Limits& limits,
             SearchObserver* observer) override {
    search_.priority().goals().assign(goals);
    observer_ = observer;
    const typename Space::State state = search_.space().state(start);
    watched([&](auto&& watcher) { search_.begin({&state, 1}, limits, watcher); });
  }

  SearchOutcome step() override {
    watched([&](auto&& watcher) { search_.step(watcher); });
    return search_.outcome();
  }

  SearchOutcome run() override {
    watched([&](auto&& watcher) { search_.run(watcher); });
    return search_.outcome();
  }

  const SearchMetrics& metrics() const override { return search_.metrics(); }
  double heuristic(Cell cell) const override { return search_.priority().h(cell); }

  void write_path(Path& path) const override {
    path.clear();
    search_.for_each_back_from(search_.goal(), [&](const auto& state) { path.append(state.cell); });
    path.reverse();
  }

 private:
  using Search = ForwardSearch<Space, Frontier, Priority, kDuplicates>;

  /// Runs an action with the observer there is; the loop is compiled once for each case.
  template <class Action>
  void watched(Action&& action) {
    if (observer_ == nullptr) {
      action(NoObserver{});
    } else {
      action(ObserverAdapter<Search>(search_, *observer_));
    }
  }

  Search search_;
  SearchObserver* observer_ = nullptr;
};

}  // namespace wend
