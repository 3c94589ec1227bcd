#include "wend/render/animation/film_canvas.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "wend/render/picture/canvas.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {

/// Where a panel lies, and its map.
struct FilmPlace {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  MapView view;
};

/// Panels in rows; all places are equally large.
struct FilmLayout {
  std::vector<FilmPlace> places;
  int width = 0;
  int height = 0;
  double scale = 0;  // the least pixels a cell
};

namespace {

// In pixels.
constexpr int kMargin = 8;  // around it all
constexpr int kGap = 20;    // between panels
constexpr int kStrip = 30;  // above a map, for its name and its counter
constexpr int kFrame = 2;   // around a map: a line on each side
constexpr double kTitleSize = 18;
constexpr double kTextGap = 12;         // between the two
constexpr int kLeastWidth = 240;        // of a map with its texts
constexpr double kCrispFrom = 3;        // pixels a cell; smaller cells may be blurred
constexpr int kMostFilmPixels = 16384;  // cairo refuses more than twice that
constexpr double kStripBaseline = 0.7 * kStrip;

FilmLayout layout_of(std::span<const FilmPanel> panels, int columns, int most_width,
                     int most_height) {
  const auto count = static_cast<int>(panels.size());
  const int rows = (count + columns - 1) / columns;
  const int room_across = (most_width - 2 * kMargin - (columns - 1) * kGap) / columns;
  const int room_down = (most_height - 2 * kMargin - (rows - 1) * kGap) / rows - kStrip;
  FilmLayout layout;
  int across = kLeastWidth;
  int down = 1;
  for (const FilmPanel& panel : panels) {
    const Margins axes = axis_room(panel.scene);
    FilmPlace& place = layout.places.emplace_back();
    place.view =
        fitted_view(panel.scene.space.map(), std::max(1, room_across - axes.across() - kFrame),
                    std::max(1, room_down - axes.down() - kFrame), kCrispFrom);
    layout.scale =
        layout.places.size() == 1 ? place.view.scale() : std::min(layout.scale, place.view.scale());
    across = std::max(across, place.view.width + axes.across() + kFrame);
    down = std::max(down, place.view.height + axes.down() + kFrame);
  }
  for (int i = 0; i < count; ++i) {
    FilmPlace& place = layout.places[static_cast<std::size_t>(i)];
    const Margins axes = axis_room(panels[static_cast<std::size_t>(i)].scene);
    place.left = kMargin + i % columns * (across + kGap);
    place.top = kMargin + i / columns * (kStrip + down + kGap);
    place.width = across;
    place.height = kStrip + down;
    const int spare = (across - place.view.width - axes.across() - kFrame) / 2;
    place.view.left = place.left + axes.left + 1 + spare;
    place.view.top = place.top + kStrip + axes.top + 1;
  }
  layout.width = 2 * kMargin + columns * (across + kGap) - kGap;
  layout.height = 2 * kMargin + rows * (kStrip + down + kGap) - kGap;
  return layout;
}

/// The one with the largest cells, and with the fewest empty places.
FilmLayout best_layout(std::span<const FilmPanel> panels, int most_width, int most_height) {
  FilmLayout best;
  for (int columns = 1; columns <= static_cast<int>(panels.size()); ++columns) {
    FilmLayout layout = layout_of(panels, columns, most_width, most_height);
    if (layout.width > most_width && columns > 1) break;
    if (layout.scale > best.scale) best = std::move(layout);
  }
  return best;
}

}  // namespace

class FilmCanvas::Sheet {
 public:
  Sheet(std::span<const FilmPanel> panels, std::vector<LegendItem> legend, int most_width,
        int most_height, const Style& style)
      : style_(style) {
    most_width = std::clamp(most_width, 1, kMostFilmPixels);
    most_height = std::clamp(most_height, 1, kMostFilmPixels);
    const bool explains = !legend.empty();
    const int before = explains ? lines_for(legend, most_width) * Footer::kLine : 0;
    layout_ = best_layout(panels, most_width, std::max(1, most_height - before));
    const Footer footer(std::move(legend), std::nullopt, layout_.width - 2 * kMargin);
    const int height = layout_.height + (explains ? footer.lines() * Footer::kLine : 0);
    image_ = new_image(CAIRO_FORMAT_RGB24, layout_.width, height);
    context_.reset(cairo_create(image_.get()));
    pixels_ = Grid<std::uint32_t>(layout_.width, height);
    set_source(context_.get(), style_.page);
    cairo_paint(context_.get());
    if (!explains) return;
    footer.draw(context_.get(), {kMargin, layout_.height + Footer::kLine / 2.0 - kMargin}, style_);
  }

  const Grid<std::uint32_t>& draw(std::span<const FilmPanel> panels) {
    assert(panels.size() == layout_.places.size());
    for (std::size_t i = 0; i < panels.size(); ++i) draw_panel(panels[i], layout_.places[i]);
    copy_pixels(image_.get(), pixels_);
    return pixels_;
  }

 private:
  static int lines_for(const std::vector<LegendItem>& legend, int width) {
    return Footer(legend, std::nullopt, width - 2 * kMargin).lines();
  }

  void draw_panel(const FilmPanel& panel, const FilmPlace& place) {
    cairo_t* const context = context_.get();
    cairo_save(context);
    // Marks at the edge of a map reach over it.
    cairo_rectangle(context, place.left - kMargin, place.top, place.width + 2 * kMargin,
                    place.height + kMargin);
    cairo_clip_preserve(context);
    fill(context, style_.page);
    select_label_font(context, kTitleSize);
    const double right = place.left + place.width - text_width(context, panel.counter);
    draw_text(context, {right, place.top + kStripBaseline}, panel.counter, style_.ink);
    const double room = right - place.left - kTextGap;
    draw_text(context, {static_cast<double>(place.left), place.top + kStripBaseline},
              shortened(context, panel.title, room), style_.ink);
    draw_scene(context, panel.scene, place.view, style_, PictureKind::png);
    cairo_restore(context);
  }

  Style style_;
  FilmLayout layout_;
  CairoSurface image_;
  CairoContext context_;
  Grid<std::uint32_t> pixels_;
};

FilmCanvas::FilmCanvas(std::span<const FilmPanel> panels, std::vector<LegendItem> legend,
                       int most_width, int most_height, const Style& style)
    : sheet_(std::make_unique<Sheet>(panels, std::move(legend), most_width, most_height, style)) {}

FilmCanvas::~FilmCanvas() = default;

const Grid<std::uint32_t>& FilmCanvas::draw(std::span<const FilmPanel> panels) {
  return sheet_->draw(panels);
}

}  // namespace wend
