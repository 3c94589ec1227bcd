#include "python/src/errors.hpp"

#include "python/src/metrics.hpp"
#include "wend/session/plan_request.hpp"

namespace nb = nanobind;

namespace wend::python {

nb::object exception_of(const Failed& failed, const nb::object& unread) {
  const Error& error = failed.error;
  const std::string status(to_string(error.status));
  nb::object work = nb::none();
  if (failed.work) {
    work = numbers_of(metrics_of(*failed.work));
  }
  const nb::object make_error = nb::module_::import_("wend._errors").attr("make_error");
  return make_error(nb::str(status.c_str()), nb::str(error.message.data(), error.message.size()),
                    nb::str(error.where.data(), error.where.size()), work, unread);
}

void raise(const nb::object& exception) {
  PyErr_SetObject(exception.type().ptr(), exception.ptr());
  throw nb::python_error();
}

void translate_errors() {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Failed& failed) {
      try {
        const nb::object error = exception_of(failed);
        PyErr_SetObject(error.type().ptr(), error.ptr());
      } catch (nb::python_error& other) {
        other.restore();
      }
    }
  });
}

}  // namespace wend::python
