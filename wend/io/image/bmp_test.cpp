#include <gmock/gmock.h>

#include <random>

#include "tests/testing/whole_image.hpp"
#include "wend/io/image/bmp_test_support.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

using namespace std::string_literals;

Expected<WholeImage, Error> decoded_bmp(const std::string& bytes) {
  return whole_image(bytes, decode_bmp);
}

std::string bmp_rgb(int red, int green, int blue) {
  return {static_cast<char>(blue), static_cast<char>(green), static_cast<char>(red)};
}

TEST(Bmp, ReadsColoursFromTheBottomRowUp) {
  const auto image =
      decoded_bmp(bmp_file::file(2, 2, 24, "",
                                 bmp_rgb(255, 0, 0) + bmp_rgb(0, 255, 0) + "\0\0"s +
                                     bmp_rgb(0, 0, 255) + bmp_rgb(9, 9, 9) + "\0\0"s));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, 2);
  EXPECT_THAT(image->values, ElementsAre(29, 9, 76, 150));
  EXPECT_TRUE(image->transparent.empty());
  EXPECT_TRUE(image->notes.empty());
}

TEST(Bmp, ANegativeHeightMeansFromTheTopRowDown) {
  const auto image = decoded_bmp(
      bmp_file::file(1, -2, 24, "", bmp_rgb(7, 7, 7) + "\0"s + bmp_rgb(9, 9, 9) + "\0"s));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->values, ElementsAre(7, 9));
}

TEST(Bmp, ReadsPalettesOf1And4And8Bits) {
  const std::string palette = "\x00\x00\x00\x00\xCD\xCD\xCD\x00\xFE\xFE\xFE\x00"s;
  const auto bits = decoded_bmp(bmp_file::file(3, 1, 1, palette.substr(0, 8), "\x40\0\0\0"s));
  ASSERT_TRUE(bits) << bits.error().message;
  EXPECT_THAT(bits->values, ElementsAre(0, 205, 0));
  const auto nibbles = decoded_bmp(bmp_file::file(3, 1, 4, palette, "\x01\x20\0\0"s));
  ASSERT_TRUE(nibbles) << nibbles.error().message;
  EXPECT_THAT(nibbles->values, ElementsAre(0, 205, 254));
  const auto bytes = decoded_bmp(bmp_file::file(3, 1, 8, palette, "\x02\x01\x00\x00"s));
  ASSERT_TRUE(bytes) << bytes.error().message;
  EXPECT_THAT(bytes->values, ElementsAre(254, 205, 0));
}

TEST(Bmp, RefusesAnIndexWithoutAPaletteEntry) {
  const std::string palette = "\x00\x00\x00\x00\xCD\xCD\xCD\x00"s;
  EXPECT_EQ(error_of(decoded_bmp(bmp_file::file(2, 1, 8, palette, "\x00\x02\0\0"s))),
            "BMP: palette index 2 out of range (2 entries)");
  EXPECT_EQ(error_of(decoded_bmp(bmp_file::file(2, 1, 4, palette, "\x1F\0\0\0"s))),
            "BMP: palette index 15 out of range (2 entries)");
  EXPECT_EQ(error_of(decoded_bmp(bmp_file::file(2, 1, 1, palette.substr(0, 4), "\x40\0\0\0"s))),
            "BMP: palette index 1 out of range (1 entries)");
}

TEST(Bmp, AlphaIsTransparencyUnlessItIsZeroEverywhere) {
  const auto some = decoded_bmp(bmp_file::file(2, 1, 32, "", "\x05\x05\x05\xFF\x06\x06\x06\x80"s));
  ASSERT_TRUE(some) << some.error().message;
  EXPECT_THAT(some->values, ElementsAre(5, 6));
  EXPECT_THAT(some->transparent, ElementsAre(0, 1));
  const auto none = decoded_bmp(bmp_file::file(2, 1, 32, "", "\x05\x05\x05\0\x06\x06\x06\0"s));
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_THAT(none->transparent, ElementsAre(0, 0)) << "many writers leave it 0";
}

TEST(Bmp, EveryTruncatedFileIsRefused) {
  const std::string whole = bmp_file::file(3, 2, 24, "", std::string(23, 'a'));
  ASSERT_TRUE(decoded_bmp(whole)) << "the last row needs no padding beyond its pixels";
  for (std::size_t size = 2; size < whole.size(); ++size) {
    const auto image = decoded_bmp(whole.substr(0, size));
    if (size >= 54 + 12 + 9) continue;  // only the padding is missing
    EXPECT_FALSE(image) << size;
  }
}

TEST(Bmp, SaysWhatItDoesNotRead) {
  EXPECT_THAT(error_of(decoded_bmp(bmp_file::file(70000, 70000, 24, "", "abc"))),
              HasSubstr("70000 x 70000 pixels are too large or truncated"));
  EXPECT_THAT(error_of(decoded_bmp(bmp_file::file(0, 1, 24, "", "abc"))),
              HasSubstr("0 x 1 pixels"));
  EXPECT_THAT(error_of(decoded_bmp(bmp_file::file(1, 1, 7, "", "abc"))), HasSubstr("bits a pixel"));
  std::string packed = bmp_file::file(1, 1, 8, std::string(1024, '\0'), "abcd");
  packed[30] = 1;
  EXPECT_THAT(error_of(decoded_bmp(packed)), HasSubstr("RLE"));
}

TEST(Bmp, GreyPicturesOfAnySizeReadAsTheyWereWritten) {
  std::mt19937 random(7);
  for (int width = 1; width < 20; ++width) {
    for (const int height : {1, 2, 5}) {
      std::vector<std::uint16_t> values;
      std::string rows;
      for (int y = 0; y < height; ++y) {
        std::string row;
        for (int x = 0; x < width; ++x) {
          values.push_back(static_cast<std::uint16_t>(random() % 256));
          row += bmp_rgb(values.back(), values.back(), values.back());
        }
        row.resize((row.size() + 3) / 4 * 4);
        rows += row;
      }
      const auto image = decoded_bmp(bmp_file::file(width, -height, 24, "", rows));
      ASSERT_TRUE(image) << image.error().message;
      EXPECT_THAT(image->values, ElementsAreArray(values));
    }
  }
}

}  // namespace
}  // namespace wend
