#include "wend/space/lattice/car_space.hpp"

#include <cassert>
#include <cmath>

namespace wend {
namespace {

/// The bit of a neighbouring corner in a block of passable ones whose rows are y + 1, y, y - 1.
unsigned bit_in_block(Cell by) { return static_cast<unsigned>((1 - by.y) * 3 + by.x + 1); }

}  // namespace

bool has_whole_costs(const CarLattice& lattice) {
  if (lattice.driving().reverse_factor != 1) return false;
  const Grid<double>& terrain = lattice.terrain();
  return std::all_of(terrain.values().begin(), terrain.values().end(), [](double multiplier) {
    return multiplier <= kMostWholeMultiplier && multiplier == std::floor(multiplier);
  });
}

template <class Unit>
WholeCarCosts<Unit>::WholeCarCosts(const CarLattice& lattice) {
  const Grid<double>& terrain = lattice.terrain();
  if (terrain.empty()) return;
  terrain_ = Grid<std::uint8_t>(terrain.width(), terrain.height());
  for (const Cell cell : every_cell(terrain)) {
    terrain_[cell] = static_cast<std::uint8_t>(terrain[cell]);
  }
}

template <class Costs>
CarSteps<Costs>::CarSteps(CarLattice lattice)
    : lattice_(std::move(lattice)),
      passable_(&lattice_.passable()),
      costs_(lattice_),
      straight_pays_(!lattice_.terrain().empty() &&
                     lattice_.driving().straight_terrain != StraightTerrain::none) {
  for (const Heading heading : kAllHeadings) {
    for (unsigned block = 0; block < kBlocks; ++block) {
      unsigned moves = 0;
      for (int number = 0; number < kCarMoves; ++number) {
        const CarStep& way = step(heading, static_cast<CarMove>(number));
        moves |= ((block >> bit_in_block(way.by)) & 1U) << static_cast<unsigned>(number);
      }
      open_[static_cast<std::size_t>(heading) * kBlocks + block] = static_cast<std::uint8_t>(moves);
    }
  }
}

template class WholeCarCosts<std::uint32_t>;
template class WholeCarCosts<std::uint64_t>;
template class CarSteps<CompactCarCosts>;
template class CarSteps<ExactCarCosts>;
template class CarSteps<RealCarCosts>;

}  // namespace wend
