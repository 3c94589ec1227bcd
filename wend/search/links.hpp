#pragma once

// Links: how a search reaches a state, and which kind of node keeps that.
//
// StepLinks is what most searches use. Other links choose parents: `link` says how a state that is
// being expanded reaches a successor, given the cost of the step between them; none: not at all. It
// is not asked about successors that are closed, except in rounds. ParentLinks choose the state that is
// expanded, in spaces with more moves than a MoveNode can number, or moves that cannot be undone.
//
// They may also have settled(search, state), which costs nothing if it is not there: another link to a state
// that is about to be expanded, or none if it keeps the one that it has.

#include <optional>

#include "wend/base/state_id.hpp"
#include "wend/search/node_table.hpp"

namespace wend {

/// A way to a state: from which one, and its cost from the start.
template <class Cost>
struct Link {
  StateId parent;
  Cost g;
};

/// By the space's moves, from the state that is expanded.
struct StepLinks {
  template <class Cost>
  using Node = MoveNode<Cost>;
};

/// From the state that is expanded, by whatever leads from there.
struct ParentLinks {
  template <class Cost>
  using Node = ParentNode<Cost>;

  template <class Search>
  static std::optional<Link<typename Search::Cost>> link(const Search& search,
                                                         const typename Search::State& state,
                                                         const typename Search::State& /*next*/,
                                                         typename Search::Cost step_cost) {
    const StateId id = search.space().id(state);
    return Link<typename Search::Cost>{id, search.g(id) + step_cost};
  }
};

}  // namespace wend
