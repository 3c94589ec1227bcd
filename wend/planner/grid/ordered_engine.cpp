#include "wend/planner/grid/ordered_engine.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/min_heap.hpp"
#include "wend/space/grid/ordered_grid.hpp"

namespace wend {
namespace {

/// f, then what is chosen among equal ones; arrival decides the rest.
struct OrderedKey {
  static constexpr bool kOrderIsChosen = true;

  double f = 0;             // in whole steps of kStep
  std::uint64_t g = 0;      // 0 unless it counts
  std::uint64_t place = 0;  // row and column, from the top left; 0 unless they count
  bool oldest_first = false;

  friend bool operator<(const OrderedKey& a, const OrderedKey& b) {
    if (a.f < b.f || b.f < a.f) return a.f < b.f;
    return a.g != b.g ? a.g < b.g : a.place < b.place;
  }
};

double f_of(const OrderedKey& key) { return key.f; }

/// Open cells in a heap, equal ones by their arrival.
class OrderedFrontier {
 public:
  using Key = OrderedKey;
  struct Entry {
    Key key;
    std::uint64_t arrival;
    StateId id;

    friend bool operator<(const Entry& a, const Entry& b) {
      if (a.key < b.key) return true;
      if (b.key < a.key) return false;
      return a.key.oldest_first ? a.arrival < b.arrival : a.arrival > b.arrival;
    }
  };

  void clear() {
    entries_.clear();
    arrivals_ = 0;
  }
  bool empty() const { return entries_.empty(); }
  void push(const Key& key, StateId id) { min_heap::push(entries_, Entry{key, arrivals_++, id}); }
  Entry pop() { return min_heap::pop(entries_); }

 private:
  std::vector<Entry> entries_;
  std::uint64_t arrivals_ = 0;
};

template <class Space>
class OrderedPriority : public TowardsGoals {
 public:
  using Key = OrderedKey;
  using Cost = typename Space::Cost;

  OrderedPriority(const FreeSpace& space, const OrderedSearch& search)
      : search_(search), height_(space.height()), y_up_(space.map().frame().y_up) {}

  Key key(const GridState& state, Cost g) const {
    const double cells = static_cast<double>(g) / Space::kUnitsPerCell;
    const Ties ties = search_.order.ties;
    // A constant changes no order and is only shown: added to a key, a large one would cost digits.
    const bool constant = search_.heuristic == HeuristicKind::constant;
    const double f = search_.g_share * cells + (constant ? 0 : search_.weight * h(state.cell));
    Key key{std::round(f / kStep), 0, 0, ties == Ties::oldest};
    if (ties == Ties::any) key.g = UINT64_MAX - g;
    if (ties != Ties::sorted) return key;
    key.g = g;
    const int row = y_up_ ? height_ - 1 - state.cell.y : state.cell.y;
    key.place = (std::uint64_t{static_cast<std::uint32_t>(row)} << 32U) |
                static_cast<std::uint32_t>(state.cell.x);
    return key;
  }

  bool near_overflow(const Key& /*key*/) const { return false; }
  bool replaces(std::uint64_t g, std::uint64_t before) const {
    return search_.fewest_steps && g < before && steps_of_cost(g) == steps_of_cost(before);
  }

  double h(Cell cell) const {
    return goals_.least(cell, [&](Cell goal) {
      return heuristic_value(search_.heuristic, search_.constant, cell, goal);
    });
  }
  double f(Cell cell, double g) const { return search_.g_share * g + search_.weight * h(cell); }

 private:
  // Sums in another order differ by a rounding error and are still equal; different lengths differ by more.
  static constexpr double kStep = 0x1p-20;  // cells

  OrderedSearch search_;
  int height_;
  bool y_up_;
};

template <class Space, DuplicateRule kDuplicates>
std::unique_ptr<GridEngine> make_engine(const FreeSpace& space, const OrderedSearch& search) {
  using Engine =
      GridEngineOf<OrderedGrid<Space>, OrderedFrontier, OrderedPriority<Space>, kDuplicates>;
  return std::make_unique<Engine>(OrderedGrid<Space>(space, search.moves, search.order.neighbours),
                                  OrderedPriority<Space>(space, search));
}

}  // namespace

std::unique_ptr<GridEngine> make_first_way_engine(const FreeSpace& space,
                                                  const OrderedSearch& search) {
  return make_engine<ExactGrid, DuplicateRule::keep_first>(space, search);
}

std::unique_ptr<GridEngine> make_cheapest_way_engine(const FreeSpace& space,
                                                     const OrderedSearch& search) {
  if (space.uniform_terrain()) {
    return make_engine<ExactGrid, DuplicateRule::keep_cheaper>(space, search);
  }
  return make_engine<TerrainGrid, DuplicateRule::keep_cheaper>(space, search);
}

}  // namespace wend
