#pragma once

// The parts of the module wend._core, one function for each source.

#include <nanobind/nanobind.h>

namespace wend::python {

void bind_costs(nanobind::module_& module);
void bind_map(nanobind::module_& module);
void bind_plan(nanobind::module_& module);
void bind_registry(nanobind::module_& module);
void bind_search(nanobind::module_& module);
void bind_solutions(nanobind::module_& module);
void bind_space(nanobind::module_& module);
void bind_trace(nanobind::module_& module);

}  // namespace wend::python
