#pragma once

// What an edit of one cell and the next query of a planner take together, beside a query without an edit and the first
// one on a new space.

#include <cstdint>
#include <string>
#include <string_view>

namespace wend::bench {

struct NextQuery {
  std::string kind;     // the generator of the map
  int side = 0;         // of the map, in cells
  double edit = 0;      // seconds, mean: the edit in place, and the planner's update
  double next = 0;      // the query after it
  double worst = 0;     // both, the longest
  double unedited = 0;  // a query without an edit before it
  double first_one =
      0;          // the first query of a planner on a space that is new, without making the space
  int wrong = 0;  // answers that are not those of a planner made for the edited space
};

/// Asks a planner `count` queries between random cells of a generated map, one after each edit of a random cell. The
/// planner has answered all of them before. Throws Refused if the planner cannot plan on
/// this map.
NextQuery time_next_queries(std::string_view kind, int side, const std::string& planner, int count,
                            std::uint64_t seed);

}  // namespace wend::bench
