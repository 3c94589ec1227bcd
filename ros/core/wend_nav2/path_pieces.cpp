// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_pieces.hpp"

#include <cmath>

#include "wend/geometry/pose.hpp"

namespace wend_nav2 {
namespace {

wend::Point step(const wend::MapPose& from, const wend::MapPose& to) {
  return {to.x - from.x, to.y - from.y};
}

double dot(wend::Point a, wend::Point b) { return a.x * b.x + a.y * b.y; }

/// Is a path cut at this inner pose?
bool is_cut(const wend::MapPose& before, const wend::MapPose& at, const wend::MapPose& after) {
  const wend::Point in = step(before, at);
  const wend::Point out = step(at, after);
  return dot(in, in) == 0 || dot(out, out) == 0 || dot(in, out) < 0;
}

}  // namespace

std::vector<std::size_t> cuts_of(std::span<const wend::MapPose> path) {
  std::vector<std::size_t> cuts{0};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (is_cut(path[i - 1], path[i], path[i + 1])) cuts.push_back(i);
  }
  cuts.push_back(path.size() - 1);
  return cuts;
}

bool in_reverse(std::span<const wend::MapPose> piece) {
  double ahead = 0;
  for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
    const wend::Point way = step(piece[i], piece[i + 1]);
    ahead += dot(way, {std::cos(piece[i].heading), std::sin(piece[i].heading)});
  }
  return ahead < 0;
}

}  // namespace wend_nav2
