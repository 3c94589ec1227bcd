#pragma once

// SearchOrder: in which order a search on cells takes what is equal, so that the numbers of a textbook or a lecture
// can be reproduced.
//
//   const wend::SearchOrder order{wend::NeighbourOrder::uldr, wend::Ties::sorted};
//
// Costs and guarantees do not depend on it; which of several equal paths is found does, and how many cells are
// expanded.

#include <array>

#include "wend/base/choice.hpp"

namespace wend {

/// The order in which neighbours are reached, by their letters: up, down, left and right on the page. The four
/// diagonal ones come behind them, those beside the first letter first.
enum class NeighbourOrder {
  any,   // the planner's own
  udlr,  // up, down, left, right
  udrl,  // up, down, right, left
  uldr,  // up, left, down, right
  ulrd,  // up, left, right, down
  urdl,  // up, right, down, left
  urld,  // up, right, left, down
  dulr,  // down, up, left, right
  durl,  // down, up, right, left
  dlur,  // down, left, up, right
  dlru,  // down, left, right, up
  drul,  // down, right, up, left
  drlu,  // down, right, left, up
  ludr,  // left, up, down, right
  lurd,  // left, up, right, down
  ldur,  // left, down, up, right
  ldru,  // left, down, right, up
  lrud,  // left, right, up, down
  lrdu,  // left, right, down, up
  rudl,  // right, up, down, left
  ruld,  // right, up, left, down
  rdul,  // right, down, up, left
  rdlu,  // right, down, left, up
  rlud,  // right, left, up, down
  rldu   // right, left, down, up
};

/// Which of the open cells with the same priority is expanded first.
enum class Ties {
  any,     // the planner's own: the larger g, then the newest
  oldest,  // the one that was reached first
  newest,  // the one that was reached last
  sorted  // as in a sorted list of priority, g, row and column: the least g, then from the top left
};

constexpr std::array<Choice<NeighbourOrder>, 25> choice_names(NeighbourOrder) {
  using enum NeighbourOrder;
  return {{{"any", any},   {"udlr", udlr}, {"udrl", udrl}, {"uldr", uldr}, {"ulrd", ulrd},
           {"urdl", urdl}, {"urld", urld}, {"dulr", dulr}, {"durl", durl}, {"dlur", dlur},
           {"dlru", dlru}, {"drul", drul}, {"drlu", drlu}, {"ludr", ludr}, {"lurd", lurd},
           {"ldur", ldur}, {"ldru", ldru}, {"lrud", lrud}, {"lrdu", lrdu}, {"rudl", rudl},
           {"ruld", ruld}, {"rdul", rdul}, {"rdlu", rdlu}, {"rlud", rlud}, {"rldu", rldu}}};
}

constexpr std::array<Choice<Ties>, 4> choice_names(Ties) {
  return {{{"any", Ties::any},
           {"oldest", Ties::oldest},
           {"newest", Ties::newest},
           {"sorted", Ties::sorted}}};
}

namespace detail {
template <class Order, class Field>
void neighbour_order_field(Order& order, Field&& field) {
  field({"neighbour_order",
         "order in which neighbours are reached, by the first letters of up, down, left and "
         "right; diagonal ones follow; any is the fastest"},
        order);
}
}  // namespace detail

/// The order of a search as options of a planner.
struct SearchOrder {
  NeighbourOrder neighbours = NeighbourOrder::any;  // of a cell
  Ties ties = Ties::any;                            // among open cells

  /// Is anything asked for? Then the search goes cell by cell, in exactly this order.
  bool chosen() const { return neighbours != NeighbourOrder::any || ties != Ties::any; }

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    detail::neighbour_order_field(self.neighbours, field);
    field({"ties",
           "which of the open cells with the same priority comes first: any (the fastest), the "
           "oldest, the newest, or sorted: least g, then row and column"},
          self.ties);
  }

  friend bool operator==(const SearchOrder&, const SearchOrder&) = default;
};

}  // namespace wend
