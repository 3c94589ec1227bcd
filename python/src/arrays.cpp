#include "python/src/arrays.hpp"

#include <cmath>

namespace nb = nanobind;

namespace wend::python {

BufferView::BufferView(nb::handle object, std::string name) : name_(std::move(name)) {
  if (PyObject_GetBuffer(object.ptr(), &view_, PyBUF_RECORDS_RO) != 0) {
    PyErr_Clear();
    throw_failure(Status::invalid_map, name_ + " must be an array of numbers", name_);
  }
  if (view_.ndim == 2 && view_.shape[0] > 0 && view_.shape[1] > 0) return;
  std::string shape;
  for (int i = 0; i < view_.ndim; ++i)
    shape += (i > 0 ? ", " : "") + std::to_string(view_.shape[i]);
  PyBuffer_Release(&view_);
  throw_failure(
      Status::invalid_map,
      name_ + " has the shape (" + shape + "): it must have one row and one column or more", name_);
}

char BufferView::type() const {
  const char* format = view_.format == nullptr ? "B" : view_.format;
  if (*format == '@' || *format == '=' || *format == '<') ++format;
  if (*format == '\0' || format[1] != '\0') return '\0';
  if (*format == 'l') return view_.itemsize == 8 ? 'q' : 'i';
  if (*format == 'L') return view_.itemsize == 8 ? 'Q' : 'I';
  return *format;
}

void BufferView::refuse_type() const {
  throw_failure(Status::invalid_map, name_ + " must have numbers or booleans", name_);
}

namespace {

[[noreturn]] void refuse_coordinates(const std::string& name) {
  PyErr_Clear();
  throw_failure(Status::invalid_option, name + " must be (x, y) or (x, y, heading)", name);
}

}  // namespace

Coordinates coordinates_of(nb::handle sequence, const std::string& name) {
  const Py_ssize_t size =
      PySequence_Check(sequence.ptr()) != 0 ? PySequence_Size(sequence.ptr()) : 0;
  if (size != 2 && size != 3) refuse_coordinates(name);
  Coordinates read;
  read.has_heading = size == 3;
  for (Py_ssize_t i = 0; i < size; ++i) {
    const nb::object item = nb::steal(PySequence_GetItem(sequence.ptr(), i));
    const double value = item.is_valid() ? PyFloat_AsDouble(item.ptr()) : -1;
    if (value == -1 && PyErr_Occurred() != nullptr) refuse_coordinates(name);
    if (!std::isfinite(value)) {
      throw_failure(
          Status::invalid_option,
          name + "[" + std::to_string(i) + "] is " + (std::isnan(value) ? "NaN" : "infinite"),
          name);
    }
    read.values[static_cast<std::size_t>(i)] = value;
  }
  return read;
}

}  // namespace wend::python
