// The map, and what tells where on it one is.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "wend/map/joined_rows.hpp"
#include "wend/render/picture/drawn_cells.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kGridLinesFrom = 12;          // pixels a cell
constexpr std::size_t kMostRectangles = 4000;  // about 50 bytes each in an SVG

constexpr double kLeastStriped = 5;  // pixels a cell
constexpr double kPeriod = 8;        // of stripes: pixels, across
constexpr double kStripe = 2.6;      // pixels wide

/// Colours times weights times areas, and what to divide them by.
struct Sum {
  double red = 0;
  double green = 0;
  double blue = 0;
  double weight = 0;

  void add(const Paint& paint, double area) {
    const double share = area * paint.weight;
    red += share * paint.colour.red;
    green += share * paint.colour.green;
    blue += share * paint.colour.blue;
    weight += share;
  }

  void add(const Sum& other, double area) {
    red += area * other.red;
    green += area * other.green;
    blue += area * other.blue;
    weight += area * other.weight;
  }

  std::uint32_t pixel() const { return rgb_of({red / weight, green / weight, blue / weight}); }
};

/// The cells of a pixel, by their colours.
class Votes {
 public:
  void add(const Paint& paint, bool obstacle) {
    const std::uint32_t rgb = rgb_of(paint.colour);
    if (obstacle) obstacles_ = {rgb, obstacles_.weight + 1};
    if (obstacle) return;
    const auto colour = std::ranges::find(others_, rgb, &Vote::rgb);
    colour == others_.end() ? others_.push_back({rgb, paint.weight})
                            : void(colour->weight += paint.weight);
  }

  /// Obstacles from that many cells on.
  std::uint32_t winner(double obstacles) const {
    if (others_.empty() || (obstacles_.weight > 0 && obstacles_.weight >= obstacles)) {
      return obstacles_.rgb;
    }
    return std::ranges::max_element(others_, {}, &Vote::weight)->rgb;
  }

 private:
  struct Vote {
    std::uint32_t rgb = 0;
    double weight = 0;
  };
  Vote obstacles_;
  std::vector<Vote> others_;  // few
};

/// Calls visit(pixel, overlap) for the pixels that cell `index` of `cells` covers when these are
/// spread over `pixels` pixels.
template <class Visit>
void for_pixels_of(int index, int cells, int pixels, Visit&& visit) {
  const double begin = static_cast<double>(index) * pixels / cells;
  const double end = static_cast<double>(index + 1) * pixels / cells;
  for (int pixel = static_cast<int>(begin); pixel < pixels && pixel < end; ++pixel) {
    visit(pixel, std::min<double>(end, pixel + 1) - std::max<double>(begin, pixel));
  }
}

/// Squeezes the cells of a row into the sums, from left to right.
void squeeze_row(const CellPaints& paints, int y, std::vector<Sum>& sums) {
  std::fill(sums.begin(), sums.end(), Sum{});
  const int pixels = static_cast<int>(sums.size());
  for (int x = 0; x < paints.width(); ++x) {
    const Paint paint = paints[{x, y}];
    for_pixels_of(x, paints.width(), pixels, [&](int pixel, double length) {
      sums[static_cast<std::size_t>(pixel)].add(paint, length);
    });
  }
}

/// Calls write(row, pixels) for the rows of an image, whole pixels a cell, from the top.
template <class Write>
void write_enlarged(const CellPaints& paints, int across, int down, const RowOrder& order,
                    Write&& write) {
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(across) *
                                    static_cast<std::size_t>(paints.width()));
  Colour last;
  std::uint32_t rgb = rgb_of(last);
  for (int n = 0; n < paints.height(); ++n) {
    auto pixel = pixels.begin();
    for (int x = 0; x < paints.width(); ++x) {
      const Colour colour = paints[{x, order.row(n)}].colour;
      if (colour != last) rgb = rgb_of(colour);
      last = colour;
      pixel = std::fill_n(pixel, across, rgb);
    }
    for (int i = 0; i < down; ++i) write(n * down + i, std::span<const std::uint32_t>(pixels));
  }
}

