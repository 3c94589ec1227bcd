#pragma once

// Arrays between Python and C++. In: BufferView reads any buffer of numbers with two dimensions in place,
// whatever its type and its strides. Out: arrays that own their values.

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "python/src/errors.hpp"
#include "wend/geometry/map_pose.hpp"

namespace wend::python {

/// A grid of numbers in somebody else's memory, row by row, with strides in bytes of any sign.
template <class T>
struct Strided {
  using Value = T;

  const char* data;
  Py_ssize_t rows;
  Py_ssize_t columns;
  Py_ssize_t row_stride;
  Py_ssize_t column_stride;

  /// The value; T need not be aligned.
  T at(Py_ssize_t y, Py_ssize_t x) const {
    T value;
    std::memcpy(&value, data + y * row_stride + x * column_stride, sizeof value);
    return value;
  }
};

/// A Python object's buffer, held while this object lives.
class BufferView {
 public:
  /// `name` is the argument's, for errors. Throws Failed if the object is not a grid of one cell or more.
  BufferView(nanobind::handle object, std::string name);
  ~BufferView() { PyBuffer_Release(&view_); }
  BufferView(const BufferView&) = delete;
  BufferView& operator=(const BufferView&) = delete;

  Py_ssize_t rows() const { return view_.shape[0]; }
  Py_ssize_t columns() const { return view_.shape[1]; }

  /// Calls visitor(Strided<T>) with the type of the numbers, without the interpreter lock. bool is read as a byte.
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    const nanobind::gil_scoped_release unlocked;
    switch (type()) {
      case '?':
      case 'B':
        return visitor(strided<std::uint8_t>());
      case 'b':
        return visitor(strided<std::int8_t>());
      case 'H':
        return visitor(strided<std::uint16_t>());
      case 'h':
        return visitor(strided<std::int16_t>());
      case 'I':
        return visitor(strided<std::uint32_t>());
      case 'i':
        return visitor(strided<std::int32_t>());
      case 'Q':
        return visitor(strided<std::uint64_t>());
      case 'q':
        return visitor(strided<std::int64_t>());
      case 'f':
        return visitor(strided<float>());
      case 'd':
        return visitor(strided<double>());
      default:
        refuse_type();
    }
  }

 private:
  template <class T>
  Strided<T> strided() const {
    return {static_cast<const char*>(view_.buf), view_.shape[0], view_.shape[1], view_.strides[0],
            view_.strides[1]};
  }

  /// The buffer's format; 'l' and 'L' by their size.
  char type() const;
  [[noreturn]] void refuse_type() const;

  std::string name_;
  Py_buffer view_{};
};

/// An array of this shape that owns its values, row by row.
template <class T, std::size_t Dimensions>
nanobind::ndarray<nanobind::numpy, T, nanobind::ndim<Dimensions>> owned_array(
    std::vector<T> values, const std::array<std::size_t, Dimensions>& shape) {
  auto* const kept = new std::vector<T>(std::move(values));
  const nanobind::capsule owner(
      kept, [](void* pointer) noexcept { delete static_cast<std::vector<T>*>(pointer); });
  return nanobind::ndarray<nanobind::numpy, T, nanobind::ndim<Dimensions>>(kept->data(), Dimensions,
                                                                           shape.data(), owner);
}

/// (x, y) or (x, y, heading), for a start, a goal or a corner. `name` is the argument's, for errors.
struct Coordinates {
  std::array<double, 3> values{};  // metres, metres, radians
  bool has_heading = false;

  MapPose pose() const { return {values[0], values[1], values[2]}; }
};

/// Reads a sequence of two or three finite numbers. Throws Failed.
Coordinates coordinates_of(nanobind::handle sequence, const std::string& name);

}  // namespace wend::python
