// _core.Space: a path that covers an area.

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/cells.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/space.hpp"
#include "wend/cover/plan_coverage.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

std::optional<Point> place_of(nb::handle point, const std::string& name, const Frame& frame) {
  if (point.is_none()) return std::nullopt;
  return frame.to_grid(coordinates_of(point, name).pose().point());
}

std::optional<BitGrid> cells_of(nb::handle array, const std::string& name) {
  if (array.is_none()) return std::nullopt;
  return planes_of(array, name).occupied;
}

/// 1 for the cells that are set.
auto array_of(const BitGrid& cells) {
  std::vector<std::uint8_t> values;
  values.reserve(static_cast<std::size_t>(cells.width()) *
                 static_cast<std::size_t>(cells.height()));
  for (const Cell cell : every_cell(cells)) values.push_back(cells[cell] ? 1 : 0);
  return owned_array<std::uint8_t, 2>(std::move(values), shape_of(cells));
}

nb::dict result_of(const Coverage& coverage, const Frame& frame) {
  const std::vector<MapPoint> points = coverage.path.points_in_metres(frame);
  std::vector<double> numbers;
  for (const MapPoint point : points) numbers.insert(numbers.end(), {point.x, point.y});
  nb::dict result;
  result["points"] = owned_array<double, 2>(std::move(numbers), {points.size(), 2});
  result["wanted"] = array_of(coverage.wanted);
  result["covered"] = array_of(coverage.covered);
  result["covered_share"] = coverage.covered_share;
  result["length"] = coverage.length;
  result["lower_bound"] = coverage.lower_bound;
  result["turns"] = coverage.turns;
  result["strokes"] = coverage.strokes;
  return result;
}

nb::dict cover(const Space& space, double tool_width, double overlap, std::optional<double> angle,
               std::optional<double> turn_cost, double share, nb::handle start, nb::handle end,
               nb::handle area, nb::handle covered, std::uint64_t seed,
               std::optional<double> time_limit) {
  const FreeSpace free = space.view().space;
  const Frame& frame = free.map().frame();
  CoverageOptions options{
      .tool_width = tool_width, .overlap = overlap, .share = share, .seed = seed};
  if (angle) options.angle = *angle - frame.origin.heading;
  options.turn_cost = turn_cost;
  options.start = place_of(start, "start", frame);
  options.end = place_of(end, "end", frame);
  options.area = cells_of(area, "area");
  options.covered = cells_of(covered, "covered");
  if (time_limit) options.limits.seconds = *time_limit;
  Interrupts interrupts;
  interrupts.watch(options.limits);
  auto coverage = unlocked([&] { return plan_coverage(free, options); });
  interrupts.throw_if_interrupted();
  return result_of(value_or_throw(std::move(coverage)), frame);
}

}  // namespace

void bind_coverage(nb::class_<Space>& space) {
  space.def("cover", &cover, nb::arg("tool_width"), nb::arg("overlap"), nb::arg("angle").none(),
            nb::arg("turn_cost").none(), nb::arg("share"), nb::arg("start").none(),
            nb::arg("end").none(), nb::arg("area").none(), nb::arg("covered").none(),
            nb::arg("seed"), nb::arg("time_limit").none());
}

}  // namespace wend::python
