#include "wend/io/utf8.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

using namespace std::string_view_literals;

TEST(FirstNonText, AcceptsTextInAnyLanguage) {
  EXPECT_EQ(first_non_text(""), std::nullopt);
  EXPECT_EQ(first_non_text("image: a\tb\r\n~"), std::nullopt);
  EXPECT_EQ(first_non_text("caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\xA4\x96"), std::nullopt);
}

TEST(FirstNonText, FindsControlCharacters) {
  EXPECT_EQ(first_non_text("ab\0"sv), 2U);
  EXPECT_EQ(first_non_text("\x1B[2J"), 0U);
  EXPECT_EQ(first_non_text("a\x7F"), 1U);
}

TEST(FirstNonText, FindsWhatIsNotUtf8) {
  EXPECT_EQ(first_non_text("caf\xE9.pgm"), 3U);       // Latin-1
  EXPECT_EQ(first_non_text("\xFF\xFEt\0"sv), 0U);     // UTF-16
  EXPECT_EQ(first_non_text("a\xE2\x82"), 1U);         // cut
  EXPECT_EQ(first_non_text("\x80"), 0U);              // no lead byte
  EXPECT_EQ(first_non_text("\xC0\xAF"), 0U);          // overlong
  EXPECT_EQ(first_non_text("\xE0\x80\xAF"), 0U);      // overlong
  EXPECT_EQ(first_non_text("\xF0\x80\x80\xAF"), 0U);  // overlong
  EXPECT_EQ(first_non_text("\xED\xA0\x80"), 0U);      // a surrogate
  EXPECT_EQ(first_non_text("\xF4\x90\x80\x80"), 0U);  // above U+10FFFF
}

}  // namespace
}  // namespace wend
