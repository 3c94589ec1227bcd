#include "wend/render/picture/round_step.hpp"

#include <initializer_list>

namespace wend {

int round_step(double least) {
  constexpr int kMost = 1'000'000'000;
  for (int power = 1; power < kMost; power *= 10) {
    for (const int factor : {1, 2, 5}) {
      if (factor * power >= least) return factor * power;
    }
  }
  return kMost;
}

}  // namespace wend
