#pragma once

// A scene as a picture in a file, 800 to 1600 pixels on its longer side, with a scale bar and a
// legend. Small maps are enlarged by whole numbers, so that cells are crisp; in large ones many
// cells share a pixel and obstacles weigh more than the space around them, so that thin walls stay
// visible. The map lies as its source file looks.
//
//   if (const auto drawn = wend::draw_png(scene, "plan.png"); !drawn) {
//     std::cerr << drawn.error().message() << '\n';
//   }
//
// O(cells + length of the path); memory in proportion to the picture, not to the map. A file is
// written in full or not at all: an error leaves what was there before.

#include <filesystem>

#include "wend/base/expected.hpp"
#include "wend/render/render_error.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

Expected<void, RenderError> draw_png(const Scene& scene, const std::filesystem::path& file,
                                     const Style& style = {});

/// The map as rectangles where few are enough, else as an embedded image: the file stays small.
Expected<void, RenderError> draw_svg(const Scene& scene, const std::filesystem::path& file,
                                     const Style& style = {});

}  // namespace wend
