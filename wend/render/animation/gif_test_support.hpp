#pragma once

// GIFs in tests: decoded by giflib and put together frame by frame as a viewer does it.

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "wend/map/grid.hpp"

namespace wend::test {

using Image = Grid<std::uint32_t>;

struct Shown {
  Image image;
  int centiseconds;
};

struct Decoded {
  std::vector<Shown> frames;
  bool for_ever = false;
  std::size_t stored_pixels = 0;
};

inline int read_bytes(GifFileType* file, GifByteType* to, int length) {
  auto& rest = *static_cast<std::string_view*>(file->UserData);
  const std::size_t count =
      rest.copy(reinterpret_cast<char*>(to), static_cast<std::size_t>(length));
  rest.remove_prefix(count);
  return static_cast<int>(count);
}

inline bool says_for_ever(const SavedImage& first) {
  for (int i = 0; i + 1 < first.ExtensionBlockCount; ++i) {
    const ExtensionBlock& name = first.ExtensionBlocks[i];
    const ExtensionBlock& value = first.ExtensionBlocks[i + 1];
    if (name.Function == APPLICATION_EXT_FUNC_CODE && name.ByteCount == 11 &&
        std::memcmp(name.Bytes, "NETSCAPE2.0", 11) == 0) {
      return value.ByteCount == 3 && std::memcmp(value.Bytes, "\1\0\0", 3) == 0;
    }
  }
  return false;
}

inline void paint(Image& canvas, const SavedImage& part, const ColorMapObject& colours,
                  int transparent) {
  const GifImageDesc& area = part.ImageDesc;
  for (int i = 0; i < area.Width * area.Height; ++i) {
    const int index = part.RasterBits[i];
    if (index == transparent) continue;
    ASSERT_LT(index, colours.ColorCount);
    const GifColorType& colour = colours.Colors[index];
    canvas[{area.Left + i % area.Width, area.Top + i / area.Width}] =
        static_cast<std::uint32_t>(colour.Red << 16 | colour.Green << 8 | colour.Blue);
  }
}

inline Decoded decoded(std::string_view bytes) {
  Decoded animation;
  int error = 0;
  GifFileType* file = DGifOpen(&bytes, read_bytes, &error);
  EXPECT_NE(file, nullptr) << GifErrorString(error);
  EXPECT_EQ(DGifSlurp(file), GIF_OK) << GifErrorString(file->Error);
  Image canvas(file->SWidth, file->SHeight, 0xBADBAD);
  for (int i = 0; i < file->ImageCount; ++i) {
    const SavedImage& part = file->SavedImages[i];
    GraphicsControlBlock control{};
    EXPECT_EQ(DGifSavedExtensionToGCB(file, i, &control), GIF_OK);
    EXPECT_EQ(control.DisposalMode, DISPOSE_DO_NOT);
    EXPECT_EQ(part.ImageDesc.ColorMap, nullptr);
    paint(canvas, part, *file->SColorMap, control.TransparentColor);
    animation.frames.push_back({canvas, control.DelayTime});
    animation.stored_pixels += static_cast<std::size_t>(part.ImageDesc.Width) *
                               static_cast<std::size_t>(part.ImageDesc.Height);
  }
  if (file->ImageCount > 0) animation.for_ever = says_for_ever(file->SavedImages[0]);
  EXPECT_EQ(DGifCloseFile(file, &error), GIF_OK);
  EXPECT_TRUE(bytes.empty()) << "something follows the end";
  return animation;
}

}  // namespace wend::test