/// The same for any size.
template <class Write>
void write_map(const CellPaints& paints, int width, int height, bool y_up, Write&& write) {
  const RowOrder order{paints.height(), y_up};
  if (width % paints.width() == 0 && height % paints.height() == 0) {
    return write_enlarged(paints, width / paints.width(), height / paints.height(), order, write);
  }
  std::vector<Sum> cells(static_cast<std::size_t>(width));
  std::vector<Sum> sums(cells.size());
  std::vector<std::uint32_t> pixels(cells.size());
  int row = 0;  // of these sums
  const auto write_row = [&] {
    std::ranges::transform(sums, pixels.begin(), &Sum::pixel);
    std::ranges::fill(sums, Sum{});
    write(row, std::span<const std::uint32_t>(pixels));
  };
  for (int n = 0; n < paints.height(); ++n) {
    squeeze_row(paints, order.row(n), cells);
    for_pixels_of(n, paints.height(), height, [&](int covered, double area) {
      if (covered != row) write_row();
      row = covered;
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(cells[i], area);
    });
  }
  write_row();
}

/// Writes the map's pixels straight into an image that is drawn on. False if that is not one, or not of pixels.
bool write_into_image(const SceneDrawing& drawing, const CellPaints& paints) {
  const MapView& view = drawing.view;
  cairo_surface_t* const image = cairo_get_target(drawing.context);
  if (cairo_surface_get_type(image) != CAIRO_SURFACE_TYPE_IMAGE) return false;
  const auto left = static_cast<int>(view.left);
  const auto top = static_cast<int>(view.top);
  if (left != view.left || top != view.top || left < 0 || top < 0 ||
      left + view.width > cairo_image_surface_get_width(image) ||
      top + view.height > cairo_image_surface_get_height(image)) {
    return false;
  }
  cairo_surface_flush(image);
  unsigned char* const bytes = cairo_image_surface_get_data(image);
  if (bytes == nullptr) return false;
  const auto stride = static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(image));
  write_map(paints, view.width, view.height, view.y_up,
            [&](int row, std::span<const std::uint32_t> pixels) {
              constexpr std::uint32_t kOpaque = 0xFF000000U;
              unsigned char* const begin = bytes + (top + row) * stride;
              auto* const to = reinterpret_cast<std::uint32_t*>(begin) + left;
              std::ranges::transform(pixels, to, [](std::uint32_t rgb) { return rgb | kOpaque; });
            });
  cairo_surface_mark_dirty_rectangle(image, left, top, view.width, view.height);
  return true;
}

/// The runs of equal colour in row y, as rectangles one cell high, from left to right.
std::vector<MapRectangle> runs_of_row(const CellPaints& paints, int y, const Colour& background) {
  std::vector<MapRectangle> runs;
  for_runs(
      paints.width(), [&](int x) { return paints[{x, y}].colour; },
      [&](int x, int length, const Colour& colour) {
        if (colour != background) runs.push_back({colour, x, y, length, 1});
      });
  return runs;
}

bool by_colour(const MapRectangle& a, const MapRectangle& b) {
  const auto key = [](const MapRectangle& rectangle) {
    const Colour& colour = rectangle.colour;
    return std::tuple(colour.red, colour.green, colour.blue, rectangle.y, rectangle.x);
  };
  return key(a) < key(b);
}

PictureArea area_of(const MapView& view, Cell first, int columns, int rows) {
  const auto corner = [&](int x, int y) {
    return view.to_picture({static_cast<double>(x), static_cast<double>(y)});
  };
  const Point a = corner(first.x, first.y);
  const Point b = corner(first.x + columns, first.y + rows);
  return {a.x, std::min(a.y, b.y), b.x - a.x, std::abs(b.y - a.y)};
}

void draw_map_image(const SceneDrawing& drawing, const Grid<std::uint32_t>& pixels) {
  const MapView& view = drawing.view;
  const CairoSurface image = image_of(pixels);
  cairo_set_source_surface(drawing.context, image.get(), view.left, view.top);
  cairo_pattern_set_filter(cairo_get_source(drawing.context), CAIRO_FILTER_NEAREST);
  cairo_rectangle(drawing.context, view.left, view.top, view.width, view.height);
  cairo_fill(drawing.context);
}

