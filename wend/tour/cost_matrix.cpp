#include "wend/tour/cost_matrix.hpp"

namespace wend {

CostMatrix::CostMatrix(int stops, double cost)
    : size_(stops),
      costs_(static_cast<std::size_t>(stops) * static_cast<std::size_t>(stops), cost) {
  for (int stop = 0; stop < stops; ++stop) set(stop, stop, 0);
}

bool CostMatrix::symmetric() const {
  for (int from = 0; from < size_; ++from) {
    for (int to = 0; to < from; ++to) {
      if ((*this)(from, to) != (*this)(to, from)) return false;
    }
  }
  return true;
}

}  // namespace wend
