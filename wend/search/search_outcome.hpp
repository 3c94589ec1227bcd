#pragma once

// How a search stands.

namespace wend {

enum class SearchOutcome {
  running,
  found,
  exhausted,  // every state that can be reached was expanded
  expansion_limit,
  time_limit,
  cancelled,
  cost_overflow,  // costs outgrew their type: search again with a larger one
  out_of_memory,  // there was none for the nodes
};

}  // namespace wend
