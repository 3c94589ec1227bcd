#include "python/src/fields.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace nb = nanobind;

namespace wend::python {

double number_of(const FieldInfo& field, nb::handle value) {
  try {
    switch (field.kind) {
      case OptionKind::flag:
        return nb::cast<bool>(value) ? 1 : 0;
      case OptionKind::number:
        return nb::cast<double>(value);
      case OptionKind::integer:
        return static_cast<double>(nb::cast<std::int64_t>(value));
      case OptionKind::choice:
        return value_or_throw(field.number_of(nb::cast<std::string>(value)));
    }
  } catch (const nb::cast_error&) {
  }
  throw nb::type_error(std::string(field.name).c_str());
}

bool may_be_none(const FieldInfo& field) {
  return field.option().default_value.empty() || !std::isfinite(field.default_value);
}

nb::tuple tuple_of(const FieldInfo& field) {
  const OptionInfo option = field.option();
  nb::object default_value = nb::none();
  if (field.kind != OptionKind::choice) {
    default_value = nb::cast(field.default_value);
  } else if (!option.default_value.empty()) {
    default_value = nb::cast(option.default_value);
  }
  return nb::make_tuple(option.name, option.aliases, std::string(to_string(field.kind)), field.unit,
                        default_value, option.help);
}

}  // namespace wend::python
