#include "bench/measure/statistics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace wend {
namespace {

TEST(Summary, OfFewValues) {
  const Summary summary = summary_of({4, 1, 10, 3});
  EXPECT_EQ(summary.median, 3) << "one of the values, the lower of the two in the middle";
  EXPECT_EQ(summary.mean, 4.5);
  EXPECT_EQ(summary.p99, 10);
}

TEST(Summary, OfNothingIsNoNumber) {
  const Summary summary = summary_of({});
  EXPECT_TRUE(std::isnan(summary.median) && std::isnan(summary.mean) && std::isnan(summary.p99));
}

TEST(Quantile, OfAShareThatDoublesDoNotHoldIsExact) {
  std::vector<double> values(25);
  std::iota(values.begin(), values.end(), 1.0);
  EXPECT_EQ(quantile(values, 0.28), 7) << "7 of 25 are 0.28, though 0.28 * 25 > 7 in doubles";
}

RC_GTEST_PROP(Quantile, IsTheLeastValueThatSoManyDoNotExceed, ()) {
  auto values = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<double>>(rc::gen::cast<double>(rc::gen::inRange(-50, 50))));
  const double share = *rc::gen::inRange(0, 101) / 100.0;
  std::sort(values.begin(), values.end());
  const double result = quantile(values, share);
  const auto no_larger_than = [&](double bound) {
    const auto count = std::count_if(values.begin(), values.end(),
                                     [bound](double value) { return value <= bound; });
    return static_cast<double>(count) / static_cast<double>(values.size());
  };
  RC_ASSERT(no_larger_than(result) >= share - 1e-12);
  for (const double value : values) {
    RC_ASSERT(value >= result || no_larger_than(value) < share);
  }
}

}  // namespace
}  // namespace wend
