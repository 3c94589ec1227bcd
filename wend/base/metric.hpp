#pragma once

// Metric: a number that tells how a path or a search is, with its name, unit and meaning. Reports and front ends
// iterate over such lists, so that a new metric is a member of its struct and a line of its list.
//
//   for (const wend::Metric& metric : wend::metrics_of(*wend::measure(path, space))) {
//     std::cout << metric.name << ": " << metric.value << '\n';
//   }

#include <string_view>

namespace wend {

/// The unit of a metric.
enum class MetricUnit {
  count,    // a whole number
  cells,    // a length in grid coordinates; front ends show metres
  radians,  // an angle; people see degrees
};

/// One number of a list.
struct Metric {
  std::string_view name;  // lower case, with underscores
  MetricUnit unit;        // of the value
  std::string_view help;  // what it is, in a sentence without its full stop
  double value;           // counts are exact up to 2^53

  /// The value with lengths in metres.
  double in_metres(double resolution) const {
    return unit == MetricUnit::cells ? value * resolution : value;
  }
};

/// The unit of in_metres(): "m", "rad", or "" for a count.
constexpr std::string_view metric_unit_name(MetricUnit unit) {
  switch (unit) {
    case MetricUnit::cells:
      return "m";
    case MetricUnit::radians:
      return "rad";
    case MetricUnit::count:
      break;
  }
  return "";
}

}  // namespace wend
