#include "wend/render/animation/gif.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "wend/base/random.hpp"
#include "wend/render/animation/gif_test_support.hpp"

namespace wend {
namespace {

using testing::ElementsAre;

using test::Decoded;
using test::decoded;
using test::Image;
using test::Shown;

Image image(std::initializer_list<std::initializer_list<std::uint32_t>> rows) {
  Image pixels(static_cast<int>(rows.begin()->size()), static_cast<int>(rows.size()));
  int y = 0;
  for (const auto& row : rows) std::copy(row.begin(), row.end(), pixels.row(y++).begin());
  return pixels;
}

constexpr std::uint32_t kRed = 0xFF0000;
constexpr std::uint32_t kBlue = 0x0000FF;
constexpr std::uint32_t kWhite = 0xFFFFFF;

std::string encoded(const std::vector<Shown>& frames, std::vector<std::uint32_t> palette) {
  const Image& first = frames.front().image;
  GifAnimation animation(first.width(), first.height(), std::move(palette));
  for (const Shown& frame : frames) animation.add(frame.image, frame.centiseconds);
  return animation.finish().value();
}

TEST(Gif, ShowsItsFramesForTheirTimeForEver) {
  const Image red = image({{kRed, kWhite}, {kRed, kRed}});
  const Image blue = image({{kRed, kWhite}, {kBlue, kRed}});
  const Decoded animation = decoded(encoded({{red, 10}, {blue, 250}}, {kRed, kWhite, kBlue}));
  EXPECT_TRUE(animation.for_ever);
  ASSERT_EQ(animation.frames.size(), 2U);
  EXPECT_EQ(animation.frames[0].image, red);
  EXPECT_EQ(animation.frames[0].centiseconds, 10);
  EXPECT_EQ(animation.frames[1].image, blue);
  EXPECT_EQ(animation.frames[1].centiseconds, 250);
  EXPECT_EQ(animation.stored_pixels, 5U) << "all of the first frame, one pixel of the second";
}

TEST(Gif, EqualFramesBecomeOneThatStaysLonger) {
  const Image red = image({{kRed}});
  const Image blue = image({{kBlue}});
  const Decoded animation =
      decoded(encoded({{red, 1}, {red, 2}, {blue, 3}, {blue, 4}, {red, 5}}, {kRed, kBlue}));
  ASSERT_EQ(animation.frames.size(), 3U);
  EXPECT_EQ(animation.frames[0].centiseconds, 3);
  EXPECT_EQ(animation.frames[1].centiseconds, 7);
  EXPECT_EQ(animation.frames[2].image, red);
}

TEST(Gif, FramesMayStayLongerThanAFrameCanSay) {
  const Image red = image({{kRed, kWhite}});
  const Decoded animation =
      decoded(encoded({{red, 65535}, {red, 65535}, {red, 30}}, {kRed, kWhite}));
  int centiseconds = 0;
  for (const Shown& frame : animation.frames) {
    EXPECT_EQ(frame.image, red);
    centiseconds += frame.centiseconds;
  }
  EXPECT_EQ(centiseconds, 131100);
  EXPECT_EQ(animation.frames.size(), 3U);
}

TEST(Gif, ColoursThatAreNotInThePaletteBecomeTheNearest) {
  const Decoded animation =
      decoded(encoded({{image({{0xE01010, 0x2000D0, 0xF0F0F0, kRed}}), 1}}, {kRed, kBlue, kWhite}));
  EXPECT_EQ(animation.frames.front().image, image({{kRed, kBlue, kWhite, kRed}}));
}

TEST(Gif, WithoutFramesIsAnError) {
  GifAnimation animation(2, 2, {kRed});
  EXPECT_EQ(animation.finish().error().message, "an animation without frames");
}

TEST(Gif, MayBeDroppedUnfinished) {
  GifAnimation animation(2, 1, {kRed, kBlue});
  animation.add(image({{kRed, kBlue}}), 1);
  animation = GifAnimation(1, 1, {kRed});
  animation.add(image({{kRed}}), 1);
  EXPECT_EQ(decoded(animation.finish().value()).frames.size(), 1U);
}

TEST(GifPalette, HasTheMostFrequentColoursFirst) {
  const std::vector<Image> frames{image({{kBlue, kRed}}), image({{kWhite, kRed}})};
  EXPECT_THAT(palette_of(frames), ElementsAre(kRed, kBlue, kWhite));
  EXPECT_TRUE(palette_of({}).empty());
}

TEST(GifPalette, LeavesOutTheRarestColoursOfTooMany) {
  Image many(30, 20);
  for (int i = 0; i < 600; ++i) many[{i % 30, i / 30}] = i < 300 ? i : i - 299;  // 0 only once
  const auto palette = palette_of({&many, 1});
  std::vector<std::uint32_t> expected(kMostGifColours);
  std::iota(expected.begin(), expected.end(), 1U);
  EXPECT_EQ(palette, expected);
}

/// Frames with changes at random places, in `colours` colours.
std::vector<Shown> random_film(Random& random, int width, int height, int colours) {
  std::vector<Shown> frames;
  Image canvas(width, height, 0x123456);
  for (int count = random.between(1, 8); count > 0; --count) {
    for (int change = random.between(0, 3); change > 0; --change) {
      const Cell corner{random.between(0, width - 1), random.between(0, height - 1)};
      const Cell other{random.between(corner.x, width - 1), random.between(corner.y, height - 1)};
      for (int y = corner.y; y <= other.y; ++y) {
        for (int x = corner.x; x <= other.x; ++x) {
          if (random.chance(0.2)) continue;
          canvas[{x, y}] = static_cast<std::uint32_t>(random.between(0, colours - 1)) * 65'793U;
        }
      }
    }
    frames.push_back({canvas, random.between(0, 50)});
  }
  return frames;
}

std::vector<std::uint32_t> palette_of(const std::vector<Shown>& film) {
  std::vector<Image> images;
  for (const Shown& frame : film) images.push_back(frame.image);
  return palette_of(std::span<const Image>(images));
}

RC_GTEST_PROP(Gif, ShowsEveryFrameAsItWasGiven, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const auto film = random_film(random, random.between(1, 40), random.between(1, 40),
                                random.chance(0.5) ? random.between(1, 4) : 250);
  const Decoded animation = decoded(encoded(film, palette_of(film)));
  std::vector<Shown> merged;
  for (const Shown& frame : film) {
    if (!merged.empty() && merged.back().image == frame.image) {
      merged.back().centiseconds += frame.centiseconds;
    } else {
      merged.push_back(frame);
    }
  }
  RC_ASSERT(animation.for_ever);
  RC_ASSERT(animation.frames.size() == merged.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    RC_ASSERT(animation.frames[i].image == merged[i].image);
    RC_ASSERT(animation.frames[i].centiseconds == merged[i].centiseconds);
  }
}

TEST(Gif, OfASmallChangeInALargePictureIsSmall) {
  constexpr int kSize = 400;
  constexpr int kFrames = 100;
  Random random(7);
  Image canvas(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) canvas[{x, y}] = random.chance(0.3) ? kBlue : kWhite;
  }
  GifAnimation animation(kSize, kSize, {kWhite, kBlue, kRed});
  std::size_t first = 0;
  for (int i = 0; i < kFrames; ++i) {
    canvas[{random.between(0, kSize - 1), random.between(0, kSize - 1)}] = kRed;
    canvas[{random.between(0, kSize - 1), random.between(0, kSize - 1)}] = kRed;
    animation.add(canvas, 4);
    if (i == 0) first = encoded({{canvas, 4}}, {kWhite, kBlue, kRed}).size();
  }
  const std::string bytes = animation.finish().value();
  EXPECT_LT(first, std::size_t{kSize} * kSize / 4) << "noise of two colours";
  EXPECT_LT(bytes.size() - first, std::size_t{kSize} * kSize * kFrames / 100) << "the other frames";
}

}  // namespace
}  // namespace wend
