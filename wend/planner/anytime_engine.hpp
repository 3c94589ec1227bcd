#pragma once

// AnytimeEngineOf: an AnytimeSearch behind the interface of a SearchEngine. Its run() ends with
// SearchOutcome::improved at each better path or bound; the next run() or step() goes on.

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "wend/planner/search_engine.hpp"
#include "wend/search/anytime_search.hpp"

namespace wend {

template <class Engine, class Names, class Space, class Priority, class Links = StepLinks,
          template <class> class Store = DenseNodes>
class AnytimeEngineOf final
    : public EngineAround<Engine, Names, AnytimeSearch<Space, Priority, Links, Store>> {
 public:
  using Place = typename Engine::Place;
  using Goal = typename Engine::Goal;

  AnytimeEngineOf(Space space, Priority priority, AnytimeWeights weights)
      : Base(std::move(space), std::move(priority), weights) {}

  void begin(const Place& start, std::span<const Goal> goals, const Limits& limits,
             SearchObserver* observer) override {
    this->search().priority().begin(goals, limits);
    this->watch(observer);
    this->watched([&](auto&& watcher) {
      this->search().begin(this->search().space().state(start), limits, watcher);
    });
  }

  std::optional<double> bound() const override { return this->search().bound(); }
  std::uint64_t time_taken() const override { return 400 * this->metrics().expanded; }

 private:
  using Base = EngineAround<Engine, Names, AnytimeSearch<Space, Priority, Links, Store>>;

  /// The search heeds estimates that were broken off, and keeps what it found before.
  SearchOutcome outcome() const override { return this->search().outcome(); }
};

}  // namespace wend
