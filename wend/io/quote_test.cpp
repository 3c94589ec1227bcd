#include "wend/io/quote.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

TEST(Quote, PutsPrintableTextInQuotes) {
  EXPECT_EQ(quote("type tile"), "'type tile'");
  EXPECT_EQ(quote(""), "''");
}

TEST(Quote, EscapesWhatIsNotPrintable) { EXPECT_EQ(quote("a\tb\xE9"), "'a\\x09b\\xE9'"); }

TEST(Quote, CutsLongTexts) {
  EXPECT_EQ(quote(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
  EXPECT_EQ(quote(std::string(41, 'a')), "'" + std::string(40, 'a') + "'...");
}

TEST(Quote, MakesWhatALibrarySaysPrintable) {
  EXPECT_EQ(printable("unknown escape character: \x04", 200), "unknown escape character: \\x04");
  EXPECT_EQ(printable("abcdef", 3), "abc");
}

TEST(Quote, ShowsALetterOrItsCode) {
  EXPECT_EQ(quote('x'), "'x'");
  EXPECT_EQ(quote('\0'), "0x00");
  EXPECT_EQ(quote('\xFF'), "0xFF");
}

}  // namespace
}  // namespace wend
