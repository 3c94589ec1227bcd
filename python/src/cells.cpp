#include "python/src/cells.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include "python/src/arrays.hpp"
#include "wend/base/parse.hpp"
#include "wend/map/grid_map.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

constexpr const char* kStates = ": use 0 (free), 1 (obstacle) or -1 (unknown)";

[[noreturn]] void refuse_state(const std::string& name, long row, long column, double value) {
  throw_failure(Status::invalid_map, indexed(name, row, column, value) + kStates, name);
}

[[noreturn]] void refuse_length(const std::string& name, Py_ssize_t row, Py_ssize_t length,
                                Py_ssize_t first) {
  throw_failure(Status::invalid_map,
                name + "[" + std::to_string(row) + "] has " + std::to_string(length) + " values, " +
                    name + "[0] has " + std::to_string(first),
                name);
}

void check_size(const std::string& name, Py_ssize_t rows, Py_ssize_t columns) {
  const auto most = static_cast<Py_ssize_t>(GridMap::kMaxCells);
  if (rows > most || columns > most || rows * columns > most) {
    throw_failure(Status::invalid_map, name + " has more than " + std::to_string(most) + " cells",
                  name);
  }
}

Planes empty_planes(Py_ssize_t rows, Py_ssize_t columns) {
  const int width = static_cast<int>(columns);
  const int height = static_cast<int>(rows);
  return {BitGrid(width, height), BitGrid(width, height)};
}

void set_bit(std::span<std::uint64_t> words, Py_ssize_t x) {
  words[static_cast<std::size_t>(x + 1) / 64] |= std::uint64_t{1}
                                                 << (static_cast<unsigned>(x + 1) % 64);
}

template <class T>
constexpr bool is_unknown(T value) {
  if constexpr (std::is_signed_v<T>) return value == T{-1};
  return false;
}

template <class Values>
void read(const Values& values, const std::string& name, Planes& planes) {
  for (Py_ssize_t y = 0; y < values.rows; ++y) {
    const auto occupied = planes.occupied.row_words(static_cast<int>(y));
    const auto unknown = planes.unknown.row_words(static_cast<int>(y));
    for (Py_ssize_t x = 0; x < values.columns; ++x) {
      const auto value = values.at(y, x);
      if (value == 0) continue;
      if (value == 1) {
        set_bit(occupied, x);
      } else if (is_unknown(value)) {
        set_bit(unknown, x);
      } else {
        refuse_state(name, y, x, static_cast<double>(value));
      }
    }
  }
}

/// An int, a float or a bool; false for anything else.
bool read_number(PyObject* item, double& value) {
  if (PyLong_Check(item)) {
    int overflow = 0;
    value = static_cast<double>(PyLong_AsLongLongAndOverflow(item, &overflow));
    if (overflow != 0) value = overflow * std::numeric_limits<double>::infinity();
    return true;
  }
  if (!PyFloat_Check(item)) return false;
  value = PyFloat_AsDouble(item);
  return true;
}

}  // namespace

std::string indexed(const std::string& name, long row, long column, double value) {
  return name + "[" + std::to_string(row) + ", " + std::to_string(column) + "] is " +
         format_number(value);
}

Planes planes_of(nb::handle array, const std::string& name) {
  const BufferView view(array, name);
  check_size(name, view.rows(), view.columns());
  Planes planes = empty_planes(view.rows(), view.columns());
  view.visit([&](const auto& values) { read(values, name, planes); });
  return planes;
}

Grid<double> costs_of(nb::handle array) {
  const BufferView view(array, "costs");
  check_size("costs", view.rows(), view.columns());
  Grid<double> costs(static_cast<int>(view.columns()), static_cast<int>(view.rows()));
  view.visit([&](const auto& values) {
    for (const Cell cell : every_cell(costs)) {
      const auto cost = static_cast<double>(values.at(cell.y, cell.x));
      if (!(cost >= 1 && std::isfinite(cost))) {
        throw_failure(Status::invalid_map,
                      indexed("costs", cell.y, cell.x, cost) + ": costs are finite and at least 1",
                      "costs");
      }
      costs[cell] = cost;
    }
  });
  return costs;
}

Grid<double> costs_like(nb::handle array, int width, int height) {
  Grid<double> costs = costs_of(array);
  if (costs.height() != height || costs.width() != width) {
    throw_failure(Status::invalid_map,
                  "costs has the shape (" + std::to_string(costs.height()) + ", " +
                      std::to_string(costs.width()) + "), the map has (" + std::to_string(height) +
                      ", " + std::to_string(width) + ")",
                  "costs");
  }
  return costs;
}

bool read_rows(nb::handle rows, const std::string& name, Planes& planes) {
  if (!PyList_Check(rows.ptr())) return false;
  const Py_ssize_t height = PyList_Size(rows.ptr());
  if (height == 0) return false;
  PyObject* const first = PyList_GetItem(rows.ptr(), 0);
  if (!PyList_Check(first)) return false;
  const Py_ssize_t width = PyList_Size(first);
  if (width == 0) return false;
  check_size(name, height, width);
  planes = empty_planes(height, width);
  for (Py_ssize_t y = 0; y < height; ++y) {
    PyObject* const row = PyList_GetItem(rows.ptr(), y);
    if (!PyList_Check(row)) return false;
    if (PyList_Size(row) != width) refuse_length(name, y, PyList_Size(row), width);
    const auto occupied = planes.occupied.row_words(static_cast<int>(y));
    const auto unknown = planes.unknown.row_words(static_cast<int>(y));
    for (Py_ssize_t x = 0; x < width; ++x) {
      double value = 0;
      if (!read_number(PyList_GetItem(row, x), value)) return false;
      if (value == 1) set_bit(occupied, x);
      if (value == -1) set_bit(unknown, x);
      if (value != 0 && value != 1 && value != -1) refuse_state(name, y, x, value);
    }
  }
  return true;
}

}  // namespace wend::python
