#pragma once

// Fields of a robot or a request as the page sends them: "request:escape=3,closest=true".

#include <optional>
#include <span>
#include <string_view>

#include "wend/base/field.hpp"

namespace wend::lab {

/// Puts the fields of a text into a target. Returns what is wrong.
template <class Target>
std::optional<Error> put_fields(std::string_view text, std::string_view name,
                                std::span<const Field<Target>> fields, double resolution,
                                Target& target) {
  const auto specs = parse_option_specs(text, "part", {std::string(name)});
  if (!specs) return specs.error();
  for (const auto& [field_name, value] : specs->front().options) {
    const Field<Target>* const field = find_field(fields, field_name);
    if (field == nullptr) {
      return Error{Status::invalid_option,
                   "no field of a " + std::string(name) + " is called " + field_name};
    }
    const auto number = field->info.number_of(value);
    if (!number) return number.error();
    field->put(target, *number, resolution);
  }
  return std::nullopt;
}

}  // namespace wend::lab
