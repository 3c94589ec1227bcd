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

TEST(Quote, KeepsALineOfTextShort) {
  EXPECT_EQ(text_line("a\r\nb", 10), "a  b");
  EXPECT_EQ(text_line("abc\xC3\xA9", 5), "abc\xC3\xA9");
  EXPECT_EQ(text_line("abc\xC3\xA9", 4), "abc") << "no half of a letter";
  EXPECT_EQ(text_line(std::string(100, '\x01'), 20).size(), 20U);
}

TEST(Quote, ShowsALetterOrItsCode) {
  EXPECT_EQ(quote('x'), "'x'");
  EXPECT_EQ(quote('\0'), "0x00");
  EXPECT_EQ(quote('\xFF'), "0xFF");
}

}  // namespace
}  // namespace wend
