// Damaged files, cut at every byte and with every byte changed, are rejected with a short error or
// load. The sanitizers check that nothing else happens.

#include <gmock/gmock.h>

#include <functional>

#include "tests/testing/whole_image.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/image/png_test_support.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/io/map/map_yaml.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/io/query/scenario.hpp"

namespace wend {
namespace {

using namespace std::string_literals;

struct Sample {
  std::string name;
  std::string bytes;
  std::function<std::string(const std::string&)> error_of;  // "no error" if it loads
};

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

std::string error_in_image(const std::string& bytes) { return error_of(decode_image(bytes)); }

std::string compressed_png() {
  GreyImage image;
  image.width = 9;
  image.height = 7;
  for (int i = 0; i < 63; ++i) image.values.push_back(static_cast<std::uint16_t>(i * i % 256));
  return *encode_png(image);
}

std::string odd_png() {
  return png_file::file(
      png_file::header(9, 5, 8, png_file::palette, 1) +
      png_file::chunk("PLTE", "\0\0\0\1\1\1\2\2\2"s) + png_file::chunk("tRNS", "\x80"s) +
      png_file::image_data(png_file::interlaced_scanlines(
          std::string(9, '\0') + std::string(18, '\1') + std::string(18, '\2'), 9)));
}

std::vector<Sample> samples() {
  const auto moving_ai = [](const std::string& text) {
    return error_of(load_as(MapFormat::moving_ai_map, text));
  };
  const auto grid = [](const std::string& text) {
    return error_of(load_as(MapFormat::text_grid, text));
  };
  const auto yaml = [](const std::string& text) { return error_of(parse_map_yaml(text, "y")); };
  const auto scenario = [](const std::string& text) { return error_of(parse_scenario(text, "s")); };
  const auto path = [](const std::string& text) { return error_of(parse_path_csv(text, "p", {})); };
  const auto plan = [](const std::string& text) {
    return error_of(parse_path_json(text, "p", {}, PathStage::smoothed));
  };
  return {
      {"path_cells", "x,y,x_m,y_m\n1,2,0.5,0.5\n", path},
      {"path_poses", "x,y,heading,x_m,y_m,yaw,gear\n1,2,E,0.5,0.5,0,1\n3,2,0.25,1,1,0,1\n", path},
      {"path_waypoints", "x_grid,y_grid,x_m,y_m,yaw\n1.5,2,0.5,0.5,0\n", path},
      {"path_centreline", "# c\n# s_m; x_m; y_m\n0;1.5;2\n1; 2.5 ;2.25\n", path},
      {"path_json", R"({"path":[[1,2]],"path_smoothed":[[1.5,2.5],[2,3]]})", plan},
      {"moving_ai", "type octile\nheight 2\nwidth 3\nmap\n.@T\n.GS\n", moving_ai},
      {"moving_ai_crlf", "type octile\r\nheight 2\r\nwidth 3\r\nmap\r\n.@T\r\n.GS\r\n", moving_ai},
      {"text_grid", "0 1 2\n~ ? #\n\n", grid},
      {"scenario", "version 1\n7\tmaps/a.map\t5\t4\t0\t1\t4\t3\t5.24264\n1 b 9 9 0 0 8 8 12.5\n",
       scenario},
      {"yaml",
       "image: 'm.pgm' # x\nresolution: 5e-2\norigin: [&z -1.0, *z , 0]\nnegate: 0\n"
       "occupied_thresh: 0.65\nfree_thresh: 0.196\nmode: scale\n",
       yaml},
      {"p1", "P1\n# c\n3 2\n011 100\n", error_in_image},
      {"p2", "P2 3 2 255\n0 10 200 # c\n7 8 9\n", error_in_image},
      {"p3", "P3 2 1 15\n1 2 3 4 5 15\n", error_in_image},
      {"p4", "P4 9 2\n\x01\x80\xFE\x7F", error_in_image},
      {"p5", "P5\n# c\n3 2\n255\nabcdef", error_in_image},
      {"p5_wide", "P5 2 2 999\n\1\2\1\3\2\4\3\5", error_in_image},
      {"p6", "P6 2 1 255\nabcdef", error_in_image},
      {"png", compressed_png(), error_in_image},
      {"png_palette_interlaced", odd_png(), error_in_image},
  };
}

class DamagedFile : public testing::TestWithParam<Sample> {
 protected:
  static void expect_verdict(const std::string& bytes) {
    const std::string error = GetParam().error_of(bytes);
    EXPECT_FALSE(error.empty());
    EXPECT_LT(error.size(), 200U) << error;
  }
};

TEST_P(DamagedFile, LoadsWhenItIsWhole) {
  EXPECT_EQ(GetParam().error_of(GetParam().bytes), "no error");
}

TEST_P(DamagedFile, IsRefusedOrLoadsWhenItIsCut) {
  const std::string& bytes = GetParam().bytes;
  for (std::size_t size = 0; size < bytes.size(); ++size) expect_verdict(bytes.substr(0, size));
}

TEST_P(DamagedFile, IsRefusedOrLoadsWhenAByteIsChanged) {
  for (std::size_t at = 0; at < GetParam().bytes.size(); ++at) {
    for (const char wrong : "\xFF\x80\x7F\n\r\t #-.0129[{&*!:%'\""s + '\0' + '\1') {
      std::string bytes = GetParam().bytes;
      bytes[at] = wrong;
      expect_verdict(bytes);
    }
  }
}

TEST_P(DamagedFile, IsRefusedOrLoadsWhenAByteIsMissing) {
  for (std::size_t at = 0; at < GetParam().bytes.size(); ++at) {
    expect_verdict(std::string(GetParam().bytes).erase(at, 1));
  }
}

INSTANTIATE_TEST_SUITE_P(, DamagedFile, testing::ValuesIn(samples()),
                         [](const auto& sample) { return sample.param.name; });

/// Checksums would hide a PNG's other checks from random damage, so this test corrects them.
TEST(DamagedPng, WithGoodChecksumsIsRefusedOrLoads) {
  const std::string header = "\0\0\0\3\0\0\0\2\10\0\0\0\0"s;
  for (std::size_t at = 0; at < header.size(); ++at) {
    for (int wrong = 0; wrong < 256; ++wrong) {
      std::string damaged = header;
      damaged[at] = static_cast<char>(wrong);
      const std::string error = error_in_image(png_file::file(png_file::chunk("IHDR", damaged) +
                                                              png_file::chunk("PLTE", "abcdef") +
                                                              png_file::image_data("\0abc\0def"s)));
      EXPECT_LT(error.size(), 200U) << error;
    }
  }
}

}  // namespace
}  // namespace wend
