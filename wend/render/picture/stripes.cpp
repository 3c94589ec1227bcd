#include "wend/render/picture/stripes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "wend/geometry/cell.hpp"

namespace wend {
namespace {

constexpr double kLeastCell = 5;  // pixels
constexpr double kPeriod = 8;     // pixels, across
constexpr double kStripe = 2.6;   // pixels wide

/// Cells that follow each other in a row.
struct Run {
  Cell first;
  int length = 0;
  Stripes stripes;
};

std::vector<Run> runs_of(const CellPaints& paints) {
  std::vector<Run> runs;
  for (int y = 0; y < paints.height(); ++y) {
    std::optional<Stripes> last;
    for (int x = 0; x < paints.width(); ++x) {
      const auto stripes = paints.stripes({x, y});
      if (stripes && stripes == last) {
        ++runs.back().length;
      } else if (stripes) {
        runs.push_back({{x, y}, 1, *stripes});
      }
      last = stripes;
    }
  }
  return runs;
}

PictureArea area_of(const Run& run, const MapView& view) {
  const double x = run.first.x;
  const double y = run.first.y;
  const Point a = view.to_picture({x, y});
  const Point b = view.to_picture({x + run.length, y + 1});
  return {a.x, std::min(a.y, b.y), b.x - a.x, std::abs(b.y - a.y)};
}

}  // namespace

void draw_stripes(cairo_t* context, const PictureArea& area, const Stripes& stripes) {
  cairo_save(context);
  cairo_rectangle(context, area.left, area.top, area.width, area.height);
  set_source(context, stripes.base);
  cairo_fill_preserve(context);
  cairo_clip(context);
  // Stripes lie where x + y is a multiple of the period.
  const double nearest = area.left + area.top;
  const auto first = static_cast<int>(std::floor(nearest / kPeriod));
  const auto last = static_cast<int>((nearest + area.width + area.height) / kPeriod);
  for (int i = first; i <= last; ++i) {
    cairo_move_to(context, i * kPeriod - area.top, area.top);
    cairo_rel_line_to(context, -area.height, area.height);
  }
  set_source(context, stripes.stripe);
  cairo_set_line_width(context, kStripe);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_SQUARE);
  cairo_stroke(context);
  cairo_restore(context);
}

void draw_stripes(cairo_t* context, const CellPaints& paints, const MapView& view) {
  if (view.scale() < kLeastCell) return;
  for (const Run& run : runs_of(paints)) draw_stripes(context, area_of(run, view), run.stripes);
}

}  // namespace wend
