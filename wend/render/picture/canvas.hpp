#pragma once

// Canvas: what all pictures draw with: cairo's objects and their owners, lines and areas in wend's
// colours, text, images, and files. The module's public headers (drawing.hpp, panels.hpp) do not
// include this: who draws needs no cairo headers.

#include <cairo.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/map/grid.hpp"
#include "wend/render/picture/drawing.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

struct CairoDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using CairoContext = std::unique_ptr<cairo_t, CairoDeleter>;

inline CairoSurface new_image(cairo_format_t format, int width, int height) {
  return CairoSurface(cairo_image_surface_create(format, width, height));
}

/// An RGB24 image of pixels of 0xRRGGBB. Cairo keeps sources longer than their users do, so it has
/// its own copy.
CairoSurface image_of(const Grid<std::uint32_t>& pixels);

/// The pixels of an RGB24 image as 0xRRGGBB; empty if the image has an error.
Grid<std::uint32_t> pixels_of(cairo_surface_t* image);

/// The same into a grid as large as the image; it becomes empty if the image has an error.
void copy_pixels(cairo_surface_t* image, Grid<std::uint32_t>& pixels);

/// The bytes of a file of any kind, the same for the same drawing. `draw` gets a context of that
/// many pixels, filled with the page's colour.
Expected<std::string, Error> drawn_file(PictureKind kind, int width, int height, const Colour& page,
                                        const std::function<void(cairo_t*)>& draw);

inline void set_source(cairo_t* context, const Colour& colour, double opacity = 1) {
  cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, opacity);
}

/// Strokes or fills what is traced, in the caps, joins and dashes that are set. The ones that keep
/// it leave what is traced to the next.
void stroke(cairo_t* context, double width, const Colour& colour, double opacity = 1);
void stroke_and_keep(cairo_t* context, double width, const Colour& colour, double opacity = 1);
void fill(cairo_t* context, const Colour& colour, double opacity = 1);
void fill_and_keep(cairo_t* context, const Colour& colour, double opacity = 1);

/// Adds a piece to what is traced.
void trace_line(cairo_t* context, Point from, Point to);

/// Traces a circle and nothing else.
void trace_circle(cairo_t* context, Point centre, double radius);

/// The font that the system calls "sans-serif", for what follows.
void select_label_font(cairo_t* context, double size);

/// In the font that is selected, pixels.
double text_width(cairo_t* context, std::string_view text);

/// Calls measure(context) with a context to measure text with, in that size.
void with_label_font(double size, const std::function<void(cairo_t*)>& measure);

/// From the left end of its baseline.
void draw_text(cairo_t* context, Point baseline, std::string_view text, const Colour& colour);

/// The text, or as much of its beginning as fits into that many pixels with an ellipsis.
std::string shortened(cairo_t* context, std::string_view text, double room);

}  // namespace wend
