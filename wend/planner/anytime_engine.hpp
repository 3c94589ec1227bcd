#pragma once

// AnytimeEngineOf: an AnytimeSearch behind the interface of a SearchEngine. Its run() ends with
// SearchOutcome::improved at each better path or bound; the next run() or step() goes on.

#include <cstddef>
#include <span>
#include <utility>

#include "wend/planner/search_engine.hpp"
#include "wend/search/anytime_search.hpp"

namespace wend {

template <class Engine, class Names, class Space, class Priority, class Links = StepLinks,
          template <class> class Store = DenseNodes>
class AnytimeEngineOf final : public Engine {
 public:
  using Place = typename Engine::Place;
  using Goal = typename Engine::Goal;

  AnytimeEngineOf(Space space, Priority priority, AnytimeWeights weights)
      : search_(std::move(space), std::move(priority), weights) {}

  bool allocated() const override { return search_.allocated() && search_.priority().allocated(); }

  void begin(const Place& start, std::span<const Goal> goals, const Limits& limits,
             SearchObserver* observer) override {
    search_.priority().begin(goals, limits);
    observer_ = observer;
    watched([&](auto&& watcher) { search_.begin(search_.space().state(start), limits, watcher); });
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
  OpenList open_list(std::size_t most) const override { return open_list_of<Names>(search_, most); }
  double heuristic(const Place& place) const override { return search_.priority().h(place); }
  std::optional<double> bound() const override { return search_.bound(); }

  void write_path(Path& path) const override {
    path.clear();
    search_.for_each_back_from(search_.goal(), [&](const auto& state) {
      Names::append(path, search_.space(), Names::place(state));
    });
    path.reverse();
  }

 private:
  using Search = AnytimeSearch<Space, Priority, Links, Store>;

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
