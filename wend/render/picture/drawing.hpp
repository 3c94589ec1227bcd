#pragma once

// A scene as a picture, PNG, SVG or PDF, 800 to 1600 pixels on its longer side, with a scale bar
// and a legend (which may add some lines to the height). Small maps are enlarged by whole numbers,
// so that cells are crisp; in large ones many cells share a pixel and obstacles weigh more than the
// space around them, so that thin walls stay visible. The map lies as its source file looks.
//
//   const auto png = wend::draw_png(scene);
//   if (png) wend::write_file("plan.png", *png);
//
// Where a cell has 30 pixels or more, the heatmap's values are written into it, below the numbers above them. Arrows get at least
// 15 pixels each: in larger maps blocks of cells share the arrow of their middle cell.
//
// O(cells + length of the path); memory in proportion to the picture, not to the map. The same
// scene gives the same bytes. The only error is that there is not enough memory.

#include <array>
#include <cstdint>
#include <string>

#include "wend/base/choice.hpp"
#include "wend/base/expected.hpp"
#include "wend/map/grid.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

enum class PictureKind : unsigned char { png, svg, pdf };

constexpr std::array<Choice<PictureKind>, 3> choice_names(PictureKind) {
  return {{{"png", PictureKind::png}, {"svg", PictureKind::svg}, {"pdf", PictureKind::pdf}}};
}

/// The bytes of a file of that kind.
Expected<std::string, Error> draw_picture(const Scene& scene, PictureKind kind,
                                          const Style& style = {});

/// The bytes of a PNG file.
inline Expected<std::string, Error> draw_png(const Scene& scene, const Style& style = {}) {
  return draw_picture(scene, PictureKind::png, style);
}

/// The text of an SVG file. The map comes as rectangles where few are enough, else as an embedded
/// image: the file stays small.
inline Expected<std::string, Error> draw_svg(const Scene& scene, const Style& style = {}) {
  return draw_picture(scene, PictureKind::svg, style);
}

/// The bytes of a PDF file of one page, 96 pixels an inch; like an SVG otherwise.
inline Expected<std::string, Error> draw_pdf(const Scene& scene, const Style& style = {}) {
  return draw_picture(scene, PictureKind::pdf, style);
}

enum class PixelLegend : unsigned char { none, below };

/// The picture as pixels of 0xRRGGBB, for animations: the map as large as fits into that size, in
/// whole pixels a cell where that enlarges it, without a margin. Equal sizes and styles give equal
/// sizes of pictures while maps and legends do. With a legend below, the map has less room.
/// Empty where there is not enough memory.
Grid<std::uint32_t> draw_pixels(const Scene& scene, int most_width, int most_height,
                                const Style& style = {}, PixelLegend legend = PixelLegend::none);

}  // namespace wend
