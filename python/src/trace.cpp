// _core.Recording: the events of a search as arrays.

#include "python/src/trace.hpp"

#include <limits>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"

namespace nb = nanobind;

namespace wend::python {

void Recording::add(EventKind kind, const SearchEvent& event) {
  const Cell parent = event.parent.value_or(Cell{-1, -1});
  kinds.push_back(static_cast<std::uint8_t>(kind));
  cells.insert(cells.end(), {event.cell.x, event.cell.y});
  parents.insert(parents.end(), {parent.x, parent.y});
  costs.insert(costs.end(), {event.g, event.h, event.f});
  headings.push_back(event.heading.value_or(std::numeric_limits<double>::quiet_NaN()));
  for (const Pose& pose : event.way) ways.insert(ways.end(), {pose.x, pose.y, pose.heading});
  ends.push_back(ways.size() / 3);
}

void bind_trace(nb::module_& module) {
  nb::class_<Recording>(module, "Recording", "The events of a search, in columns.")
      .def(nb::init<>())
      .def_ro("on_corners", &Recording::on_corners)
      .def("kinds",
           [](const Recording& events) {
             return owned_array<std::uint8_t, 1>(events.kinds, {events.kinds.size()});
           })
      .def("cells",
           [](const Recording& events) {
             return owned_array<std::int32_t, 2>(events.cells, {events.kinds.size(), 2});
           })
      .def("parents",
           [](const Recording& events) {
             return owned_array<std::int32_t, 2>(events.parents, {events.kinds.size(), 2});
           })
      .def("costs",
           [](const Recording& events) {
             return owned_array<double, 2>(events.costs, {events.kinds.size(), 3});
           })
      .def("headings",
           [](const Recording& events) {
             return owned_array<double, 1>(events.headings, {events.kinds.size()});
           })
      .def("ways",
           [](const Recording& events) {
             return owned_array<double, 2>(events.ways, {events.ways.size() / 3, 3});
           })
      .def("ends", [](const Recording& events) {
        return owned_array<std::uint64_t, 1>(events.ends, {events.ends.size()});
      });
}

}  // namespace wend::python
