#include "wend/render/picture/panel_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wend/render/picture/picture_layout.hpp"

namespace wend {
namespace {

constexpr int kWidest = 2000;  // the whole picture
constexpr int kLargestMap = 800;
constexpr int kNarrowestPanel = 300;
constexpr int kNarrowestPicture = 600;  // the legend needs room
constexpr double kPleasant = 1.5;       // width to height
constexpr double kEmptyPlace = 1;       // as bad as proportions that are wrong by that much

int rows_of(std::size_t panels, int columns) {
  return (static_cast<int>(panels) + columns - 1) / columns;
}

}  // namespace

PanelLayout panel_layout(std::span<const Panel> panels, double below, int columns) {
  const int room = kWidest - 2 * PanelLayout::kMargin - (columns - 1) * PanelLayout::kGap;
  const int most = std::clamp(room / columns, 1, kLargestMap);
  PanelLayout layout;
  double width = std::min(kNarrowestPanel, most);
  double height = 0;
  for (const Panel& panel : panels) {
    PanelPlace place;
    place.axes = axis_room(panel.scene);
    place.view = fitted_view(panel.scene.space.map(), std::max(1, most - place.axes.across()),
                             kLargestMap, 1);
    width = std::max<double>(width, place.view.width + place.axes.across());
    height = std::max<double>(height, place.view.height + place.axes.down());
    layout.places.push_back(place);
  }
  const double whole = PanelLayout::kTitle + height + below;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto column = static_cast<int>(i) % columns;
    const auto row = static_cast<int>(i) / columns;
    PanelPlace& place = layout.places[i];
    place.left = PanelLayout::kMargin + column * (width + PanelLayout::kGap);
    place.top = PanelLayout::kMargin + row * (whole + PanelLayout::kGap);
    place.width = width;
    place.height = whole;
    const double across = place.view.width + place.axes.across();
    place.view.left = place.left + std::floor((width - across) / 2) + place.axes.left;
    place.view.top = place.top + PanelLayout::kTitle + place.axes.top;
  }
  const int rows = rows_of(panels.size(), columns);
  const double across = 2 * PanelLayout::kMargin + columns * (width + PanelLayout::kGap);
  const double down = 2 * PanelLayout::kMargin + rows * (whole + PanelLayout::kGap);
  layout.width = std::max(kNarrowestPicture, static_cast<int>(across) - PanelLayout::kGap);
  layout.height = static_cast<int>(std::ceil(down)) - PanelLayout::kGap;
  return layout;
}

PanelLayout panel_layout(std::span<const Panel> panels, double below) {
  PanelLayout best;
  double least = std::numeric_limits<double>::infinity();
  for (int columns = 1; columns <= static_cast<int>(panels.size()); ++columns) {
    PanelLayout layout = panel_layout(panels, below, columns);
    const double proportion = static_cast<double>(layout.width) / layout.height;
    const double empty =
        rows_of(panels.size(), columns) * columns - static_cast<double>(panels.size());
    const double badness = std::abs(std::log(proportion / kPleasant)) + kEmptyPlace * empty;
    if (badness >= least) continue;
    least = badness;
    best = std::move(layout);
  }
  return best;
}

}  // namespace wend
