#pragma once

// A file of any kind with a picture in it.

#include <functional>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/scene_drawing.hpp"
#include "wend/render/render_error.hpp"

namespace wend {

/// The file's bytes, the same for the same drawing. `draw` gets a context of that many pixels.
Expected<std::string, RenderError> drawn_file(PictureKind kind, int width, int height,
                                              const std::function<void(cairo_t*)>& draw);

inline MapForm map_form(PictureKind kind) {
  return kind == PictureKind::png ? MapForm::image : MapForm::rectangles_if_few;
}

}  // namespace wend
