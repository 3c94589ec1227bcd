#pragma once

// Links: how a search reaches a state, and which kind of node keeps that.
//
// StepLinks is what most searches use. Other links choose parents: `link` says how a state that is
// being expanded reaches a successor, given the cost of the step between them; none: not at all. It
// is not asked about successors that are closed.
//
//   struct StepsThatKeepParents {
//     template <class Cost>
//     using Node = wend::ParentNode<Cost>;
//
//     static std::optional<wend::Link<double>> link(const auto& search, const auto& state,
//                                                   const auto& /*next*/, double step_cost) {
//       const wend::StateId id = search.space().id(state);
//       return wend::Link<double>{id, search.g(id) + step_cost};
//     }
//   };
//
// They may also have a function `settled(search, state)`: another link to a state that is about to be
// expanded, or none if it keeps the one that it has. Functions that are not there cost nothing.
// planner/any_angle/ has two examples.

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

}  // namespace wend
