#pragma once

// FieldFlags: fields of a list as flags. Names, units, ranges, choices and help are those of the list, so that a new
// field has a flag.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/base/field.hpp"

namespace wend::cli {

/// The flag of a field, "--limit-time"; empty where the command line says it in another way.
std::string flag_of(const FieldInfo& field);

/// Is it a length, which is typed in the user's units?
bool is_length(const FieldInfo& field);

/// Adds the flag of a field, and of its former name. `take` gets each value that is typed.
Argument add_field(Parser& app, const FieldInfo& field, const std::function<void(double)>& take);

template <class Target>
class FieldFlags {
 public:
  /// The flag of a field, which must outlive the parsing.
  Argument add_to(Parser& app, const Field<Target>& field) {
    return add_field(app, field.info,
                     [this, &field](double value) { typed_.emplace_back(&field, value); });
  }

  /// What was typed for a field of this name.
  std::optional<double> typed(std::string_view name) const {
    for (const auto& [field, value] : typed_) {
      if (field->info.is_called(name)) return value;
    }
    return std::nullopt;
  }

  /// Sets what was typed, with lengths as they were typed.
  void put(Target& target) const {
    for (const auto& [field, value] : typed_) field->put(target, value, 1);
  }
  /// The same with lengths in metres.
  void put(Target& target, const Coordinates& units) const {
    for (const auto& [field, value] : typed_) {
      field->put(target, is_length(field->info) ? units.in_metres(value) : value,
                 units.frame().resolution);
    }
  }

 private:
  std::vector<std::pair<const Field<Target>*, double>> typed_;
};

}  // namespace wend::cli
