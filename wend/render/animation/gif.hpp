#pragma once

// GifAnimation: pictures one after the other as an animated GIF that plays for ever.
//
//   wend::GifAnimation animation(width, height, wend::palette_of(frames));
//   for (const auto& frame : frames) animation.add(frame, 10);
//   const auto bytes = animation.finish();
//
// Frames are written as they come and none is kept: memory is seven bytes a pixel and what the
// file takes so far. After the first frame only the rectangle that changes is stored, and in it the
// pixels that stay as they are cost next to nothing. A frame equal to the one before makes that one
// stay longer.
//
// Adding a frame takes O(pixels), and O(colours of the palette) for each colour that it has not.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/map/grid.hpp"
#include "wend/render/scene.hpp"

namespace wend {

/// A GIF has 256 colours; one of them stands for what does not change.
inline constexpr std::size_t kMostGifColours = 255;

/// The longer side of the largest GIF.
inline constexpr int kMostGifPixels = 65535;

/// The most frequent colours (0xRRGGBB) of these pictures, at most kMostGifColours, the most
/// frequent one first; of those as frequent as each other the darker number. O(pixels).
std::vector<std::uint32_t> palette_of(std::span<const Grid<std::uint32_t>> frames);

class GifAnimation {
 public:
  /// Width and height from 1 to kMostGifPixels; 1 to kMostGifColours colours as 0xRRGGBB. Colours
  /// of frames that are not among them become the nearest (Euclidean in RGB).
  GifAnimation(int width, int height, std::vector<std::uint32_t> palette);
  GifAnimation(const GifAnimation&) = delete;
  GifAnimation& operator=(const GifAnimation&) = delete;
  GifAnimation(GifAnimation&&) noexcept;
  GifAnimation& operator=(GifAnimation&&) noexcept;
  ~GifAnimation();

  /// A frame of that width and height, 0xRRGGBB, to be shown for that long, at least 0. Viewers
  /// tend to take 0 and 1 hundredths of a second for 10.
  void add(const Grid<std::uint32_t>& pixels, int centiseconds);

  /// The bytes of the file. Fails if there was no memory or no frame. To be called once.
  Expected<std::string, Error> finish();

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace wend
