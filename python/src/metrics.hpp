#pragma once

// Lists of metrics as Python reads them.

#include <nanobind/nanobind.h>

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "wend/base/metric.hpp"

namespace wend::python {

/// The values, lengths in metres.
inline nanobind::list numbers_of(std::span<const Metric> metrics, double resolution = 1) {
  nanobind::list numbers;
  for (const Metric& metric : metrics) {
    if (metric.unit == MetricUnit::count) {
      numbers.append(static_cast<std::uint64_t>(metric.value));
    } else {
      numbers.append(metric.in_metres(resolution));
    }
  }
  return numbers;
}

/// Name, unit and meaning of each.
inline std::vector<std::tuple<std::string_view, std::string_view, std::string_view>> fields_of(
    std::span<const Metric> metrics) {
  std::vector<std::tuple<std::string_view, std::string_view, std::string_view>> fields;
  for (const Metric& metric : metrics) {
    fields.emplace_back(metric.name, metric_unit_name(metric.unit), metric.help);
  }
  return fields;
}

}  // namespace wend::python
