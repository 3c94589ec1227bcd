// wend._core: what the Python package wend is made of. Thin: the package's own modules have the interface, its
// checks of arguments and its documentation.

#include "python/src/bindings.hpp"
#include "python/src/errors.hpp"
#include "wend/version.hpp"

NB_MODULE(_core, module) {  // NOLINT(cppcoreguidelines-pro-type-cstyle-cast): of nanobind
  module.doc() = "The C++ side of wend.";
  module.attr("version") = WEND_VERSION;
  wend::python::translate_errors();
  wend::python::bind_map(module);
  wend::python::bind_costs(module);
  wend::python::bind_plan(module);
  wend::python::bind_trace(module);
  wend::python::bind_solutions(module);
  wend::python::bind_space(module);
  wend::python::bind_registry(module);
  wend::python::bind_search(module);
}
