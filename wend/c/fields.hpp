#pragma once

// What callers set by name, and what they are told of it: fields of requests and of robots.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/field.hpp"
#include "wend/base/registry.hpp"
#include "wend/c/boundary.hpp"
#include "wend/wend.h"

namespace wend::c {

/// The field that a caller names. `target` says of what: "request".
template <class Target>
Expected<const Field<Target>*, Failure> field_named(std::span<const Field<Target>> fields,
                                                    const char* name, std::string_view target) {
  if (name == nullptr) return refused("name is null");
  if (const Field<Target>* const field = find_field(fields, std::string_view(name))) return field;
  std::vector<std::string> names;
  for (const Field<Target>& field : fields) names.emplace_back(field.info.name);
  const std::string kind = "field of a " + std::string(target);
  return failed(Error{Status::invalid_option, unknown_name(kind, name, names), {}});
}

/// Tells a caller of a field.
template <class Target>
wend_status field_at(std::span<const Field<Target>> fields, std::size_t index,
                     wend_field_info* info) noexcept {
  if (index >= fields.size() || info == nullptr) return WEND_INVALID_ARGUMENT;
  const FieldInfo& field = fields[index].info;
  const std::int32_t is_flag = field.kind == OptionKind::flag ? 1 : 0;
  *info = {field.name.data(), field.unit.data(),  field.help.data(), is_flag, 0,
           field.greatest,    field.default_value};
  return WEND_OK;
}

}  // namespace wend::c
