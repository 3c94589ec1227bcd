#include "wend/base/parse_in_range.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

std::string wrong_with(std::string_view text, std::string_view unit = {}) {
  double value = 0;
  return parse_in_range(text, value, 0, 5, unit);
}

TEST(ParseInRange, TakesNumbersUpToTheEndsOfTheRange) {
  for (const double number : {0.0, 0.2, 5.0}) {
    double value = -1;
    EXPECT_EQ(parse_in_range(std::to_string(number), value, 0, 5), "");
    EXPECT_DOUBLE_EQ(value, number);
  }
}

TEST(ParseInRange, NamesTheRangeWithItsUnit) {
  EXPECT_EQ(wrong_with("5.1"), "'5.1' is not between 0 and 5");
  EXPECT_EQ(wrong_with("5.1", "m/s"), "'5.1' is not between 0 and 5 m/s");
  for (const std::string text : {"-1", "1e308", "1e999", "-1e999", "inf"}) {
    EXPECT_EQ(wrong_with(text, "m"), "'" + text + "' is not between 0 and 5 m");
  }
}

TEST(ParseInRange, SaysThatADecimalCommaIsOne) {
  EXPECT_EQ(wrong_with("0,2"),
            "'0,2' is not a number: the decimal point is a dot, did you mean 0.2?");
  for (const std::string text : {"1,2,3", "", "nan", "two", "1e-999", " 1", ","}) {
    EXPECT_EQ(wrong_with(text), "'" + text + "' is not a number");
  }
}

TEST(ParseInRange, LeavesTheValueWhereTheTextIsWrong) {
  double value = 3;
  parse_in_range("9", value, 0, 5);
  parse_in_range("x", value, 0, 5);
  EXPECT_EQ(value, 3);
}

}  // namespace
}  // namespace wend
