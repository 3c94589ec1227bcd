#include <gmock/gmock.h>

#include <cstdio>  // jpeglib.h needs it
#include <cstdlib>

#include <jpeglib.h>

#include "tests/testing/whole_image.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

using namespace std::string_literals;

struct JpegKind {
  int channels = 1;  // 1 grey, 3 colour, 4 CMYK
  bool progressive = false;
  bool arithmetic = false;
};

/// The file of an image whose bytes lie row by row.
std::string jpeg_file(int width, int height, const std::string& bytes, JpegKind kind = {}) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* made = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &made, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = kind.channels;
  jpeg.in_color_space = kind.channels == 1   ? JCS_GRAYSCALE
                        : kind.channels == 3 ? JCS_RGB
                                             : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg.arith_code = kind.arithmetic ? TRUE : FALSE;
  if (kind.progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  for (int y = 0; y < height; ++y) {
    const std::size_t row_bytes = static_cast<std::size_t>(width * kind.channels);
    std::string row = bytes.substr(static_cast<std::size_t>(y) * row_bytes, row_bytes);
    JSAMPROW pointer = reinterpret_cast<unsigned char*>(row.data());
    jpeg_write_scanlines(&jpeg, &pointer, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string file(reinterpret_cast<char*>(made), size);
  jpeg_destroy_compress(&jpeg);
  std::free(made);
  return file;
}

Expected<WholeImage, Error> decoded_jpeg(const std::string& bytes) {
  return whole_image(bytes, decode_jpeg);
}

/// Blocks of 8 x 8 pixels, black, grey and white.
std::string three_blocks() {
  std::string row = std::string(8, '\0') + std::string(8, '\xCD') + std::string(8, '\xFE');
  std::string rows;
  for (int y = 0; y < 8; ++y) rows += row;
  return rows;
}

TEST(Jpeg, ReadsGreyAndSaysThatItIsNotExact) {
  for (const bool progressive : {false, true}) {
    const auto image = decoded_jpeg(jpeg_file(24, 8, three_blocks(), {.progressive = progressive}));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->width, 24);
    EXPECT_EQ(image->height, 8);
    EXPECT_EQ(image->maximum, 255);
    for (std::size_t i = 0; i < image->values.size(); ++i) {
      const int right = i % 24 < 8 ? 0 : i % 24 < 16 ? 205 : 254;
      EXPECT_NEAR(image->values[i], right, 2) << i;
    }
    EXPECT_THAT(image->notes, SizeIs(1));
    EXPECT_THAT(image->notes[0], HasSubstr("not keep grey values exactly"));
  }
}

TEST(Jpeg, ColoursBecomeTheirLuma) {
  std::string green;
  for (int i = 0; i < 64; ++i) green += "\x00\xFF\x00"s;
  const auto image = decoded_jpeg(jpeg_file(8, 8, green, {.channels = 3}));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->values, Each(testing::AllOf(testing::Ge(148), testing::Le(152))));
}

TEST(Jpeg, DamagedFilesAreRefused) {
  const std::string whole = jpeg_file(24, 8, three_blocks());
  for (std::size_t size = 3; size + 2 < whole.size(); size += 7) {
    EXPECT_FALSE(decoded_jpeg(whole.substr(0, size))) << size;
  }
}

TEST(Jpeg, SaysWhatItDoesNotRead) {
  EXPECT_THAT(error_of(decoded_jpeg(jpeg_file(8, 8, std::string(256, 'a'), {.channels = 4}))),
              HasSubstr("CMYK colours are not supported"));
  EXPECT_THAT(error_of(decoded_jpeg(jpeg_file(24, 8, three_blocks(), {.arithmetic = true}))),
              HasSubstr("arithmetic coding is not supported"));
}

TEST(Jpeg, AFileTooShortForItsSizeIsRefusedBeforeTheImageIsMade) {
  std::string small = jpeg_file(8, 8, std::string(64, 'a'));
  const std::size_t frame = small.find("\xFF\xC0");
  small[frame + 5] = '\xF0';
  small[frame + 7] = '\xF0';
  EXPECT_THAT(error_of(decoded_jpeg(small)), HasSubstr("too large or truncated"));
}

}  // namespace
}  // namespace wend
