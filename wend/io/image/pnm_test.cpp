#include "wend/io/image/grey_image.hpp"

#include <gmock/gmock.h>

#include "tests/testing/whole_image.hpp"
#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using namespace std::string_literals;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

Expected<WholeImage, Error> decoded_pnm(std::string_view bytes) {
  return whole_image(bytes, decode_pnm);
}

std::string pnm_error(const std::string& bytes) { return error_of(decoded_pnm(bytes)); }

WholeImage pnm_image(const std::string& bytes) {
  auto image = decoded_pnm(bytes);
  EXPECT_TRUE(image) << error_of(image);
  return image.value_or(WholeImage{});
}

TEST(Pnm, ReadsTextGrey) {
  const WholeImage image = pnm_image("P2\n3 2\n255\n0 127 254\n255 1 2\n");
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.maximum, 255);
  EXPECT_THAT(row_of(image, 0), ElementsAre(0, 127, 254));
  EXPECT_THAT(row_of(image, 1), ElementsAre(255, 1, 2));
  EXPECT_THAT(image.notes, IsEmpty());
}

TEST(Pnm, ReadsBinaryGrey) {
  EXPECT_THAT(pnm_image("P5\n3 1\n255\n\x00\x7F\xFF"s).values, ElementsAre(0, 127, 255));
  EXPECT_THAT(pnm_image("P5 3 1 255 \n\n\n"s).values, ElementsAre('\n', '\n', '\n'));
}

TEST(Pnm, InBitmapsOneIsBlack) {
  for (const std::string& bytes :
       {"P1\n3 2\n0 1 1\n100\n"s, "P1 3 2 011100"s, "P4\n3 2\n\x60\x9F"s}) {
    const WholeImage image = pnm_image(bytes);
    EXPECT_EQ(image.maximum, 1);
    EXPECT_THAT(image.values, ElementsAre(1, 0, 0, 0, 1, 1));
  }
}

TEST(Pnm, BitmapRowsAreWholeBytes) {
  EXPECT_THAT(row_of(pnm_image("P4\n9 2\n\x00\x80\xFF\x00"s), 0),
              ElementsAre(1, 1, 1, 1, 1, 1, 1, 1, 0));
  EXPECT_THAT(row_of(pnm_image("P4\n9 2\n\x00\x80\xFF\x00"s), 1),
              ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 1));
}

TEST(Pnm, ABitmapWithoutBlackIsWhite) {
  EXPECT_THAT(pnm_image("P4\n9 2\n\x00\x00\x00\x00"s).values, Each(1));
}

TEST(Pnm, ColoursBecomeGreyByTheirLuma) {
  EXPECT_THAT(pnm_image("P3 2 1 255 255 0 0 0 255 0").values, ElementsAre(76, 150));
  EXPECT_THAT(pnm_image("P6 2 1 255\n\xFF\x00\x00\x64\x64\x64"s).values, ElementsAre(76, 100));
}

TEST(Pnm, AboveTwoHundredFiftyFiveASampleHasTwoBytes) {
  const WholeImage image = pnm_image("P5 2 1 65535\n\x01\x02\xFF\xFF"s);
  EXPECT_EQ(image.maximum, 65535);
  EXPECT_THAT(image.values, ElementsAre(0x0102, 0xFFFF));
  EXPECT_THAT(pnm_image("P6 1 1 256\n\x01\x00\x01\x00\x01\x00"s).values, ElementsAre(256));
}

TEST(Pnm, CommentsMayStandAnywhereOutsideBinarySamples) {
  EXPECT_THAT(pnm_image("P5\n# by hand\n2#wide\n 1 # high\n255\n#a"s).values,
              ElementsAre('#', 'a'));
  EXPECT_THAT(pnm_image("P2 2 1 255\n# first row\n7 # seven\n8").values, ElementsAre(7, 8));
  EXPECT_THAT(pnm_image("P1 2 1 # bits\n1#one\n0").values, ElementsAre(0, 1));
}

TEST(Pnm, AHeaderFromWindowsEndsWithCrlf) {
  EXPECT_THAT(pnm_image("P5\r\n2 1\r\n255\r\nab").values, ElementsAre('a', 'b'));
  EXPECT_THAT(pnm_image("P5\n2 1\n255\r\na").values, ElementsAre('\n', 'a'));
}

