#pragma once

// A scene drawn on a cairo context: the map, and what lies on it.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// Vector formats take rectangles while they are few.
enum class MapForm : unsigned char { image, rectangles_if_few };

void draw_scene(cairo_t* context, const Scene& scene, const MapView& view, const Style& style,
                MapForm form);

}  // namespace wend
