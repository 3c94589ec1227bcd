#pragma once

// PlannerInfo: description and guarantees of a planner. Front ends show it; the conformance test
// checks every planner against it.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/base/options.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/planner/capabilities.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class IndexSupport;  // index_support.hpp
class Planner;

/// The guarantee for every answer with any options. Where options matter, Plan::bound is the
/// guarantee of a single answer.
enum class Guarantee {
  none,          // the path is valid; may fail although a path exists
  complete,      // finds a path if one exists
  fewest_steps,  // complete, and no path has fewer steps
  bounded,       // complete, and with consistent options the cost is within a known factor
  optimal,       // complete, and no path is cheaper
};

constexpr std::array<Choice<Guarantee>, 5> choice_names(Guarantee) {
  return {{{"none", Guarantee::none},
           {"complete", Guarantee::complete},
           {"fewest steps", Guarantee::fewest_steps},
           {"bounded", Guarantee::bounded},
           {"optimal", Guarantee::optimal}}};
}

/// Work for a map before the first query, besides loading it.
enum class Preprocessing {
  none,   // no work
  quick,  // seconds
  slow,   // minutes
};

constexpr std::array<Choice<Preprocessing>, 3> choice_names(Preprocessing) {
  return {{{"none", Preprocessing::none},
           {"quick", Preprocessing::quick},
           {"slow", Preprocessing::slow}}};
}

/// For planners that do not support terrain: an error if the space has terrain.
WEND_API std::optional<Error> refused_terrain(std::string_view planner, const FreeSpace& space);

/// For planners without options: an error if there are options.
WEND_API std::optional<Error> refused_options(const OptionValues& values);

/// A planner, or why it could not be made: invalid_option, unsupported_map, memory_limit, index_missing
/// or index_mismatch.
using PlannerResult = Expected<std::unique_ptr<Planner>, Error>;

struct PlannerInfo {
  std::string name = {};            // as in make_planner()
  std::string summary = {};         // one line
  std::string idea = {};            // how it works, in two or three sentences
  std::string citation = {};        // the paper or book it comes from
  std::string guarantee_text = {};  // the guarantee in words, with its conditions
  std::string time = {};            // of one query: "O(n) in the n cells expanded"
  std::string memory = {};          // "8 bytes a cell", and what grows with a search
  double bytes_per_cell = 0;        // of the map, at most, for one search; 0: unknown
  std::string when = {};            // when to choose it and when not, in one to three sentences
  std::string motion = "cells";     // what its states are, in one word: reports have it
  std::string mover = "a disc, from cell to cell";    // who moves, and between what
  std::string cost_name = "cost";                     // what people call Plan::cost
  Guarantee guarantee = Guarantee::none;              // of every answer
  Preprocessing preprocessing = Preprocessing::none;  // of `make`
  Capabilities capabilities = {};                     // what it plans for, and how it can be used
  std::vector<OptionInfo> options = {};               // which `make` takes
  /// Makes the planner, including its preprocessing, on one thread.
  std::function<PlannerResult(const FreeSpace&, const OptionValues&)> make = {};
  /// The same before a deadline, else time_limit or cancelled; null if `make` takes no longer than a search.
  std::function<PlannerResult(const FreeSpace&, const OptionValues&, const Deadline&)> make_within =
      {};

  /// Where the states of a planner with these options will lie; null: in the middles of cells.
  std::function<PlaceGrid(const FreeSpace&, const OptionValues&)> places = {};

  /// Builds and opens the planner's index; null for planners without an index.
  std::shared_ptr<const IndexSupport> index_support = nullptr;
};

/// Planner::place_grid() of a planner that need not be made.
inline PlaceGrid places_of(const PlannerInfo& info, const FreeSpace& space,
                           const OptionValues& options) {
  return info.places ? info.places(space, options) : cells_of(space);
}

}  // namespace wend
