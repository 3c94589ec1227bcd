#pragma once

// OrderedGrid: a GridSpace whose successors come in the order of a NeighbourOrder. For teaching: it takes about twice
// the time of a GridSpace.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "wend/geometry/compass.hpp"
#include "wend/space/grid/grid_space.hpp"
#include "wend/space/grid/search_order.hpp"

namespace wend {

/// All directions of the grid in an order of the page. `any` is the order of Direction.
std::array<Direction, kDirections> directions_in(NeighbourOrder order, const Frame& frame);

template <class Space>
class OrderedGrid {
 public:
  using State = typename Space::State;
  using Cost = typename Space::Cost;
  static constexpr double kUnitsPerCell = Space::kUnitsPerCell;

  OrderedGrid(FreeSpace space, GridMoves moves, NeighbourOrder order)
      : order_(directions_in(order, space.map().frame())), grid_(std::move(space), moves) {}

  const FreeSpace& free_space() const { return grid_.free_space(); }
  StateId state_count() const { return grid_.state_count(); }
  State state(Cell cell) const { return grid_.state(cell); }
  State state(StateId id) const { return grid_.state(id); }
  StateId id(const State& state) const { return grid_.id(state); }
  State parent(const State& state, Move move) const { return grid_.parent(state, move); }

  template <class Sink>
  void for_each_successor(const State& state, Move arrival, Sink&& sink) const {
    std::array<std::optional<Step>, kDirections> steps;
    grid_.for_each_successor(state, arrival, [&](const State& next, Move move, Cost cost) {
      steps[move] = Step{next, cost};
    });
    for (const Direction direction : order_) {
      const auto move = static_cast<Move>(direction);
      if (const auto& step = steps[move]) sink(step->next, move, step->cost);
    }
  }

 private:
  struct Step {
    State next;
    Cost cost;
  };

  std::array<Direction, kDirections> order_;
  Space grid_;
};

}  // namespace wend
