#include "wend/io/image/grey_image.hpp"

#include "tests/testing/whole_image.hpp"
#include "wend/io/image/png_test_support.hpp"
#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using namespace std::string_literals;

TEST(Luma, WeighsTheChannelsAndRounds) {
  EXPECT_EQ(luma(255, 0, 0), 76);
  EXPECT_EQ(luma(0, 255, 0), 150);
  EXPECT_EQ(luma(0, 0, 255), 29);
  EXPECT_EQ(luma(65535, 65535, 65535), 65535);
}

TEST(Luma, LeavesGreyAsItIs) {
  for (unsigned grey = 0; grey <= 65535; ++grey) ASSERT_EQ(luma(grey, grey, grey), grey);
}

TEST(DecodeImage, TellsTheFormatByItsContent) {
  EXPECT_TRUE(decode_image("P5 1 1 255\na"));
  EXPECT_TRUE(decode_image(
      png_file::file(png_file::header(1, 1, 8, png_file::grey) + png_file::image_data("\0\0"s))));
}

TEST(DecodeImage, RefusesOtherFormatsByName) {
  EXPECT_EQ(error_of(decode_image("II*\0 "s)),
            "TIFF images are not supported; expected PNG, PNM (P1 to P6), BMP or JPEG");
  EXPECT_EQ(error_of(decode_image("P7\nWIDTH 1")),
            "PAM (P7) images are not supported; expected PNG, PNM (P1 to P6), BMP or JPEG");
  EXPECT_EQ(error_of(decode_image("image: map.pgm")),
            "unknown image format; expected PNG, PNM (P1 to P6), BMP or JPEG");
  EXPECT_EQ(error_of(decode_image("")),
            "unknown image format; expected PNG, PNM (P1 to P6), BMP or JPEG");
}

}  // namespace
}  // namespace wend
