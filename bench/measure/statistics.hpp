#pragma once

// Statistics of many values.

#include <span>
#include <vector>

namespace wend {

/// The least value that at least a share (0 to 1) of the values does not exceed (nearest rank; nothing
/// is interpolated). `sorted` is ascending and not empty. O(1).
double quantile(std::span<const double> sorted, double share);

struct Summary {
  double median;
  double mean;
  double p99;  // 99 of 100 values are no larger
};

/// NaN without values. O(n log n).
Summary summary_of(std::vector<double> values);

}  // namespace wend
