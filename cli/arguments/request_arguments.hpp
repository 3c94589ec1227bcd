#pragma once

// RequestArguments: the fields of a request as flags.

#include <string_view>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/field_flags.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/session/leeway.hpp"
#include "wend/session/plan_request.hpp"
#include "wend/session/request_fields.hpp"

namespace wend::cli {

class RequestArguments {
 public:
  RequestArguments() = default;
  ~RequestArguments() = default;
  RequestArguments(const RequestArguments&) = delete;  // the app's callbacks point here
  RequestArguments& operator=(const RequestArguments&) = delete;

  /// Adds the flags of these fields.
  void add_to(Parser& app, const std::vector<std::string_view>& fields);
  /// Those of the limits on a search, which commands without a request take too.
  void add_limits_to(Parser& app);
  /// Those of all fields that have one, but for the limits and these.
  void add_others_to(Parser& app, const std::vector<std::string_view>& fields = {});

  /// Throws InputError for --nearest-limit without --nearest.
  void check(const Parser& command) const;

  /// Sets what was typed in a request; lengths are in the user's units.
  void put(PlanRequest& request, const Coordinates& coordinates) const;
  /// The same of the limits, which have no lengths.
  void put(Limits& limits) const;
  /// What put() lets a request do.
  Leeway leeway(const Coordinates& coordinates) const;

 private:
  void add(Parser& app, const RequestField& field);

  FieldFlags<PlanRequest> flags_;
};

}  // namespace wend::cli
