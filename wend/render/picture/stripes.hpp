#pragma once

// Diagonal stripes in the colour of rough ground over that of a role, so that both are seen.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/cell_paints.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// In pixels.
struct PictureArea {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

/// Fills an area; stripes of areas beside each other meet.
void draw_stripes(cairo_t* context, const PictureArea& area, const Stripes& stripes);

/// Over the cells of a map that need them. Nothing where cells are too small to see a stripe.
void draw_stripes(cairo_t* context, const CellPaints& paints, const MapView& view);

}  // namespace wend
