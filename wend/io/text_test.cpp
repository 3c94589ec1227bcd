#include "wend/io/text.hpp"

#include <gmock/gmock.h>

#include <random>
#include <string>

namespace wend {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using namespace std::string_view_literals;

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

TEST(Visible, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(visible("plain, Käse, 木, 🤖\n\ttab"), "plain, Käse, 木, 🤖\n\ttab");
  EXPECT_EQ(visible("\x1b]0;title\x07"), "\\x1B]0;title\\x07");
  EXPECT_EQ(visible("a\rb\x7f"), "a\\x0Db\\x7F");
  EXPECT_EQ(visible("\xC2\x9B"
                    "2J"),
            "\\xC2\\x9B2J")
      << "CSI as one character";
  EXPECT_EQ(visible("\xC2\xA0"), "\xC2\xA0");
  EXPECT_EQ(visible("map\u202Efdp"), "map\\xE2\\x80\\xAEfdp") << "it would end in 'pdf'";
  EXPECT_EQ(visible("\u2028\u2066\u2069"), "\\xE2\\x80\\xA8\\xE2\\x81\\xA6\\xE2\\x81\\xA9");
  EXPECT_EQ(visible("\u2027\u202F\u2065\u206A"), "\u2027\u202F\u2065\u206A");
  EXPECT_EQ(text_line("a\u202Eb", 40), "a\\xE2\\x80\\xAEb");
  EXPECT_EQ(visible("\xFF\xC3"), "\\xFF\\xC3") << "not UTF-8";
  EXPECT_EQ(visible(""), "");
}

TEST(Visible, NoByteOfAnyTextIsAControlCharacter) {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    for (int i = 0; i < 20; ++i) bytes += static_cast<char>(random() % 256);
    const std::string shown = visible(bytes);
    for (const char letter : shown) {
      ASSERT_TRUE(static_cast<unsigned char>(letter) >= ' ' || letter == '\t' || letter == '\n');
    }
    ASSERT_EQ(visible(shown), shown);
  }
}

}  // namespace
}  // namespace wend
