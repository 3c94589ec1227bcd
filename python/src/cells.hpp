#pragma once

// Cells of a map from Python: 0 is free, 1 an obstacle, -1 unknown.

#include <nanobind/nanobind.h>

#include <array>
#include <cstddef>
#include <string>

#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend::python {

/// The occupied and the unknown cells.
struct Planes {
  BitGrid occupied;
  BitGrid unknown;
};

/// Reads an array with a buffer. `name` is the argument's, for errors. Throws Failed.
Planes planes_of(nanobind::handle array, const std::string& name);

/// The same of a list of lists of int, float or bool, which it reads faster than NumPy could convert it. False
/// if it is something else.
bool read_rows(nanobind::handle rows, const std::string& name, Planes& planes);

/// Reads the multipliers of an array "costs": finite and at least 1. Throws Failed.
Grid<double> costs_of(nanobind::handle array);

/// The same for a map of this size: other shapes are refused.
Grid<double> costs_like(nanobind::handle array, int width, int height);

/// "array[3, 4] is 7"
std::string indexed(const std::string& name, long row, long column, double value);

/// (height, width), as NumPy writes it.
template <class Layer>
std::array<std::size_t, 2> shape_of(const Layer& layer) {
  return {static_cast<std::size_t>(layer.height()), static_cast<std::size_t>(layer.width())};
}

}  // namespace wend::python
