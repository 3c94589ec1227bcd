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

TEST(LineReader, SkipsAByteOrderMarkAtTheBeginningAlone) {
  EXPECT_THAT(lines_of("\xEF\xBB\xBF"
                       "a\n\xEF\xBB\xBF"
                       "b"),
              ElementsAre("a",
                          "\xEF\xBB\xBF"
                          "b"));
  EXPECT_THAT(lines_of("\xEF\xBB\xBF"), IsEmpty());
  EXPECT_THAT(lines_of("\xEF\xBB"), ElementsAre("\xEF\xBB"));
}

TEST(LineReader, JoinsLinesThatLieInSeveralPieces) {
  const std::string text = "\xEF\xBB\xBFone\r\n\ntwo\nthree and more\n\nend";
  for (std::size_t size = 3; size <= text.size() + 1; ++size) {
    std::string_view rest = text;
    std::string piece;
    const auto next_piece = [&]() -> std::string_view {
      piece = rest.substr(0, size);
      rest.remove_prefix(piece.size());
      return piece;
    };
    LineReader reader(next_piece, text.size());
    std::vector<std::string> lines;
    while (const auto line = reader.next()) lines.emplace_back(*line);
    EXPECT_EQ(lines, lines_of(text)) << size;
  }
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