void draw_map_rectangles(const SceneDrawing& drawing, const std::vector<MapRectangle>& rectangles) {
  const MapView& view = drawing.view;
  set_source(drawing.context, drawing.style.free);
  cairo_rectangle(drawing.context, view.left, view.top, view.width, view.height);
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const MapRectangle& cells = rectangles[i];
    if (i == 0 || cells.colour != rectangles[i - 1].colour) {
      cairo_fill(drawing.context);
      set_source(drawing.context, cells.colour);
    }
    trace_area(drawing.context, area_of(view, {cells.x, cells.y}, cells.width, cells.height));
  }
  cairo_fill(drawing.context);
}

void draw_tick(cairo_t* context, Point from, Point to, const Colour& ink) {
  cairo_new_path(context);
  trace_line(context, from, to);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  stroke(context, 1, ink, 0.6);
}

void draw_columns(const SceneDrawing& drawing, int step) {
  const MapView& view = drawing.view;
  const Colour& ink = drawing.style.ink;
  const double edge = view.y_up ? view.bottom() + 0.5 : view.top - 0.5;
  const double outwards = view.y_up ? 1 : -1;
  const double baseline =
      edge + outwards * (kAxisTick + kAxisGap) + (view.y_up ? kAxisDigitHeight : 0);
  for (int x = 0; x <= view.columns; x += step) {
    const double at = std::round(view.to_picture({static_cast<double>(x), 0}).x);
    draw_tick(drawing.context, {at + 0.5, edge}, {at + 0.5, edge + outwards * kAxisTick}, ink);
    const std::string number = std::to_string(x);
    const double left = at - text_width(drawing.context, number) / 2;
    draw_text(drawing.context, {left, baseline}, number, ink);
  }
}

void draw_rows(const SceneDrawing& drawing, int step) {
  const MapView& view = drawing.view;
  const Colour& ink = drawing.style.ink;
  const double edge = view.left - 0.5;
  for (int y = 0; y <= view.rows; y += step) {
    const double at = std::round(view.to_picture({0, static_cast<double>(y)}).y);
    draw_tick(drawing.context, {edge, at + 0.5}, {edge - kAxisTick, at + 0.5}, ink);
    const std::string number = std::to_string(y);
    const double left = edge - kAxisTick - kAxisGap - text_width(drawing.context, number);
    draw_text(drawing.context, {left, at + kAxisDigitHeight / 2}, number, ink);
  }
}

}  // namespace

Grid<std::uint32_t> map_image(const CellPaints& paints, int width, int height, bool y_up) {
  Grid<std::uint32_t> image(width, height);
  write_map(paints, width, height, y_up, [&](int row, std::span<const std::uint32_t> pixels) {
    std::ranges::copy(pixels, image.row(row).begin());
  });
  return image;
}

Grid<std::uint32_t> dominant_image(const CellPaints& paints, int width, int height, bool y_up) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Grid<Votes> votes(width, height, std::vector<Votes>(pixels));
  const auto pixel_of = [](int index, int cells, int pixels) {
    return static_cast<int>((static_cast<std::int64_t>(2 * index) + 1) * pixels / (2LL * cells));
  };
  const RowOrder order{paints.height(), y_up};
  for (int n = 0; n < paints.height(); ++n) {
    const int row = pixel_of(n, paints.height(), height);
    for (int x = 0; x < paints.width(); ++x) {
      const Cell cell{x, order.row(n)};
      votes[{pixel_of(x, paints.width(), width), row}].add(paints[cell], paints.is_obstacle(cell));
    }
  }
  const double side = std::max(static_cast<double>(paints.width()) / width,
                               static_cast<double>(paints.height()) / height);
  Grid<std::uint32_t> image(width, height);
  constexpr double kMostOfAWall =
      0.75;  // of what a wall one cell wide has in a pixel that it crosses
  for (const Cell pixel : every_cell(image))
    image[pixel] = votes[pixel].winner(kMostOfAWall * side);
  return image;
}

