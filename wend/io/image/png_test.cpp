#include "wend/io/image/grey_image.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "tests/testing/whole_image.hpp"
#include "wend/io/image/png_test_support.hpp"
#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using namespace std::string_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

Expected<WholeImage, Error> decoded_png(std::string_view bytes) {
  return whole_image(bytes, decode_png);
}

std::string png_error(const std::string& bytes) { return error_of(decoded_png(bytes)); }

WholeImage png_image(const std::string& bytes) {
  auto image = decoded_png(bytes);
  EXPECT_TRUE(image) << error_of(image);
  return image.value_or(WholeImage{});
}

std::string grey_2x2(const std::string& pixels = "\x00\x7F\xFE\xFF"s) {
  return png_file::file(png_file::header(2, 2, 8, png_file::grey) +
                        png_file::image_data(png_file::scanlines(pixels, 2)));
}

TEST(Png, ReadsGreyRowByRowFromTheTop) {
  const WholeImage image = png_image(grey_2x2());
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.maximum, 255);
  EXPECT_THAT(row_of(image, 0), ElementsAre(0, 127));
  EXPECT_THAT(row_of(image, 1), ElementsAre(254, 255));
  EXPECT_THAT(image.transparent, IsEmpty());
}

TEST(Png, ReadsSixteenBitsInFull) {
  const WholeImage image =
      png_image(png_file::file(png_file::header(2, 1, 16, png_file::grey) +
                               png_file::image_data(png_file::scanlines("\x01\x02\xFF\xFF", 4))));
  EXPECT_EQ(image.maximum, 65535);
  EXPECT_THAT(image.values, ElementsAre(0x0102, 65535));
}

TEST(Png, ReadsLessThanEightBitsOnTheirOwnScale) {
  const auto with_depth = [](char depth) {
    return png_image(png_file::file(png_file::header(3, 1, depth, png_file::grey) +
                                    png_file::image_data(png_file::scanlines("\xB1\xB0", 2))));
  };
  EXPECT_EQ(with_depth(4).maximum, 15);
  EXPECT_THAT(with_depth(4).values, ElementsAre(11, 1, 11));
  const WholeImage two = png_image(
      png_file::file(png_file::header(3, 1, 2, png_file::grey) + png_file::image_data("\0\xB1"s)));
  EXPECT_EQ(two.maximum, 3);
  EXPECT_THAT(two.values, ElementsAre(2, 3, 0));
  const WholeImage one = png_image(
      png_file::file(png_file::header(3, 1, 1, png_file::grey) + png_file::image_data("\0\xB1"s)));
  EXPECT_EQ(one.maximum, 1);
  EXPECT_THAT(one.values, ElementsAre(1, 0, 1));
}

TEST(Png, ColoursBecomeGreyByTheirLuma) {
  const WholeImage image =
      png_image(png_file::file(png_file::header(4, 1, 8, png_file::rgb) +
                               png_file::image_data(png_file::scanlines(
                                   "\xFF\x00\x00\x00\xFF\x00\x00\x00\xFF\x64\x64\x64"s, 12))));
  EXPECT_THAT(image.values, ElementsAre(76, 150, 29, 100));
}

TEST(Png, EveryAlphaBelowFullIsTransparent) {
  const WholeImage grey =
      png_image(png_file::file(png_file::header(3, 1, 8, png_file::grey_alpha) +
                               png_file::image_data("\0\x0A\xFF\x14\xFE\x1E\x00"s)));
  EXPECT_THAT(grey.values, ElementsAre(10, 20, 30));
  EXPECT_THAT(grey.transparent, ElementsAre(0, 1, 1));
  const WholeImage colour = png_image(
      png_file::file(png_file::header(2, 1, 16, png_file::rgb_alpha) +
                     png_file::image_data("\0\1\1\1\1\1\1\xFF\xFF\1\1\1\1\1\1\xFF\xFE"s)));
  EXPECT_THAT(colour.values, ElementsAre(257, 257));
  EXPECT_THAT(colour.transparent, ElementsAre(0, 1));
}

TEST(Png, OneColourMayBeTransparent) {
  const WholeImage grey = png_image(png_file::file(
      png_file::header(2, 2, 8, png_file::grey) + png_file::chunk("tRNS", "\0\x7F"s) +
      png_file::image_data(png_file::scanlines("\x00\x7F\xFE\xFF"s, 2))));
  EXPECT_THAT(grey.transparent, ElementsAre(0, 1, 0, 0));
  const WholeImage colour = png_image(png_file::file(png_file::header(2, 1, 8, png_file::rgb) +
                                                     png_file::chunk("tRNS", "\0\1\0\2\0\3"s) +
                                                     png_file::image_data("\0\1\2\3\1\2\4"s)));
  EXPECT_THAT(colour.transparent, ElementsAre(1, 0));
}

TEST(Png, PaletteIndicesStandForTheirColours) {
  const std::string palette = png_file::chunk("PLTE", "\0\0\0\xFE\xFE\xFE\xFF\0\0"s);
  const WholeImage image = png_image(png_file::file(png_file::header(4, 1, 2, png_file::palette) +
                                                    palette + png_file::image_data("\0\x18"s)));
  EXPECT_EQ(image.maximum, 255);
  EXPECT_THAT(image.values, ElementsAre(0, 254, 76, 0));
  EXPECT_THAT(image.transparent, IsEmpty());
  const WholeImage with_alpha = png_image(
      png_file::file(png_file::header(4, 1, 2, png_file::palette) + palette +
                     png_file::chunk("tRNS", "\xFF\x80") + png_file::image_data("\0\x18"s)));
  EXPECT_THAT(with_alpha.transparent, ElementsAre(0, 1, 0, 0));
}

