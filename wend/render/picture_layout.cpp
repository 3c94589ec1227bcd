#include "wend/render/picture_layout.hpp"

#include <algorithm>
#include <cmath>

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

PictureLayout picture_layout(const GridMap& map) {
  const double scale = scale_of(std::max(map.width(), map.height()));
  PictureLayout layout;
  MapView& view = layout.view;
  view.width = scaled(map.width(), scale);
  view.height = scaled(map.height(), scale);
  view.columns = map.width();
  view.rows = map.height();
  view.y_up = map.frame().y_up;

  layout.width = std::max(kLeastWidth, view.width + 2 * PictureLayout::kMargin);
  layout.height = view.height + 2 * PictureLayout::kMargin + PictureLayout::kFooter;
  view.left = std::floor((layout.width - view.width) / 2.0);  // so that cells are crisp
  view.top = PictureLayout::kMargin;
  return layout;
}

}  // namespace wend