std::optional<std::vector<MapRectangle>> map_rectangles(const CellPaints& paints,
                                                        const Colour& background,
                                                        std::size_t most) {
  auto rectangles = joined_rows<MapRectangle>(
      paints.height(), most, [&](int y) { return runs_of_row(paints, y, background); },
      [](const MapRectangle& a, const MapRectangle& b) { return a.colour == b.colour; });
  if (rectangles) std::sort(rectangles->begin(), rectangles->end(), by_colour);
  return rectangles;
}

void trace_area(cairo_t* context, const PictureArea& area) {
  cairo_rectangle(context, area.left, area.top, area.width, area.height);
}

void draw_stripes(cairo_t* context, const PictureArea& area, const Stripes& stripes) {
  cairo_save(context);
  trace_area(context, area);
  fill_and_keep(context, stripes.base);
  cairo_clip(context);
  // Stripes lie where x + y is a multiple of the period.
  const double nearest = area.left + area.top;
  const auto first = static_cast<int>(std::floor(nearest / kPeriod));
  const auto last = static_cast<int>((nearest + area.width + area.height) / kPeriod);
  for (int i = first; i <= last; ++i) {
    cairo_move_to(context, i * kPeriod - area.top, area.top);
    cairo_rel_line_to(context, -area.height, area.height);
  }
  cairo_set_line_cap(context, CAIRO_LINE_CAP_SQUARE);
  stroke(context, kStripe, stripes.stripe);
  cairo_restore(context);
}

void draw_stripes(const SceneDrawing& drawing) {
  if (drawing.view.scale() < kLeastStriped) return;
  const CellPaints paints(drawing.scene, drawing.style);
  for (int y = 0; y < paints.height(); ++y) {
    for_runs(
        paints.width(), [&](int x) { return paints.stripes({x, y}); },
        [&](int x, int length, const std::optional<Stripes>& stripes) {
          if (!stripes) return;
          draw_stripes(drawing.context, area_of(drawing.view, {x, y}, length, 1), *stripes);
        });
  }
}

void draw_map(const SceneDrawing& drawing, PictureKind kind) {
  const CellPaints paints(drawing.scene, drawing.style);
  if (kind != PictureKind::png) {
    if (const auto rectangles = map_rectangles(paints, drawing.style.free, kMostRectangles)) {
      return draw_map_rectangles(drawing, *rectangles);
    }
  }
  if (write_into_image(drawing, paints)) return;
  const MapView& view = drawing.view;
  draw_map_image(drawing, map_image(paints, view.width, view.height, view.y_up));
}

void draw_dominant_map(const SceneDrawing& drawing) {
  const MapView& view = drawing.view;
  const CellPaints paints(drawing.scene, drawing.style);
  draw_map_image(drawing, dominant_image(paints, view.width, view.height, view.y_up));
}

void draw_grid_lines(const SceneDrawing& drawing) {
  const MapView& view = drawing.view;
  const int unit = drawing.scene.places.spacing;
  if (unit * view.scale() >= kGridLinesFrom) {
    for (int x = unit; x < view.columns; x += unit) {
      const double at = std::floor(view.to_picture({static_cast<double>(x), 0}).x) + 0.5;
      trace_line(drawing.context, {at, view.top}, {at, view.bottom()});
    }
    for (int y = unit; y < view.rows; y += unit) {
      const double at = std::floor(view.to_picture({0, static_cast<double>(y)}).y) + 0.5;
      trace_line(drawing.context, {view.left, at}, {view.left + view.width, at});
    }
    stroke(drawing.context, 1, drawing.style.grid_lines, 0.13);
  }
  cairo_rectangle(drawing.context, view.left - 0.5, view.top - 0.5, view.width + 1,
                  view.height + 1);
  stroke(drawing.context, 1, drawing.style.ink);
}

void draw_axes(const SceneDrawing& drawing) {
  if (!drawing.scene.places.on_corners()) return;
  const int step = axis_step(drawing.scene, drawing.view.scale());
  select_label_font(drawing.context, kAxisFontSize);
  draw_columns(drawing, step);
  draw_rows(drawing, step);
}

}  // namespace wend