TEST(Pnm, SurplusBytesAreNoted) {
  EXPECT_THAT(pnm_image("P5 1 1 255\nabc").notes,
              ElementsAre("2 bytes after the last pixel of the image are ignored"));
  EXPECT_THAT(pnm_image("P5 1 1 255\na\n").notes, IsEmpty());
  EXPECT_THAT(pnm_image("P2 1 1 255\n7 8\n").notes,
              ElementsAre("2 bytes after the last pixel of the image are ignored"));
  EXPECT_THAT(pnm_image("P2 1 1 255\n7 \n# the end\n").notes, IsEmpty());
}

TEST(Pnm, HeadersAreComplete) {
  EXPECT_EQ(pnm_error("P5\n"), "header truncated: width is missing");
  EXPECT_EQ(pnm_error("P5 3"), "header truncated: height is missing");
  EXPECT_EQ(pnm_error("P5 3 2 # 255"), "header truncated: the maximum value is missing");
}

TEST(Pnm, HeadersHavePositiveWholeNumbers) {
  EXPECT_EQ(pnm_error("P5 0 1 255\n"), "width must be a whole number in 1..1073741824, not '0'");
  EXPECT_EQ(pnm_error("P5 1 -1 255\n"), "height must be a whole number in 1..1073741824, not '-1'");
  EXPECT_EQ(pnm_error("P5 1 1 65536\n"),
            "the maximum value must be a whole number in 1..65535, not '65536'");
  EXPECT_EQ(pnm_error("P5 1 1 2.5\n"),
            "the maximum value must be a whole number in 1..65535, not '2.5'");
}

TEST(Pnm, SizesThatTheFileIsTooShortForAreRefused) {
  EXPECT_EQ(pnm_error("P5 1073741824 1073741824 255\n"),
            "1073741824 x 1073741824 pixels are too many, the limit is 1073741824");
  EXPECT_EQ(pnm_error("P5 32768 32768 255\nabc"),
            "pixel data truncated: 3 bytes, expected at least 1073741824");
  EXPECT_EQ(pnm_error("P5 2 1 256\nabc"), "pixel data truncated: 3 bytes, expected at least 4");
  EXPECT_EQ(pnm_error("P4 9 2\nabc"), "pixel data truncated: 3 bytes, expected at least 4");
  EXPECT_EQ(pnm_error("P6 1 1 255\nab"), "pixel data truncated: 2 bytes, expected at least 3");
  EXPECT_EQ(pnm_error("P2 3 1 255\n10 20  "), "pixel data truncated: 2 pixels, expected 3");
  EXPECT_EQ(pnm_error("P1 3 1 1  1"), "pixel data truncated: 2 pixels, expected 3");
}

TEST(Pnm, SamplesAreWholeNumbersUpToTheMaximum) {
  EXPECT_EQ(pnm_error("P2 1 1 255 -10"), "pixel value '-10' is not a non-negative integer");
  EXPECT_EQ(pnm_error("P2 1 1 255 1.5"), "pixel value '1.5' is not a non-negative integer");
  EXPECT_EQ(pnm_error("P2 1 1 200 254"), "pixel value 254 above the maximum value 200");
  EXPECT_EQ(pnm_error("P5 1 1 200\n\xFE"), "pixel value 254 above the maximum value 200");
  EXPECT_EQ(pnm_error("P1 1 1 2"), "pixel value 2 above the maximum value 1");
}

TEST(Pnm, IsToldByItsFirstBytes) {
  EXPECT_TRUE(looks_like_pnm("P1\n"));
  EXPECT_TRUE(looks_like_pnm("P6# comment"));
  EXPECT_FALSE(looks_like_pnm("P7\n"));
  EXPECT_FALSE(looks_like_pnm("P5"));
  EXPECT_FALSE(looks_like_pnm("P55 "));
}

TEST(Pnm, IsWrittenAsBinaryGrey) {
  WholeImage image;
  image.width = 2;
  image.height = 1;
  image.values = {0, 205};
  EXPECT_EQ(encode_pgm(image), "P5\n2 1\n255\n\x00\xCD"s);
}

}  // namespace
}  // namespace wend
