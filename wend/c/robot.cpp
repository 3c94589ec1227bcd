// Robots of the C interface.

#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"

namespace wend::c {
namespace {

using FootprintResult = Expected<Footprint, Failure>;
using RobotResult = Expected<std::unique_ptr<wend_robot>, Failure>;

constexpr wend_robot_options kRobotDefaults{
    sizeof(wend_robot_options), 0, nullptr, 0, 0, 4, nullptr};

FootprintResult footprint_of_text(const wend_robot_options& options) {
  if (options.radius != 0 || options.corner_count != 0) {
    return refused("wend_robot_options has a footprint and also a radius or corners");
  }
  auto footprint = parse_footprint(options.footprint);
  if (!footprint) return failed(std::move(footprint.error()));
  return *std::move(footprint);
}

FootprintResult footprint_of(const wend_robot_options& options) {
  if (options.footprint != nullptr) return footprint_of_text(options);
  if (options.corner_count == 0) return Footprint::disc(options.radius);
  if (options.corners == nullptr) {
    return refused("wend_robot_options.corners is null, but corner_count is not 0");
  }
  if (options.radius != 0) {
    return refused("wend_robot_options has corners and a radius: a robot is a polygon or a disc");
  }
  constexpr std::size_t kMost = Polygon::kMostCorners + 1;  // the last may repeat the first
  if (options.corner_count > kMost) {
    return refused("wend_robot_options.corner_count is " + std::to_string(options.corner_count) +
                   ": at most " + std::to_string(Polygon::kMostCorners) + " expected");
  }
  std::vector<Point> corners;
  corners.reserve(options.corner_count);
  for (std::size_t i = 0; i < options.corner_count; ++i) {
    corners.push_back({options.corners[i].x, options.corners[i].y});
  }
  auto outline = Polygon::make(std::move(corners));
  if (!outline) return failed(std::move(outline.error()));
  auto footprint = Footprint::polygon(*std::move(outline));
  if (!footprint) return failed(std::move(footprint.error()));
  return *std::move(footprint);
}

RobotResult make_robot(const wend_robot_options& options) {
  auto footprint = footprint_of(options);
  if (!footprint) return Unexpected<Failure>(std::move(footprint.error()));
  const Robot robot{*std::move(footprint), options.clearance_distance, options.clearance_cost};
  // A map of one cell is enough to check the robot.
  auto one_cell = make_grid_map(Grid<CellState>(1, 1, CellState::free));
  if (auto space = make_free_space(Obstacles(*std::move(one_cell)), robot); !space) {
    return failed(std::move(space.error()));
  }
  return std::make_unique<wend_robot>(robot);
}

}  // namespace
}  // namespace wend::c

using namespace wend::c;

wend_status wend_robot_options_init(wend_robot_options* options, size_t struct_size) {
  return init(options, struct_size, kRobotDefaults);
}

wend_status wend_robot_create(const wend_robot_options* options, wend_robot** robot,
                              wend_error* error) {
  return made("robot", robot, error, [&]() -> RobotResult {
    if (options == nullptr) return refused("options is null");
    const auto chosen = wend::c::options_of("wend_robot_options", options, kRobotDefaults);
    if (!chosen) return wend::Unexpected<Failure>(chosen.error());
    return make_robot(*chosen);
  });
}

void wend_robot_free(wend_robot* robot) { delete robot; }
