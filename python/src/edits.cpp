// _core.Space: edits of its map.

#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/cells.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/space.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

/// x, y, width and height of the cells that may differ.
using Boxes = std::vector<std::tuple<int, int, int, int>>;

Boxes changed_by(Space& space, const MapEdit& edit) {
  Interrupts interrupts;
  Limits limits;
  interrupts.watch(limits);
  auto edited = unlocked([&] { return space.edit(edit, Deadline(limits)); });
  interrupts.throw_if_interrupted();
  const SpaceChange change = value_or_throw(std::move(edited));
  Boxes boxes;
  if (change.everything) {
    const FreeSpace now = space.view().space;
    boxes.emplace_back(0, 0, now.width(), now.height());
  }
  for (const CellBox& box : change.boxes) {
    boxes.emplace_back(box.begin.x, box.begin.y, box.width(), box.height());
  }
  return boxes;
}

int coordinate_of(std::int64_t value) {
  // Far off every map, so that the edit says which cell is not on it.
  constexpr std::int64_t kFar = GridMap::kMaxCells;
  return static_cast<int>(std::clamp(value, -kFar, kFar));
}

Grid<CellState> states_of(const Planes& planes) {
  Grid<CellState> states(planes.occupied.width(), planes.occupied.height(), CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (planes.occupied[cell]) states[cell] = CellState::occupied;
    if (planes.unknown[cell]) states[cell] = CellState::unknown;
  }
  return states;
}

/// A box whose cell (0, 0) goes to (x, y). At least one of the arrays is there.
Boxes edit_box(Space& space, std::int64_t x, std::int64_t y, nb::handle array, nb::handle costs) {
  MapEdit edit{.corner = {coordinate_of(x), coordinate_of(y)}};
  if (!array.is_none()) {
    const Planes planes = planes_of(array, "array");
    edit.states = unlocked([&] { return states_of(planes); });
  }
  if (!costs.is_none()) edit.terrain = costs_of(costs);
  return changed_by(space, edit);
}

/// `cells` has rows of x, y and state, `costs` a value in each row, or is None.
Boxes edit_cells(Space& space, nb::handle cells, nb::handle costs) {
  MapEdit edit;
  const BufferView rows(cells, "cells");
  rows.visit([&](const auto& values) {
    const auto number = [&](Py_ssize_t row, Py_ssize_t column) {
      return static_cast<std::int64_t>(values.at(row, column));
    };
    for (Py_ssize_t i = 0; i < values.rows; ++i) {
      const std::int64_t state = number(i, 2);
      const Cell cell{coordinate_of(number(i, 0)), coordinate_of(number(i, 1))};
      edit.cells.push_back({cell, state == 0   ? CellState::free
                                  : state == 1 ? CellState::occupied
                                               : CellState::unknown});
    }
  });
  if (!costs.is_none()) {
    const BufferView given(costs, "costs");
    given.visit([&](const auto& values) {
      for (std::size_t i = 0; i < edit.cells.size(); ++i) {
        edit.cells[i].terrain = static_cast<double>(values.at(static_cast<Py_ssize_t>(i), 0));
      }
    });
  }
  return changed_by(space, edit);
}

}  // namespace

void bind_edits(nb::class_<Space>& space) {
  space
      .def("edit", &edit_box, nb::arg("x"), nb::arg("y"), nb::arg("array").none(),
           nb::arg("costs").none())
      .def("edit_cells", &edit_cells, nb::arg("cells"), nb::arg("costs").none());
}

}  // namespace wend::python
