#pragma once

// SearchEngine: a search behind a small virtual face, so that a planner can choose its parts
// (space, frontier, priority, duplicate rule) when it is made.
//
// Place is how a planner names a state, Goal how it names where a path may end. Names<Space> says
// which place a state is, what an observer is told of it, and what it adds to a path.

#include <optional>
#include <span>
#include <utility>

#include "wend/base/limits.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/observer.hpp"
#include "wend/search/forward_search.hpp"

namespace wend {

template <class PlaceType, class GoalType>
class SearchEngine {
 public:
  using Place = PlaceType;
  using Goal = GoalType;

  virtual ~SearchEngine() = default;

  /// False if there was no memory: every search ends as out_of_memory.
  virtual bool allocated() const = 0;

  /// `limits` and `observer` (may be null) must live as long as the search.
  virtual void begin(const Place& start, std::span<const Goal> goals, const Limits& limits,
                     SearchObserver* observer) = 0;
  virtual SearchOutcome step() = 0;
  virtual SearchOutcome run() = 0;

  virtual const SearchMetrics& metrics() const = 0;

  /// The estimate from a place to the goals of the search begun last.
  virtual double heuristic(const Place& place) const = 0;

  /// The path of a search that has found a goal, into memory that is kept.
  virtual void write_path(Path& path) const = 0;
};

/// Passes the events of a search on to a SearchObserver.
template <class Search, class Names>
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
    const auto& space = search_.space();
    const auto place = Names::place(state);
    const double g = static_cast<double>(cost) / Search::SpaceType::kUnitsPerCell;
    SearchEvent event{{}, {}, g, search_.priority().h(place), search_.priority().f(place, g)};
    Names::tell_place(event, space, place);
    if (arrival != kNoMove) {
      Names::tell_parent(event, space, Names::place(space.parent(state, arrival)));
    }
    return event;
  }

  Search& search_;
  SearchObserver& observer_;
};

template <class Engine, class Names, class Space, class Frontier, class Priority,
          DuplicateRule kDuplicates>
class SearchEngineOf final : public Engine {
 public:
  using Place = typename Engine::Place;
  using Goal = typename Engine::Goal;

  SearchEngineOf(Space space, Priority priority) : search_(std::move(space), std::move(priority)) {}

  bool allocated() const override { return search_.allocated() && search_.priority().allocated(); }

  void begin(const Place& start, std::span<const Goal> goals, const Limits& limits,
             SearchObserver* observer) override {
    search_.priority().begin(goals, limits);
    observer_ = observer;
    const typename Space::State state = search_.space().state(start);
    watched([&](auto&& watcher) { search_.begin({&state, 1}, limits, watcher); });
  }

  SearchOutcome step() override {
    watched([&](auto&& watcher) { search_.step(watcher); });
    return outcome();
  }

  SearchOutcome run() override {
    watched([&](auto&& watcher) { search_.run(watcher); });
    return outcome();
  }

  const SearchMetrics& metrics() const override { return search_.metrics(); }
  double heuristic(const Place& place) const override { return search_.priority().h(place); }

  void write_path(Path& path) const override {
    path.clear();
    search_.for_each_back_from(search_.goal(), [&](const auto& state) {
      Names::append(path, search_.space(), Names::place(state));
    });
    path.reverse();
  }

 private:
  using Search = ForwardSearch<Space, Frontier, Priority, kDuplicates>;

  /// A search whose estimates were broken off has found nothing that holds.
  SearchOutcome outcome() const { return search_.priority().stopped().value_or(search_.outcome()); }

  /// Runs an action with the observer there is; the loop is compiled once for each case.
  template <class Action>
  void watched(Action&& action) {
    if (observer_ == nullptr) {
      action(NoObserver{});
    } else {
      action(ObserverAdapter<Search, Names>(search_, *observer_));
    }
  }

  Search search_;
  SearchObserver* observer_ = nullptr;
};

}  // namespace wend
