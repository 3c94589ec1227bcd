#pragma once

// A scene as a picture, PNG or SVG, 800 to 1600 pixels on its longer side, with a scale bar and a
// legend. Small maps are enlarged by whole numbers, so that cells are crisp; in large ones many
// cells share a pixel and obstacles weigh more than the space around them, so that thin walls stay
// visible. The map lies as its source file looks.
//
//   const auto png = wend::draw_png(scene);
//   if (png) wend::write_file("plan.png", *png);
//
// O(cells + length of the path); memory in proportion to the picture, not to the map. The only
// error is that there is not enough of it.

#include <string>

#include "wend/base/expected.hpp"
#include "wend/render/render_error.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// The bytes of a PNG file.
Expected<std::string, RenderError> draw_png(const Scene& scene, const Style& style = {});

/// The text of an SVG file. The map comes as rectangles where few are enough, else as an embedded
/// image: the file stays small.
Expected<std::string, RenderError> draw_svg(const Scene& scene, const Style& style = {});

}  // namespace wend
