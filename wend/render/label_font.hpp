#pragma once

// The font of the labels in pictures.

#include "wend/render/cairo_objects.hpp"

namespace wend {

/// Selects it: whatever the system calls "sans-serif".
void select_label_font(cairo_t* context, double size);

}  // namespace wend
