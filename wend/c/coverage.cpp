// Coverages of the C interface.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"
#include "wend/cover/plan_coverage.hpp"

wend_coverage::wend_coverage(const wend::Coverage& coverage, const wend::Frame& frame)
    : share(coverage.covered_share),
      length(coverage.length),
      lower_bound(coverage.lower_bound),
      turns(coverage.turns) {
  for (const wend::Pose& pose : coverage.path.poses()) {
    const wend::MapPose metres = frame.to_metres(pose);
    poses.push_back({metres.x, metres.y, metres.heading});
  }
  for (const wend::Cell cell : wend::every_cell(coverage.wanted)) {
    const bool wanted = coverage.wanted[cell];
    cells.push_back(static_cast<std::uint8_t>(coverage.covered[cell] ? 1 : (wanted ? 2 : 0)));
  }
}

namespace wend::c {
namespace {

constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

wend_coverage_options coverage_defaults() {
  wend_coverage_options options{};
  options.struct_size = sizeof(wend_coverage_options);
  options.angle = kNotGiven;
  options.turn_cost = kNotGiven;
  options.share = CoverageOptions{}.share;
  options.seed = CoverageOptions{}.seed;
  options.seconds = std::numeric_limits<double>::infinity();
  return options;
}

/// The cells of a map whose byte is not 0; nothing for null.
Expected<std::optional<BitGrid>, Failure> marked_cells(const std::uint8_t* bytes, std::size_t count,
                                                       const FreeSpace& space,
                                                       const std::string& name) {
  if (bytes == nullptr) return std::optional<BitGrid>();
  if (count != space.map().size()) {
    return refused("wend_coverage_options." + name + " has " + std::to_string(count) +
                   " cells, but the map has " + std::to_string(space.map().size()));
  }
  BitGrid cells(space.width(), space.height());
  std::size_t i = 0;
  for (const Cell cell : every_cell(cells)) cells.set(cell, bytes[i++] != 0);
  return std::optional(std::move(cells));
}

std::optional<Point> place_of(const wend_pose* pose, const Frame& frame) {
  if (pose == nullptr) return std::nullopt;
  return frame.to_grid(MapPoint{pose->x, pose->y});
}

Expected<CoverageOptions, Failure> coverage_options(const wend_coverage_options& given,
                                                    const FreeSpace& space) {
  const Frame& frame = space.map().frame();
  if (!(given.seconds >= 0)) return refused("wend_coverage_options.seconds is negative or NaN");
  CoverageOptions options{
      .tool_width = given.tool_width, .overlap = given.overlap, .share = given.share};
  if (!std::isnan(given.angle)) options.angle = given.angle - frame.origin.heading;
  if (!std::isnan(given.turn_cost)) options.turn_cost = given.turn_cost;
  options.start = place_of(given.start, frame);
  options.end = place_of(given.end, frame);
  auto area = marked_cells(given.area, given.cell_count, space, "area");
  if (!area) return Unexpected<Failure>(std::move(area.error()));
  options.area = std::move(*area);
  auto covered = marked_cells(given.covered, given.cell_count, space, "covered");
  if (!covered) return Unexpected<Failure>(std::move(covered.error()));
  options.covered = std::move(*covered);
  options.seed = given.seed;
  options.limits.seconds = given.seconds;
  if (given.cancel != nullptr) options.limits.cancel = &given.cancel->flag;
  return options;
}

double number_of(const wend_coverage* coverage, double wend_coverage::* number) {
  return coverage == nullptr ? kNotGiven : coverage->*number;
}

}  // namespace
}  // namespace wend::c

using namespace wend::c;

wend_status wend_coverage_options_init(wend_coverage_options* options, size_t struct_size) {
  return init(options, struct_size, coverage_defaults());
}

wend_status wend_session_cover(wend_session* session, const wend_coverage_options* options,
                               wend_coverage** coverage, wend_error* error) {
  using Made = wend::Expected<std::unique_ptr<wend_coverage>, Failure>;
  return made("coverage", coverage, error, [&]() -> Made {
    if (session == nullptr) return refused("session is null");
    if (options == nullptr) return refused("options is null: there is no default tool_width");
    const auto given = options_of("wend_coverage_options", options, coverage_defaults());
    if (!given) return wend::Unexpected<Failure>(given.error());
    const auto view = session->session.view();
    if (!view) return failed(view.error());
    const auto chosen = coverage_options(*given, view->space);
    if (!chosen) return wend::Unexpected<Failure>(chosen.error());
    const auto planned = wend::plan_coverage(view->space, *chosen);
    if (!planned) return failed(planned.error());
    return std::make_unique<wend_coverage>(*planned, view->space.map().frame());
  });
}

size_t wend_coverage_pose_count(const wend_coverage* coverage) {
  return coverage == nullptr ? 0 : coverage->poses.size();
}

const wend_pose* wend_coverage_poses(const wend_coverage* coverage) {
  return coverage == nullptr ? nullptr : coverage->poses.data();
}

const uint8_t* wend_coverage_cells(const wend_coverage* coverage) {
  return coverage == nullptr ? nullptr : coverage->cells.data();
}

double wend_coverage_share(const wend_coverage* coverage) {
  return number_of(coverage, &wend_coverage::share);
}

double wend_coverage_length(const wend_coverage* coverage) {
  return number_of(coverage, &wend_coverage::length);
}

double wend_coverage_lower_bound(const wend_coverage* coverage) {
  return number_of(coverage, &wend_coverage::lower_bound);
}

size_t wend_coverage_turns(const wend_coverage* coverage) {
  return coverage == nullptr ? 0 : coverage->turns;
}

void wend_coverage_free(wend_coverage* coverage) { delete coverage; }
