#pragma once

// --escape, --nearest, --nearest-limit and --closest: what a query may do where the robot cannot be.

#include <optional>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/session/leeway.hpp"
#include "wend/session/plan_request.hpp"

namespace wend::cli {

struct LeewayArguments {
  bool nearest = false;
  std::optional<double> nearest_limit;  // in the user's units
  bool closest = false;
  double escape = 0;  // in the user's units

  /// --nearest, --nearest-limit and --closest.
  void add_ends_to(Parser& app);
  /// --escape.
  void add_escape_to(Parser& app);

  /// Throws InputError for --nearest-limit without --nearest.
  void check(const Parser& command) const;

  Leeway leeway(const Coordinates& coordinates) const;
  /// Lets a request do the same.
  void allow(PlanRequest& request, const Coordinates& coordinates) const;
};

}  // namespace wend::cli
