#include "wend/space/grid/grid_space.hpp"

#include <utility>

#include "wend/robot/sweep/swept_clearance.hpp"
#include "wend/space/grid/sight_grid.hpp"

namespace wend {

bool sweeps_diagonals(const FreeSpace& space, GridMoves moves) {
  return moves.connectivity == Connectivity::eight && moves.corner_rule != CornerRule::none &&
         space.radius_in_cells() > 0;
}

template <class Steps>
GridSpace<Steps>::GridSpace(FreeSpace space, GridMoves moves, MoveTable::Pruning pruning)
    : space_(std::move(space)),
      passable_(&space_->passable()),
      steps_(*space_),
      width_(static_cast<StateId>(space_->width())),
      table_(moves, sweeps_diagonals(*space_, moves) ? MoveTable::Pruning::none : pruning),
      sweeps_(sweeps_diagonals(*space_, moves)) {
  for (std::size_t i = 0; i < kDirections; ++i) {
    id_offsets_[i] = static_cast<StateId>(kDirectionSteps[i].y) * width_ +
                     static_cast<StateId>(kDirectionSteps[i].x);
  }
}

template <class Steps>
void GridSpace<Steps>::release() {
  space_.reset();
  passable_ = nullptr;
}

template <class Steps>
void GridSpace<Steps>::update(FreeSpace space) {
  space_ = std::move(space);
  passable_ = &space_->passable();
  steps_ = Steps(*space_);
}

template <class Steps>
DirectionSet GridSpace<Steps>::without_unsafe(Cell cell, DirectionSet moves) const {
  unsigned safe = moves;
  for (unsigned left = moves & 0b10101010U; left != 0; left &= left - 1) {
    const auto direction = static_cast<unsigned>(std::countr_zero(left));
    const Cell to = step(cell, static_cast<Direction>(direction));
    if (!free_space().far_enough(squared_half_cell_way_clearance(free_space(), cell, to))) {
      safe &= ~(1U << direction);
    }
  }
  return static_cast<DirectionSet>(safe);
}

template <class Steps>
bool GridSpace<Steps>::is_step(Cell from, Cell to) const {
  if (!free_space().passable(from) || !free_space().passable(to)) return false;
  const unsigned moves = moves_from(from, kNoMove);
  for (unsigned direction = 0; direction < kDirections; ++direction) {
    const bool leads_there = neighbour(state(from), direction).cell == to;
    if (leads_there) return ((moves >> direction) & 1U) != 0;
  }
  return false;
}

template class GridSpace<UniformSteps<std::uint32_t>>;
template class GridSpace<UniformSteps<std::uint64_t>>;
template class GridSpace<TerrainSteps>;
template class GridSpace<LengthSteps>;
template class GridSpace<CostSteps>;

}  // namespace wend
