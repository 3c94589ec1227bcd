// SPDX-License-Identifier: Apache-2.0
#pragma once

// RequestSettings: the fields of a request that users set of wend_nav2/Planner, from their list. Some have the names and
// defaults of Nav2's planners.

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/options.hpp"
#include "wend/session/request_fields.hpp"

namespace wend_nav2 {

/// The fields as parameters.
std::vector<wend::OptionInfo> request_parameters();

class RequestSettings {
 public:
  /// The defaults.
  RequestSettings();

  /// Sets the field of a parameter. False if it has none; fails with invalid_option.
  wend::Expected<bool, wend::Error> set(std::string_view parameter, std::string_view value);

  /// The value of a field, by the field's own name.
  double operator[](std::string_view field) const;

  /// Puts all into a request that has its goals, on a map of this resolution.
  void put(wend::PlanRequest& request, double resolution) const;

  friend bool operator==(const RequestSettings&, const RequestSettings&) = default;

 private:
  std::vector<std::pair<const wend::RequestField*, double>> values_;
};

}  // namespace wend_nav2