TEST(Png, APaletteIndexWithoutAnEntryIsAnError) {
  EXPECT_EQ(png_error(png_file::file(png_file::header(2, 1, 8, png_file::palette) +
                                     png_file::chunk("PLTE", "\0\0\0\1\1\1"s) +
                                     png_file::image_data("\0\0\2"s))),
            "PNG: palette index 2 out of range (2 entries)");
}

RC_GTEST_PROP(Png, InterlacedImagesAreTheSame, ()) {
  const auto width = *rc::gen::inRange<std::size_t>(1, 20);
  const auto height = *rc::gen::inRange<std::size_t>(1, 20);
  const auto pixels = *rc::gen::container<std::string>(width * height, rc::gen::arbitrary<char>());
  const auto decoded = [&](char interlace, const std::string& lines) {
    const auto image = decoded_png(png_file::file(
        png_file::header(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 8,
                         png_file::grey, interlace) +
        png_file::image_data(lines)));
    RC_ASSERT(image.has_value());
    return image->values;
  };
  RC_ASSERT(decoded(1, png_file::interlaced_scanlines(pixels, width)) ==
            decoded(0, png_file::scanlines(pixels, width)));
}

TEST(Png, ChunksThatSayNothingAboutTheMapAreSkipped) {
  const std::string data = png_file::image_data(png_file::scanlines("\x00\x7F\xFE\xFF"s, 2));
  EXPECT_TRUE(decoded_png(png_file::file(
      png_file::header(2, 2, 8, png_file::grey) + png_file::chunk("iCCP", "no profile at all") +
      png_file::chunk("gAMA", "\0\0\0\1"s) + png_file::chunk("zTXt", "nonsense") + data)));
}

TEST(Png, WrongChecksumsAreErrors) {
  std::string in_the_chunk = grey_2x2();
  in_the_chunk[in_the_chunk.find("IEND") - 5] ^= 1;
  EXPECT_EQ(png_error(in_the_chunk), "PNG: IDAT: CRC error");
  std::string data = "\x78\x01\x01\x06\x00\xF9\xFF"s + "\0\x00\x7F\0\xFE\xFF"s + "\0\0\0\0"s;
  EXPECT_EQ(png_error(png_file::file(png_file::header(2, 2, 8, png_file::grey) +
                                     png_file::chunk("IDAT", data))),
            "PNG: IDAT: incorrect data check");
}

TEST(Png, TooLittleOrTooMuchImageDataIsAnError) {
  EXPECT_THAT(png_error(grey_2x2("\x00\x7F"s)), StartsWith("PNG: "));
  EXPECT_EQ(png_error(grey_2x2("\x00\x7F\xFE\xFF\x01\x02"s)), "PNG: IDAT: Too much image data");
}

TEST(Png, SizesThatTheFileIsTooShortForAreRefused) {
  const auto with_size = [](std::uint32_t width, std::uint32_t height, char interlace) {
    return png_error(png_file::file(png_file::header(width, height, 8, png_file::grey, interlace) +
                                    png_file::image_data("\0\0"s)));
  };
  EXPECT_EQ(with_size(60000, 60000, 0),
            "PNG: 60000 x 60000 pixels are too large or truncated, the file has 70 bytes");
  EXPECT_EQ(with_size(10000, 1000, 1),
            "PNG: 10000 x 1000 pixels are too large or truncated, the file has 70 bytes");
  EXPECT_THAT(with_size(0, 1, 0), StartsWith("PNG: Invalid IHDR data"));
  EXPECT_THAT(with_size(0x7FFFFFFF, 1, 0), StartsWith("PNG: Invalid IHDR data"));
}

TEST(Png, AFileWhoseFirstChunkIsNotTheHeaderIsRefused) {
  const std::string rest = png_file::header(2, 2, 8, png_file::grey) +
                           png_file::image_data(png_file::scanlines("\x00\x7F\xFE\xFF"s, 2));
  ASSERT_TRUE(decoded_png(png_file::file(rest)));
  for (const char* const first : {"tEXt", "CgBI", "abCd", "sRGB"}) {
    EXPECT_EQ(png_error(png_file::file(png_file::chunk(first, "a") + rest)),
              "PNG: the first chunk must be IHDR, not '"s + first + "'");
  }
  EXPECT_EQ(png_error("\x89PNG\r\n\x1A\n"s), "PNG: the file is truncated");
}

TEST(Png, AnImageWithoutItsPaletteIsAnError) {
  EXPECT_THAT(png_error(png_file::file(png_file::header(2, 1, 8, png_file::palette) +
                                       png_file::image_data("\0\0\0"s))),
              StartsWith("PNG: "));
}

RC_GTEST_PROP(Png, WrittenImagesReadBack, ()) {
  WholeImage image;
  image.width = *rc::gen::inRange(1, 40);
  image.height = *rc::gen::inRange(1, 40);
  const auto size = static_cast<std::size_t>(image.width * image.height);
  image.values = *rc::gen::container<std::vector<std::uint16_t>>(
      size, rc::gen::inRange<std::uint16_t>(0, 256));
  if (*rc::gen::arbitrary<bool>()) {
    image.transparent = *rc::gen::container<std::vector<unsigned char>>(
        size, rc::gen::element<unsigned char>(0, 1));
  }
  const auto bytes = encode_png(image);
  RC_ASSERT(bytes.has_value());
  const auto decoded = decoded_png(*bytes);
  RC_ASSERT(decoded.has_value());
  RC_ASSERT(decoded->width == image.width);
  RC_ASSERT(decoded->height == image.height);
  RC_ASSERT(decoded->values == image.values);
  RC_ASSERT(decoded->transparent == image.transparent);
}

}  // namespace
}  // namespace wend
