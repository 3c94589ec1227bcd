#pragma once

// The concepts of the parts of a forward search. concepts_test.cpp has a minimal type for each.

#include <concepts>

#include "wend/base/state_id.hpp"

namespace wend {

/// A state space. A State holds data that makes expansion cheap, for example coordinates, and can be
/// made from the id. Where a search keeps moves (StepLinks), they can be undone: parent(s, m) is the
/// state from which move m leads to s.
///
/// for_each_successor(state, arrival, sink) calls sink(next, move, step_cost) for every successor,
/// always in the same order. `arrival` is the move that reached the state, so that a space can leave
/// out successors that are reached as cheaply by another path.
///
/// It may have a function ahead(state, next): the id of the state whose node the search will probably need
/// after it has reached `next` from `state`, for the search to prefetch. Any id is allowed.
template <class S>
concept SearchSpace = requires(const S& space, StateId id, Move move,
                               const typename S::State& state) {
  typename S::Cost;
  { space.state_count() } -> std::convertible_to<StateId>;
  { space.state(id) } -> std::convertible_to<typename S::State>;
  { space.id(state) } -> std::convertible_to<StateId>;
  space.for_each_successor(state, move, [](const typename S::State&, Move, typename S::Cost) {});
};

/// Gives a state the key by which the frontier orders it, and says which states are goals.
template <class P, class Space>
concept SearchPriority = requires(const P& priority, const typename Space::State& state,
                                  typename Space::Cost g, typename P::Key key) {
  { priority.key(state, g) } -> std::same_as<typename P::Key>;
  { priority.is_goal(state) } -> std::convertible_to<bool>;
  { priority.near_overflow(key) } -> std::convertible_to<bool>;
};

/// A frontier (open list). The same pushes are popped in the same order on every platform, also from a
/// copy.
template <class F>
concept SearchFrontier = std::copyable<F> && requires(F frontier, typename F::Key key, StateId id) {
  frontier.clear();
  { frontier.empty() } -> std::convertible_to<bool>;
  frontier.push(key, id);
  { frontier.pop().id } -> std::convertible_to<StateId>;
  { frontier.pop().key } -> std::convertible_to<typename F::Key>;
};

/// Watches a search. A template parameter of the loop: watching with NoObserver costs nothing.
/// An arrival is a move, or the id of the parent, as the Links of the search have it.
template <class O, class Space, class Arrival = Move>
concept SearchWatcher = requires(O& observer, const typename Space::State& state, Arrival arrival,
                                 typename Space::Cost g) {
  observer.on_generate(state, arrival, g);
  observer.on_expand(state, arrival, g);
  observer.on_relax(state, arrival, g);
};

struct NoObserver {
  void on_generate(const auto&, auto, auto) const {}
  void on_expand(const auto&, auto, auto) const {}
  void on_relax(const auto&, auto, auto) const {}
};

}  // namespace wend
