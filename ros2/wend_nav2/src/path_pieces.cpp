// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "wend/geometry/angle.hpp"

namespace wend_nav2 {
namespace {

// A robot turns in place between two pieces that differ by more, rad.
constexpr double kLeastTurn = 0.3;

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

std::vector<wend::MapPoint> points_of(std::span<const wend::MapPose> piece) {
  std::vector<wend::MapPoint> points;
  points.reserve(piece.size());
  for (const wend::MapPose& pose : piece) points.push_back(pose.point());
  return points;
}

/// The robot's heading at a place of a leg.
double facing(const wend::RouteLeg& leg, double along) {
  return wend::turned_round(leg.line.at(along), leg.reverse).heading;
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

bool has_headings(std::span<const wend::MapPose> path) {
  return !path.empty() && std::ranges::any_of(path.first(path.size() - 1),
                                              [](const auto& pose) { return pose.heading != 0; });
}

bool in_reverse(std::span<const wend::MapPose> piece) {
  double ahead = 0;
  for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
    const wend::Point way = step(piece[i], piece[i + 1]);
    ahead += dot(way, {std::cos(piece[i].heading), std::sin(piece[i].heading)});
  }
  return ahead < 0;
}

wend::Route route_along(std::span<const wend::MapPose> path) {
  std::vector<wend::RouteLeg> legs;
  const bool faces = has_headings(path);
  std::optional<double> heading;  // at the end of the leg before
  const std::vector<std::size_t> cuts =
      path.size() < 2 ? std::vector<std::size_t>{} : cuts_of(path);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const auto piece = path.subspan(cuts[i], cuts[i + 1] - cuts[i] + 1);
    wend::RouteLeg leg{wend::MapPolyline(points_of(piece)), faces && in_reverse(piece)};
    if (leg.line.length() == 0) continue;
    leg.turn_first =
        heading && std::abs(wend::normalized_angle(facing(leg, 0) - *heading)) > kLeastTurn;
    heading = facing(leg, leg.line.length());
    legs.push_back(std::move(leg));
  }
  if (legs.empty()) legs.push_back({wend::MapPolyline(points_of(path.last(1)))});
  return wend::Route(std::move(legs), path.back().heading);
}

}  // namespace wend_nav2
