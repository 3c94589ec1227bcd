#pragma once

// Owners of cairo's objects, and wend's colours for them. The module's public headers (drawing.hpp
// and those beside it) do not include this: who draws needs no cairo headers.

#include <cairo.h>

#include <cstdint>
#include <memory>

#include "wend/map/grid.hpp"
#include "wend/render/style.hpp"

namespace wend {

struct CairoDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using CairoContext = std::unique_ptr<cairo_t, CairoDeleter>;

/// An RGB24 image of pixels of 0xRRGGBB. Cairo keeps sources longer than their users do, so it has
/// its own copy.
CairoSurface image_of(const Grid<std::uint32_t>& pixels);

inline void set_source(cairo_t* context, const Colour& colour, double opacity = 1) {
  cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, opacity);
}

}  // namespace wend
