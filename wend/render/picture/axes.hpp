#pragma once

// Axes: the numbers of a lattice's corners at the sides of a map, where a scene has a unit: columns
// along row 0 (so above the map where y is down, below it where y is up), rows at the left. Every
// corner has its number where there is room, else every second, fifth, tenth and so on.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// Around the view, in the room that axis_room() asks for.
void draw_axes(cairo_t* context, const Scene& scene, const MapView& view, const Style& style);

}  // namespace wend
