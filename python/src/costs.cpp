// _core.Map: occupancy grids, costmaps, masks, and costs of one's own.

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/cells.hpp"
#include "wend/base/options.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/map/masked.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/map/own_costs.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

/// Values of bytes, row by row, and how they lie.
template <class Byte>
struct ByteGrid {
  std::vector<Byte> values;
  int width = 0;
  int height = 0;
};

/// Python has made sure that the values fit.
template <class Byte>
ByteGrid<Byte> bytes_of(nb::handle array) {
  const BufferView view(array, "array");
  ByteGrid<Byte> grid{{}, static_cast<int>(view.columns()), static_cast<int>(view.rows())};
  grid.values.reserve(static_cast<std::size_t>(view.columns() * view.rows()));
  view.visit([&](const auto& values) {
    for (Py_ssize_t y = 0; y < values.rows; ++y) {
      for (Py_ssize_t x = 0; x < values.columns; ++x) {
        grid.values.push_back(static_cast<Byte>(values.at(y, x)));
      }
    }
  });
  return grid;
}

using Origin = std::tuple<double, double, double>;

Frame frame_of(std::optional<double> resolution, const Origin& origin, bool y_up) {
  const auto [x, y, heading] = origin;
  return {resolution.value_or(1), {x, y, heading}, y_up, resolution.has_value()};
}

GridMap occupancy_of(nb::handle array, std::optional<double> resolution, const Origin& origin,
                     int occupied_from, double cost_factor, bool y_up) {
  const auto grid = bytes_of<std::int8_t>(array);
  const nb::gil_scoped_release unlocked;
  return value_or_throw(map_from_occupancy(grid.values, grid.width, grid.height,
                                           frame_of(resolution, origin, y_up),
                                           {occupied_from, cost_factor}));
}

GridMap costmap_of(nb::handle array, std::optional<double> resolution, const Origin& origin,
                   double cost_factor, bool y_up) {
  const auto grid = bytes_of<std::uint8_t>(array);
  const nb::gil_scoped_release unlocked;
  return value_or_throw(map_from_costmap(grid.values, grid.width, grid.height,
                                         frame_of(resolution, origin, y_up), {cost_factor}));
}

std::pair<GridMap, std::vector<std::string>> mask_of(const std::filesystem::path& file,
                                                     const std::string& kind, double base,
                                                     double multiplier,
                                                     std::optional<double> top_speed) {
  if (kind != "keepout" && kind != "speed") {
    throw Failed(
        option_text::option_error("kind", option_text::unknown_choice(kind, {"keepout", "speed"})));
  }
  const MaskReading reading{.kind = kind == "speed" ? MaskKind::speed : MaskKind::keepout,
                            .speed = {base, multiplier, top_speed}};
  const nb::gil_scoped_release unlocked;
  LoadedMap loaded = value_or_throw(load_mask(file, reading));
  return {std::move(loaded.map), std::move(loaded.notes)};
}

GridMap map_under(const GridMap& map, const GridMap& mask) {
  const nb::gil_scoped_release unlocked;
  return value_or_throw(masked(map, mask));
}

GridMap map_with(const GridMap& map, nb::handle costs) {
  Grid<double> terrain =
      costs.is_none() ? Grid<double>() : costs_like(costs, map.width(), map.height());
  const nb::gil_scoped_release unlocked;
  return value_or_throw(with_terrain(map, std::move(terrain)));
}

}  // namespace

void bind_costs(nb::module_& module) {
  module.def("map_from_occupancy", &occupancy_of, nb::arg("array"), nb::arg("resolution").none(),
             nb::arg("origin"), nb::arg("occupied_from"), nb::arg("cost_factor"), nb::arg("y_up"));
  module.def("map_from_costmap", &costmap_of, nb::arg("array"), nb::arg("resolution").none(),
             nb::arg("origin"), nb::arg("cost_factor"), nb::arg("y_up"));
  module.def("load_mask", &mask_of, nb::arg("file"), nb::arg("kind"), nb::arg("base"),
             nb::arg("multiplier"), nb::arg("top_speed").none());
  module.def("masked", &map_under, nb::arg("map"), nb::arg("mask"));
  module.def("with_costs", &map_with, nb::arg("map"), nb::arg("costs").none());
}

}  // namespace wend::python
