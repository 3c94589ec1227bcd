#pragma once

// SearchEngine: a search behind a small virtual interface, so that a planner can choose its parts
// (space, frontier, priority, duplicate rule) when it is made.
//
// Place is a planner's name of a state, Goal its name of the end of a path. Names<Space> maps a
// state to its place, to the events for an observer, and to its part of a path.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "wend/base/limits.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/observer.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"

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

  /// About how many nanoseconds the search has taken so far, from what it has counted.
  virtual std::uint64_t time_taken() const { return 32 * metrics().expanded; }

  /// Is it only asked for paths that there are? Of an engine that does not end without one, or keeps what it searched for
  /// the next query.
  virtual bool expects_a_path() const { return false; }

  /// At most `most` states that would be expanded next, and the number of open states.
  virtual OpenList open_list(std::size_t most) const = 0;

  /// The estimate from a place to the goals of the search begun last.
  virtual double heuristic(const Place& place) const = 0;

  /// The path of a search that has found a goal, into memory that is kept.
  virtual void write_path(Path& path) const = 0;

  /// Lets go of the FreeSpace, so that an edit need not copy it, and keeps its memory for adopt(). False: it can not, and
  /// must go.
  virtual bool release() { return false; }
  /// After release(): takes the FreeSpace as it is after an edit.
  virtual void adopt(const FreeSpace& /*space*/) {}

  /// What an anytime search has proven: the path costs at most this times the least cost. Unset for engines
  /// whose parts say it.
  virtual std::optional<double> bound() const { return std::nullopt; }
};

/// A state of a search, as it was reached at that cost.
template <class Names, class Search>
SearchEvent event_of(const Search& search, const typename Search::State& state,
                     typename Search::Arrival arrival, typename Search::Cost cost) {
  const auto& space = search.space();
  const auto place = Names::place(state);
  const double g = static_cast<double>(cost) / Search::SpaceType::kUnitsPerCell;
  SearchEvent event{{}, {}, g, search.priority().h(place), search.priority().f(place, g)};
  Names::tell_place(event, space, place);
  if (arrival != Search::kNoArrival) {
    Names::tell_parent(event, space, Names::place(search.parent(state, arrival)));
  }
  return event;
}

/// What orders a key behind the one that comes before it.
template <class Key>
OpenTie tie_between(const Key& before, const Key& key) {
  if constexpr (!std::is_same_v<Key, NoKey>) {
    if constexpr (requires { Key::kOrderIsChosen; }) {
      return f_of(before) < f_of(key) ? OpenTie::none : OpenTie::chosen;
    }
    if (!(before < key)) return OpenTie::newest;
    if (!(f_of(before) < f_of(key))) return OpenTie::g;
  }
  return OpenTie::none;
}

/// At most `most` states that the search would expand next.
template <class Names, class Search>
OpenList open_list_of(const Search& search, std::size_t most) {
  using Key = typename Search::Key;
  OpenList list{{}, search.open_count()};
  std::optional<Key> before;
  search.for_each_open(most, [&](const typename Search::State& state, const Key& key) {
    const StateId id = search.space().id(state);
    list.entries.push_back({event_of<Names>(search, state, search.arrival(id), search.g(id)),
                            before ? tie_between(*before, key) : OpenTie::none});
    before = key;
  });
  return list;
}

/// Passes the events of a search on to a SearchObserver.
template <class Search, class Names>
class ObserverAdapter {
 public:
  using State = typename Search::State;
  using Cost = typename Search::Cost;
  using Arrival = typename Search::Arrival;

  ObserverAdapter(Search& search, SearchObserver& observer)
      : search_(search), observer_(observer) {}

  void on_generate(const State& state, Arrival arrival, Cost g) {
    observer_.on_generate(event(state, arrival, g));
  }
  void on_expand(const State& state, Arrival arrival, Cost g) {
    observer_.on_expand(event(state, arrival, g));
  }
  void on_relax(const State& state, Arrival arrival, Cost g) {
    observer_.on_relax(event(state, arrival, g));
  }

 private:
  SearchEvent event(const State& state, Arrival arrival, Cost cost) const {
    return event_of<Names>(search_, state, arrival, cost);
  }

  Search& search_;
  SearchObserver& observer_;
};

/// A ForwardSearch behind the interface of a SearchEngine. In rounds, run() ends with SearchOutcome::improved at each
/// better path or bound; the next run() or step() goes on.
template <class Engine, class Names, class Space, class Frontier, class Priority,
          DuplicateRule kDuplicates, class Links = StepLinks,
          template <class> class Store = DenseNodes>
class SearchEngineOf final : public Engine {
 public:
  using Place = typename Engine::Place;
  using Goal = typename Engine::Goal;

  /// In rounds, with AnytimeWeights.
  template <class... Weights>
  SearchEngineOf(Space space, Priority priority, Weights... weights)
      : search_(std::move(space), std::move(priority), weights...) {}

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

  std::uint64_t time_taken() const override {
    constexpr bool kLooksForParents = !std::is_same_v<Links, StepLinks>;
    return (Search::kInRounds || kLooksForParents ? 400 : 32) * search_.metrics().expanded;
  }

  const SearchMetrics& metrics() const override { return search_.metrics(); }
  OpenList open_list(std::size_t most) const override { return open_list_of<Names>(search_, most); }
  double heuristic(const Place& place) const override { return search_.priority().h(place); }

  void write_path(Path& path) const override {
    path.clear();
    search_.for_each_back_from(search_.goal(), [&](const auto& state) {
      Names::append(path, search_.space(), Names::place(state));
    });
    path.reverse();
  }

  bool release() override {
    if constexpr (kFollowsEdits) search_.space().release();
    return kFollowsEdits;
  }
  void adopt(const FreeSpace& space) override {
    if constexpr (kFollowsEdits) search_.space().update(space);
  }

  std::optional<double> bound() const override {
    if constexpr (Search::kInRounds) {
      return search_.bound();
    } else {
      return std::nullopt;
    }
  }

 private:
  using Search = ForwardSearch<Space, Frontier, Priority, kDuplicates, Links, Store>;
  static constexpr bool kFollowsEdits =
      requires(Space space, const FreeSpace& other) { space.update(other); };

  /// Runs an action with the observer there is; the loop is compiled once for each case.
  template <class Action>
  void watched(Action&& action) {
    if (observer_ == nullptr) {
      action(NoObserver{});
    } else {
      action(ObserverAdapter<Search, Names>(search_, *observer_));
    }
  }

  /// A search whose estimates were broken off has found nothing that holds; one in rounds heeds that, and keeps what
  /// it found before.
  SearchOutcome outcome() const {
    if constexpr (Search::kInRounds) {
      return search_.outcome();
    } else {
      return search_.priority().stopped().value_or(search_.outcome());
    }
  }

  Search search_;
  SearchObserver* observer_ = nullptr;
};

/// The engine of an anytime planner.
template <class Engine, class Names, class Space, class Priority, class Links = StepLinks,
          template <class> class Store = DenseNodes>
using AnytimeEngineOf = SearchEngineOf<Engine, Names, Space, HeapFrontier<typename Priority::Key>,
                                       Priority, DuplicateRule::in_rounds, Links, Store>;

}  // namespace wend
