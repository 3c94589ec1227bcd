#include "wend/render/picture/scale_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wend {
namespace {

// Lengths that differ by less are one: powers of ten are not exact.
constexpr double kBarRounding = 1e-9;

double round_length(double longest) {
  const double power = std::pow(10, std::floor(std::log10(longest * (1 + kBarRounding))));
  for (const double factor : {5, 2}) {
    if (power * factor <= longest * (1 + kBarRounding)) return power * factor;
  }
  return power;
}

}  // namespace

ScaleBar scale_bar(const Frame& frame, double pixels_a_cell, double most) {
  if (frame.metric) {
    const double pixels_a_metre = pixels_a_cell / frame.resolution;
    const double metres = round_length(most / pixels_a_metre);
    return {metres * pixels_a_metre, fmt::format("{:g} m", metres)};
  }
  const double cells = std::max(1.0, round_length(most / pixels_a_cell));
  return {cells * pixels_a_cell, fmt::format("{:g} {}", cells, cells == 1 ? "cell" : "cells")};
}

}  // namespace wend
