#pragma once

// Fields of a request or a robot by name, as keyword arguments give them.

#include <nanobind/nanobind.h>
#include <nanobind/stl/string_view.h>

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "python/src/errors.hpp"
#include "wend/base/field.hpp"

namespace wend::python {

/// A value of Python as a number. Raises a TypeError with the field's name, or Failed for text that is not a choice.
double number_of(const FieldInfo& field, nanobind::handle value);

/// May the value be None?
bool may_be_none(const FieldInfo& field);

/// Name, other names, kind, unit, default (None where there is none) and meaning.
nanobind::tuple tuple_of(const FieldInfo& field);

template <class Target>
nanobind::list list_of(std::span<const Field<Target>> fields) {
  nanobind::list list;
  for (const Field<Target>& field : fields) list.append(tuple_of(field.info));
  return list;
}

template <class Target>
class FieldValues {
 public:
  /// A value of a field that the user calls `name`.
  void take(const Field<Target>& field, std::string_view name, double value) {
    if (auto fault = field.info.fault_of(value, name)) throw Failed(*std::move(fault));
    values_.emplace_back(&field, value);
  }

  /// All of a dictionary; None is left out where it may be.
  void take(std::span<const Field<Target>> fields, const nanobind::dict& arguments) {
    for (const auto [key, value] : arguments) {
      const auto name = nanobind::cast<std::string_view>(key);
      const Field<Target>* const field = find_field(fields, name);
      if (field == nullptr || (value.is_none() && may_be_none(field->info))) continue;
      take(*field, name, number_of(field->info, value));
    }
  }

  void put(Target& target, double resolution) const {
    for (const auto& [field, value] : values_) field->put(target, value, resolution);
  }

 private:
  std::vector<std::pair<const Field<Target>*, double>> values_;
};

}  // namespace wend::python
