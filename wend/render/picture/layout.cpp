#include "wend/render/picture/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace wend {
namespace {

// The longer side of the map itself. Twice the least is the most, so that some whole number fits.
constexpr int kMost = 1600 - 2 * PictureLayout::kMargin - PictureLayout::kFooter;
constexpr int kLeast = 800 - 2 * PictureLayout::kMargin;
static_assert(kMost == 2 * kLeast);

constexpr int kLeastWidth = 480;  // of the whole picture: the footer needs room

// Of pictures with panels.
constexpr int kWidest = 2000;  // the whole picture
constexpr int kLargestMap = 800;
constexpr int kLargestAlone = 1200;
constexpr double kCrispFrom = 3;  // pixels a cell; smaller cells may be blurred
constexpr int kNarrowestPanel = 300;
constexpr int kNarrowestPicture = 600;  // the legend needs room
constexpr double kPleasant = 1.5;       // width to height
// As bad as proportions that are wrong by that much:
constexpr double kAllEmpty = 5;     // a picture of empty places; of some, their share
constexpr double kSmallness = 0.5;  // maps that are smaller by a factor of e

int rows_of(std::size_t panels, int columns) {
  return (static_cast<int>(panels) + columns - 1) / columns;
}

// Of axes.
constexpr double kDigit = 0.65 * kAxisFontSize;  // as wide as one gets
constexpr double kApart = 24;                    // pixels between numbers
constexpr int kEdge = 10;  // where there are no numbers: for a path along the edge

/// Of the longest number, in pixels.
double longest_number(const FreeSpace& space) {
  const std::string number = std::to_string(std::max(space.width(), space.height()));
  return kDigit * static_cast<double>(number.size());
}

// Lengths that differ by less are one: powers of ten are not exact.
constexpr double kBarRounding = 1e-9;

double round_length(double longest) {
  const double power = std::pow(10, std::floor(std::log10(longest * (1 + kBarRounding))));
  for (const double factor : {5, 2}) {
    if (power * factor <= longest * (1 + kBarRounding)) return power * factor;
  }
  return power;
}

MapView view_of(const GridMap& map, int width, int height) {
  return {.width = width,
          .height = height,
          .columns = map.width(),
          .rows = map.height(),
          .y_up = map.frame().y_up};
}

}  // namespace

MapView fitted_view(const GridMap& map, int most_width, int most_height, double crisp_from) {
  double scale = std::min(static_cast<double>(most_width) / map.width(),
                          static_cast<double>(most_height) / map.height());
  if (scale >= crisp_from) scale = std::floor(scale);
  const auto scaled = [scale](int cells, int most) {
    return std::clamp(static_cast<int>(std::lround(cells * scale)), 1, most);
  };
  return view_of(map, scaled(map.width(), most_width), scaled(map.height(), most_height));
}

Margins axis_room(const Scene& scene) {
  if (!scene.places.on_corners()) return {};
  const auto beside =
      static_cast<int>(std::ceil(kAxisTick + kAxisGap + longest_number(scene.space)));
  const auto along = static_cast<int>(std::ceil(kAxisTick + kAxisGap + kAxisDigitHeight));
  const bool y_up = scene.space.map().frame().y_up;
  return {
      .left = beside, .top = y_up ? kEdge : along, .right = kEdge, .bottom = y_up ? along : kEdge};
}

int axis_step(const Scene& scene, double scale) {
  const int unit = scene.places.spacing;
  return unit * round_step((kApart + longest_number(scene.space)) / (unit * scale));
}

int round_step(double least) {
  constexpr int kMostStep = 1'000'000'000;
  for (int power = 1; power < kMostStep; power *= 10) {
    for (const int factor : {1, 2, 5}) {
      if (factor * power >= least) return factor * power;
    }
  }
  return kMostStep;
}

ScaleBar scale_bar(const Frame& frame, double pixels_a_cell, double most) {
  if (frame.metric) {
    const double pixels_a_metre = pixels_a_cell / frame.resolution;
    const double metres = round_length(most / pixels_a_metre);
    return {metres * pixels_a_metre, fmt::format("{:g} m", metres)};
  }
  const double cells = std::max(1.0, round_length(most / pixels_a_cell));
  return {cells * pixels_a_cell, fmt::format("{:g} {}", cells, cells == 1 ? "cell" : "cells")};
}

PictureLayout picture_layout(const GridMap& map, const Margins& axes) {
  const int longer = std::max(map.width(), map.height());
  const double scale = longer > kMost ? static_cast<double>(kMost) / longer
                                      : std::round((kMost + kLeast) / 2.0 / longer);
  const auto scaled = [scale](int cells) {
    return std::max(1, static_cast<int>(std::lround(cells * scale)));
  };
  PictureLayout layout;
  layout.axes = axes;
  MapView& view = layout.view;
  view = view_of(map, scaled(map.width()), scaled(map.height()));
  const int across = view.width + axes.across();
  layout.width = std::max(kLeastWidth, across + 2 * PictureLayout::kMargin);
  layout.height = view.height + axes.down() + 2 * PictureLayout::kMargin + PictureLayout::kFooter;
  view.left = std::floor((layout.width - across) / 2.0) + axes.left;  // so that cells are crisp
  view.top = PictureLayout::kMargin + axes.top;
  return layout;
}

PanelLayout panel_layout(std::span<const Panel> panels, double below, int columns) {
  const int room = kWidest - 2 * PanelLayout::kMargin - (columns - 1) * PanelLayout::kGap;
  const bool alone = panels.size() == 1 && panels[0].caption.empty();
  const int largest = alone ? kLargestAlone : kLargestMap;
  const int most = std::clamp(room / columns, 1, largest);
  PanelLayout layout;
  double width = std::min(kNarrowestPanel, most);
  double height = 0;
  for (const Panel& panel : panels) {
    PanelPlace place;
    place.axes = axis_room(panel.scene);
    place.view = fitted_view(panel.scene.space.map(), std::max(1, most - place.axes.across()),
                             largest, kCrispFrom);
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
    const double badness = std::abs(std::log(proportion / kPleasant)) +
                           kAllEmpty * empty / static_cast<double>(panels.size()) -
                           kSmallness * std::log(layout.places.front().view.scale());
    if (badness >= least) continue;
    least = badness;
    best = std::move(layout);
  }
  return best;
}

}  // namespace wend
