#include "wend/path/smoothing.hpp"

#include <cmath>

#include "wend/base/parse.hpp"

namespace wend {

std::optional<std::string> fault_of_weights(double alpha, double beta, bool in_place) {
  if (!(alpha >= 0 && beta >= 0 && std::isfinite(alpha) && std::isfinite(beta))) {
    return "alpha and beta must be finite and not negative";
  }
  const double neighbours = in_place ? 2 : 4;
  const double sum = alpha + neighbours * beta;
  if (sum < 2) return std::nullopt;
  std::string what = std::string(in_place ? "alpha + 2 beta" : "alpha + 4 beta") + " is " +
                     format_number(sum) + ", and sweeps diverge unless it is less than 2";
  if (alpha < 2) {
    what += ": with this alpha, beta must be less than " + format_number((2 - alpha) / neighbours);
    if (!in_place && alpha + 2 * beta < 2) what += ", or set in_place";
  }
  return what;
}

}  // namespace wend
