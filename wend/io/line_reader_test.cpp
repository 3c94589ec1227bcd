#include "wend/io/line_reader.hpp"

#include <gmock/gmock.h>

#include <string>

namespace wend {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  LineReader reader(text);
  while (const auto line = reader.next()) {
    lines.emplace_back(*line);
    EXPECT_EQ(reader.number(), lines.size());
  }
  return lines;
}

TEST(LineReader, SplitsAtLineFeedsAndDropsTheCarriageReturnBefore) {
  EXPECT_THAT(lines_of("a\nb\r\n\nc"), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(lines_of("a\rb\r\r\n"), ElementsAre("a\rb\r"));
}

TEST(LineReader, SeesNoLineAfterTheLastLineEnd) {
  EXPECT_THAT(lines_of(""), IsEmpty());
  EXPECT_THAT(lines_of("\n"), ElementsAre(""));
  EXPECT_THAT(lines_of("a\n"), ElementsAre("a"));
}

TEST(LineReader, SplitsWordsAtBlanksAndTabs) {
  EXPECT_THAT(words_of(" height\t 4 "), ElementsAre("height", "4"));
  EXPECT_THAT(words_of(" \t"), IsEmpty());
}

TEST(LineReader, TrimsBlanks) {
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
  EXPECT_TRUE(is_blank(" \t"));
  EXPECT_TRUE(is_blank(""));
  EXPECT_FALSE(is_blank(" ."));
}

}  // namespace
}  // namespace wend
