#include "wend/render/picture/sparse_dots.hpp"

#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/render/picture/sparse_cells.hpp"

namespace wend {
namespace {

constexpr double kDot = 9;     // pixels across
constexpr double kRim = 1.25;  // pixels

template <class Draw>
void for_sparse_cells(const Scene& scene, const MapView& view, double dot, Draw&& draw) {
  for (const MarkedCells& marked : scene.marked) {
    for (const Cell cell : sparse_cells(marked, view.scale(), dot)) {
      if (scene.space.map().state(cell) == CellState::occupied) continue;
      draw(view.to_picture(centre_of(cell)), marked.role);
    }
  }
}

}  // namespace

void draw_sparse_cells(cairo_t* context, const Scene& scene, const MapView& view,
                       const Style& style) {
  for_sparse_cells(scene, view, kDot, [&](Point centre, CellRole role) {
    cairo_new_path(context);
    cairo_arc(context, centre.x, centre.y, kDot / 2, 0, 2 * kPi);
    set_source(context, style.of(role));
    cairo_fill_preserve(context);
    set_source(context, style.ink);
    cairo_set_line_width(context, kRim);
    cairo_stroke(context);
  });
}

void draw_sparse_pixels(cairo_t* context, const Scene& scene, const MapView& view,
                        const Style& style) {
  for_sparse_cells(scene, view, 1, [&](Point centre, CellRole role) {
    cairo_rectangle(context, std::floor(centre.x), std::floor(centre.y), 1, 1);
    set_source(context, style.of(role));
    cairo_fill(context);
  });
}

}  // namespace wend
