#include "wend/render/picture/picture_layout.hpp"

#include <algorithm>
#include <cmath>

#include "wend/render/picture/footer.hpp"

namespace wend {
namespace {

// The longer side of the map itself. Twice the least is the most, so that some whole number fits.
constexpr int kMost = 1600 - 2 * PictureLayout::kMargin - PictureLayout::kFooter;
constexpr int kLeast = 800 - 2 * PictureLayout::kMargin;
static_assert(kMost == 2 * kLeast);

constexpr int kLeastWidth = 480;  // of the whole picture: the footer needs room

double scale_of(int longer_side) {
  if (longer_side > kMost) return static_cast<double>(kMost) / longer_side;
  return std::round((kMost + kLeast) / 2.0 / longer_side);
}

int scaled(int cells, double scale) {
  return std::max(1, static_cast<int>(std::lround(cells * scale)));
}

}  // namespace

MapView fitted_view(const GridMap& map, int most_width, int most_height, double crisp_from) {
  double scale = std::min(static_cast<double>(most_width) / map.width(),
                          static_cast<double>(most_height) / map.height());
  if (scale >= crisp_from) scale = std::floor(scale);
  const auto scaled = [scale](int cells, int most) {
    return std::clamp(static_cast<int>(std::lround(cells * scale)), 1, most);
  };
  return {.left = 0,
          .top = 0,
          .width = scaled(map.width(), most_width),
          .height = scaled(map.height(), most_height),
          .columns = map.width(),
          .rows = map.height(),
          .y_up = map.frame().y_up};
}

Point PictureLayout::footer() const {
  return {kMargin, view.top + view.height + axes.bottom + (kMargin + kFooter) / 2.0};
}

void PictureLayout::add_footer_lines(int lines) { height += lines * Footer::kLine; }

PictureLayout picture_layout(const GridMap& map, const AxisRoom& axes) {
  const double scale = scale_of(std::max(map.width(), map.height()));
  PictureLayout layout;
  layout.axes = axes;
  MapView& view = layout.view;
  view.width = scaled(map.width(), scale);
  view.height = scaled(map.height(), scale);
  view.columns = map.width();
  view.rows = map.height();
  view.y_up = map.frame().y_up;

  const int across = view.width + axes.across();
  layout.width = std::max(kLeastWidth, across + 2 * PictureLayout::kMargin);
  layout.height = view.height + axes.down() + 2 * PictureLayout::kMargin + PictureLayout::kFooter;
  view.left = std::floor((layout.width - across) / 2.0) + axes.left;  // so that cells are crisp
  view.top = PictureLayout::kMargin + axes.top;
  return layout;
}

}  // namespace wend
