#include "wend/space/lattice/motion_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "wend/base/parse.hpp"
#include "wend/base/state_id.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// Map cells per cell of the primitives, if the primitives' are as large or larger.
double cells_per_cell(const GridMap& map, const MotionPrimitives& primitives) {
  const auto resolution = primitives.resolution();
  const Frame& frame = map.frame();
  return resolution && frame.metric ? *resolution / frame.resolution : 1;
}

int vertices_along(int length, int unit) { return (length + unit - 1) / unit; }

std::vector<Pose> poses_on_map(const MotionPrimitive& primitive, int unit) {
  std::vector<Pose> poses;
  poses.reserve(primitive.poses.size());
  for (const Pose& pose : primitive.poses) {
    poses.push_back({pose.x * unit + 0.5, pose.y * unit + 0.5, pose.heading});
  }
  return poses;
}

double cost_of(const Segment& segment, const LatticeCosts& costs) {
  if (segment.length == 0) return costs.turn_cost * std::abs(segment.turn);
  return std::abs(segment.length) * (segment.length < 0 ? costs.reverse_factor : 1);
}

/// How the cost of a way is shared among the cells that it leads through.
std::vector<CellShare> shares_of(std::span<const Pose> poses, const LatticeCosts& costs) {
  std::vector<CellShare> shares;
  double whole = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Segment segment = segment_between(poses[i - 1], poses[i]);
    const double cost = cost_of(segment, costs);
    const int samples = 1 + static_cast<int>(std::abs(segment.length) * kTerrainSamples);
    for (int n = 0; n < samples; ++n) {
      const Cell cell = cell_at(pose_on(segment, (n + 0.5) / samples).point());
      auto found = std::ranges::find(shares, cell, &CellShare::offset);
      if (found == shares.end()) found = shares.insert(found, {cell, 0});
      found->share += cost / samples;
    }
    whole += cost;
  }
  for (CellShare& share : shares) share.share /= whole;
  return shares;
}

LatticeStep step_of(const FreeSpace& space, const MotionPrimitive& primitive, int unit,
                    const LatticeCosts& costs) {
  std::vector<Pose> poses = poses_on_map(primitive, unit);
  double cost = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    cost += cost_of(segment_between(poses[i - 1], poses[i]), costs);
  }
  SweptCells swept(space, poses);
  std::vector<CellShare> ground = shares_of(poses, costs);
  poses.erase(poses.begin());
  return {primitive.from,   primitive.to,     primitive.by,     cost * primitive.cost_factor,
          std::move(poses), std::move(swept), std::move(ground)};
}

}  // namespace

std::string MotionLattice::why_none(const FreeSpace& space, const MotionPrimitives& primitives) {
  const GridMap& map = space.map();
  // Such a robot would sweep the whole map with each step, and more cells than can be listed.
  if (space.radius_in_cells() > hypotenuse(map.width(), map.height())) {
    return "the robot, with a radius of " + format_number(space.radius_in_cells()) +
           " cells, is larger than the map of " + std::to_string(map.width()) + " x " +
           std::to_string(map.height()) + " cells";
  }
  constexpr double kRounding = 1e-6;
  const double unit = cells_per_cell(map, primitives);
  if (unit < 1 - kRounding || std::abs(unit - std::round(unit)) > kRounding * unit || unit > 1e6) {
    return "the motion primitives are for cells of " +
           format_number(primitives.resolution().value_or(1)) + " m, which must be " +
           format_number(map.frame().resolution) +
           " m, the resolution of the map, or a whole multiple of it";
  }
  const auto vertices = [&](int length) {
    return static_cast<std::uint64_t>(vertices_along(length, static_cast<int>(std::round(unit))));
  };
  const std::uint64_t states =
      vertices(map.width()) * vertices(map.height()) * primitives.headings().size();
  if (states < std::numeric_limits<StateId>::max()) return {};
  return "the map of " + std::to_string(map.width()) + " x " + std::to_string(map.height()) +
         " cells has too many states for " + std::to_string(primitives.headings().size()) +
         " headings";
}

MotionLattice::MotionLattice(const FreeSpace& space, const MotionPrimitives& primitives,
                             const LatticeCosts& costs) {
  const int unit = static_cast<int>(std::round(cells_per_cell(space.map(), primitives)));
  Data data{space,
            primitives,
            unit,
            vertices_along(space.width(), unit),
            vertices_along(space.height(), unit),
            {},
            {0},
            std::numeric_limits<double>::infinity()};
  for (std::size_t heading = 0; heading < primitives.headings().size(); ++heading) {
    for (const MotionPrimitive& primitive : primitives.leaving(static_cast<int>(heading))) {
      data.steps.push_back(step_of(space, primitive, unit, costs));
      const LatticeStep& step = data.steps.back();
      const double leads = unit * hypotenuse(step.by.x, step.by.y);
      if (leads > 0) {
        data.least_cost_per_cell = std::min(data.least_cost_per_cell, step.cost / leads);
      }
    }
    data.first.push_back(data.steps.size());
  }
  if (std::isinf(data.least_cost_per_cell)) data.least_cost_per_cell = 0;
  data_ = std::make_shared<const Data>(std::move(data));
}

double MotionLattice::ground(Cell vertex, const LatticeStep& step) const {
  const Cell from = cell_of(vertex);
  double ground = 0;
  for (const CellShare& part : step.ground) {
    ground += part.share * data_->space.terrain({from.x + part.offset.x, from.y + part.offset.y});
  }
  return ground;
}

Pose MotionLattice::to_grid(const LatticePose& place) const {
  return pose_at(cell_of(place.vertex), headings()[static_cast<std::size_t>(place.heading)]);
}

std::optional<LatticePose> MotionLattice::nearest(const Pose& pose) const {
  const bool finite = std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
  if (!finite || !cell_under(data_->space, pose.point())) return std::nullopt;
  const auto vertex_along = [&](double at, int vertices) {
    const int nearest = static_cast<int>(std::round((at - 0.5) / data_->unit));
    return std::clamp(nearest, 0, vertices - 1);
  };
  return LatticePose{{vertex_along(pose.x, columns()), vertex_along(pose.y, rows())},
                     data_->primitives.nearest_heading(pose.heading)};
}

bool MotionLattice::may_stand(Cell vertex, const HeadingSet& accepted) const {
  for (std::size_t heading = 0; heading < headings().size(); ++heading) {
    if (accepted[heading] && may_stand({vertex, static_cast<int>(heading)})) return true;
  }
  return false;
}

const LatticeStep* MotionLattice::step_between(const LatticePose& from,
                                               const LatticePose& to) const {
  const LatticeStep* cheapest = nullptr;
  const Cell by{to.vertex.x - from.vertex.x, to.vertex.y - from.vertex.y};
  for (const LatticeStep& step : leaving(from.heading)) {
    if (step.to != to.heading || !(step.by == by) || !fits(from.vertex, step)) continue;
    if (cheapest == nullptr || cost(from.vertex, step) < cost(from.vertex, *cheapest)) {
      cheapest = &step;
    }
  }
  return cheapest;
}

}  // namespace wend
