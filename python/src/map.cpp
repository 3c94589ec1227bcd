// _core.Map: a GridMap made from arrays or a file.

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <tuple>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/cells.hpp"
#include "python/src/interrupts.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/save_map.hpp"
#include "wend/map/grid_map.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

GridMap map_of(nb::handle array, std::optional<double> resolution,
               std::tuple<double, double, double> origin, nb::handle costs, bool y_up) {
  Planes planes = planes_of(array, "array");
  const auto [x, y, heading] = origin;
  const Frame frame{resolution.value_or(1), {x, y, heading}, y_up, resolution.has_value()};
  Grid<double> terrain = costs.is_none()
                             ? Grid<double>()
                             : costs_like(costs, planes.occupied.width(), planes.occupied.height());
  return unlocked([&] {
    return value_or_throw(make_grid_map(std::move(planes.occupied), std::move(planes.unknown),
                                        frame, std::move(terrain)));
  });
}

auto states_of(const GridMap& map) {
  auto states = unlocked([&] {
    std::vector<std::int8_t> found;
    found.reserve(map.size());
    for (const Cell cell : every_cell(map)) {
      const CellState state = map.state(cell);
      found.push_back(state == CellState::free       ? std::int8_t{0}
                      : state == CellState::occupied ? std::int8_t{1}
                                                     : std::int8_t{-1});
    }
    return found;
  });
  return owned_array<std::int8_t, 2>(std::move(states), shape_of(map));
}

auto terrain_of(const GridMap& map) {
  auto costs = unlocked([&] {
    if (map.uniform_terrain()) return std::vector<double>(map.size(), 1);
    const auto values = map.terrain().values();
    return std::vector<double>(values.begin(), values.end());
  });
  return owned_array<double, 2>(std::move(costs), shape_of(map));
}

}  // namespace

void bind_map(nb::module_& module) {
  nb::class_<GridMap>(module, "Map", "The content of a map file.")
      .def_prop_ro("width", &GridMap::width)
      .def_prop_ro("height", &GridMap::height)
      .def_prop_ro("resolution", [](const GridMap& map) { return map.frame().resolution; })
      .def_prop_ro("metric", [](const GridMap& map) { return map.frame().metric; })
      .def_prop_ro("y_up", [](const GridMap& map) { return map.frame().y_up; })
      .def_prop_ro("uniform", &GridMap::uniform_terrain)
      .def_prop_ro("origin",
                   [](const GridMap& map) {
                     const MapPose& at = map.frame().origin;
                     return std::tuple(at.x, at.y, at.heading);
                   })
      .def("states", &states_of)
      .def("terrain", &terrain_of)
      .def("save", [](const GridMap& map, const std::filesystem::path& file) {
        const nb::gil_scoped_release unlocked;
        value_or_throw(save_map(map, file));
      });
  module.def("make_map", &map_of, nb::arg("array"), nb::arg("resolution").none(), nb::arg("origin"),
             nb::arg("costs").none(), nb::arg("y_up"));
  module.def(
      "load_map",
      [](const std::filesystem::path& file, std::optional<double> resolution) {
        const nb::gil_scoped_release unlocked;
        LoadedMap loaded = value_or_throw(load_map(file, {.resolution = resolution}));
        return std::pair(std::move(loaded.map), std::move(loaded.notes));
      },
      nb::arg("file"), nb::arg("resolution").none());
}

}  // namespace wend::python
