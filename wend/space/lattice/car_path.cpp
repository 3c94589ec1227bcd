#include "wend/space/lattice/car_path.hpp"

namespace wend {

std::optional<CarMove> move_between(const CornerPose& from, const CornerPose& to) {
  for (int number = 0; number < kCarMoves; ++number) {
    const auto move = static_cast<CarMove>(number);
    if (moved(from, move) == to) return move;
  }
  return std::nullopt;
}

double car_path_cost(const CarLattice& lattice, std::span<const CornerPose> poses) {
  double turns = 0;  // sums of ground
  double straight = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto move = move_between(poses[i - 1], poses[i]);
    if (!move) continue;
    const double factor = is_reverse(*move) ? lattice.driving().reverse_factor : 1;
    (is_turn(*move) ? turns : straight) += factor * lattice.ground(poses[i - 1], *move);
  }
  return straight * length_of(CarMove::fwd) + turns * length_of(CarMove::fwd_plus);
}

}  // namespace wend
