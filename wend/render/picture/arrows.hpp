#pragma once

// Arrows: which way to move, cell by cell.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// One arrow, `length` pixels long.
void draw_arrow(cairo_t* context, Point centre, double length, Direction direction,
                const Colour& colour);

/// The arrows of a field. Where cells are too small for one each, blocks of cells share the arrow
/// of their middle cell. Raised ones leave room for a number below them.
void draw_arrows(cairo_t* context, const ArrowField& arrows, const MapView& view, bool raised,
                 const Style& style);

}  // namespace wend
