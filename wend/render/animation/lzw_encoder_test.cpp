#include "wend/render/animation/lzw_encoder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string_view>

#include "wend/base/random.hpp"

namespace wend {
namespace {

using Pixels = std::vector<std::uint8_t>;

/// The codes of blocks, and a decoder as simple as can be: every word in full.
class Decoder {
 public:
  Decoder(std::string_view blocks, int bits) : clear_(1U << static_cast<unsigned>(bits)) {
    while (!blocks.empty() && blocks.front() != 0) {
      const auto length = static_cast<std::uint8_t>(blocks.front());
      bytes_ += blocks.substr(1, length);
      blocks.remove_prefix(length + 1U);
    }
    EXPECT_EQ(blocks, std::string_view("\0", 1));
  }

  Pixels pixels() {
    Pixels all;
    Pixels last;
    for (unsigned code = next(); code != clear_ + 1; code = next()) {
      ++codes_;
      if (code == clear_) {
        words_.clear();
        last.clear();
        continue;
      }
      Pixels word = code < words_.size() ? words_[code] : last;
      if (words_.empty()) word = first_words(code);
      if (code >= words_.size()) word.push_back(last.front());
      if (!last.empty()) {
        last.push_back(word.front());
        words_.push_back(last);
      }
      all.insert(all.end(), word.begin(), word.end());
      last = word;
    }
    EXPECT_LE(bytes_.size() * 8 - at_, 7U) << "bits behind the end";
    return all;
  }

  std::size_t codes() const { return codes_; }

 private:
  Pixels first_words(unsigned code) {
    for (unsigned pixel = 0; pixel < clear_; ++pixel) {
      words_.push_back({static_cast<std::uint8_t>(pixel)});
    }
    words_.resize(clear_ + 2);
    return words_.at(code);
  }

  unsigned next() {
    unsigned width = 1;
    // As many bits as the next word would need.
    const std::size_t known = std::max<std::size_t>(words_.size(), clear_ + 1);
    while ((known >> width) != 0 && width < 12) ++width;
    unsigned code = 0;
    for (unsigned i = 0; i < width; ++i, ++at_) {
      const auto byte = static_cast<std::uint8_t>(bytes_.at(at_ / 8));
      code |= (byte >> at_ % 8 & 1U) << i;
    }
    return code;
  }

  unsigned clear_;
  std::string bytes_;
  std::size_t at_ = 0;
  std::vector<Pixels> words_;
  std::size_t codes_ = 0;
};

struct Run {
  std::uint8_t pixel;
  int length;
};

std::vector<Run> random_runs(Random& random, int bits) {
  const int colours = random.between(1, 1 << bits);
  const int longest = random.chance(0.5) ? random.between(1, 3) : random.between(1, 2000);
  std::vector<Run> runs;
  for (int count = random.between(1, random.chance(0.1) ? 6000 : 200); count > 0; --count) {
    runs.push_back({static_cast<std::uint8_t>(random.between(0, colours - 1)),
                    random.between(runs.empty() ? 1 : 0, longest)});
  }
  return runs;
}

Pixels pixels_of(const std::vector<Run>& runs) {
  Pixels pixels;
  for (const Run& run : runs) {
    pixels.insert(pixels.end(), static_cast<std::size_t>(run.length), run.pixel);
  }
  return pixels;
}

RC_GTEST_PROP(Lzw, IsDecodedToWhatWasGiven, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const int bits = random.between(2, 8);
  LzwEncoder encoder(bits);
  for (int image = 0; image < 3; ++image) {
    const auto runs = random_runs(random, bits);
    for (const Run& run : runs) encoder.add(run.pixel, run.length);
    RC_ASSERT(Decoder(encoder.finish(), bits).pixels() == pixels_of(runs));
  }
}

RC_GTEST_PROP(Lzw, TakesTheSameWordsPixelByPixel, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const int bits = random.between(2, 8);
  const auto runs = random_runs(random, bits);
  LzwEncoder by_runs(bits);
  LzwEncoder by_pixels(bits);
  for (const Run& run : runs) by_runs.add(run.pixel, run.length);
  for (const std::uint8_t pixel : pixels_of(runs)) by_pixels.add(pixel, 1);
  RC_ASSERT(by_runs.finish() == by_pixels.finish());
}

TEST(Lzw, NeedsFewCodesForALongRun) {
  LzwEncoder encoder(8);
  encoder.add(7, 500'000);
  Decoder decoder(encoder.finish(), 8);
  EXPECT_EQ(decoder.pixels(), Pixels(500'000, 7));
  EXPECT_LE(decoder.codes(), 1002U) << "words of 1, 2, 3, ... pixels";
}

}  // namespace
}  // namespace wend
