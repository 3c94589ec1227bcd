#include "wend/base/parse.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace wend {
namespace {

RC_GTEST_PROP(ParseNumber, ReadsBackWhatFormatNumberWrites, (double number)) {
  const std::string text = format_number(number);
  RC_ASSERT(parse_number(text).value() == number);
}

RC_GTEST_PROP(ParseNumber, AgreesWithTheStandardLibraryOnEveryBitPattern, (std::uint64_t bits)) {
  double number = 0;
  static_assert(sizeof number == sizeof bits);
  std::memcpy(&number, &bits, sizeof number);
  RC_PRE(std::isfinite(number));
  const std::string text = format_number(number);
  RC_ASSERT(std::strtod(text.c_str(), nullptr) == number);
  RC_ASSERT(parse_number(text).value() == number);
}

RC_GTEST_PROP(ParseInteger, ReadsBackWhatToStringWrites, (std::int64_t number)) {
  RC_ASSERT(parse_integer<std::int64_t>(std::to_string(number)).value() == number);
}

TEST(ParseNumber, TakesDecimalAndExponentNotation) {
  EXPECT_EQ(parse_number("0"), 0.0);
  EXPECT_EQ(parse_number("-2.5"), -2.5);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("1e3"), 1000.0);
  EXPECT_EQ(parse_number("0.05"), 0.05);
  EXPECT_EQ(parse_number("inf"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));
}

TEST(ParseNumber, TakesTheWholeTextOrNothing) {
  for (const char* const text :
       {"", " ", " 1", "1 ", "1x", "x", "1,5", "1.2.3", "--1", "0x10", "e5", "-", "."}) {
    EXPECT_FALSE(parse_number(text).has_value()) << "'" << text << "'";
  }
  EXPECT_FALSE(parse_number(std::string_view()).has_value());
  EXPECT_FALSE(parse_number(std::string_view("1\0", 2)).has_value());
}

TEST(ParseNumber, RefusesWhatADoubleCannotHold) {
  EXPECT_FALSE(parse_number("1e999").has_value());
  EXPECT_FALSE(parse_number("-1e999").has_value());
  EXPECT_FALSE(parse_number("1e-999").has_value());
}

TEST(ParseNumber, ReadsNoFartherThanItsView) {
  EXPECT_EQ(parse_number(std::string_view("12345").substr(1, 2)), 23.0);
  EXPECT_EQ(parse_integer<int>(std::string_view("12345").substr(1, 2)), 23);
}

TEST(ParseInteger, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(parse_integer<int>("-17"), -17);
  EXPECT_EQ(parse_integer<int>("007"), 7);
  for (const char* const text : {"", " ", " 1", "1 ", "1.0", "1e3", "x", "-", "--1", "0x10"}) {
    EXPECT_FALSE(parse_integer<int>(text).has_value()) << "'" << text << "'";
  }
}

TEST(ParseInteger, KnowsTheRangeOfItsType) {
  EXPECT_EQ(parse_integer<int>("2147483647"), 2147483647);
  EXPECT_FALSE(parse_integer<int>("2147483648").has_value());
  EXPECT_EQ(parse_integer<std::uint8_t>("255"), std::uint8_t{255});
  EXPECT_FALSE(parse_integer<std::uint8_t>("256").has_value());
  EXPECT_FALSE(parse_integer<std::uint64_t>("-1").has_value());
  EXPECT_FALSE(parse_integer<std::uint64_t>("18446744073709551616").has_value());
}

TEST(FormatNumber, IsAsShortAsCanBe) {
  EXPECT_EQ(format_number(0), "0");
  EXPECT_EQ(format_number(1), "1");
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(-2.5), "-2.5");
  EXPECT_EQ(format_number(0.1 + 0.2), "0.30000000000000004");
}

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
