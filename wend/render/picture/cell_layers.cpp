// What is known of every cell, drawn over it: numbers, arrows, dots.

#include <algorithm>
#include <cmath>

#include "wend/render/heatmap.hpp"
#include "wend/render/picture/drawn_cells.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

// Numbers.
constexpr double kFrom = 30;            // pixels a cell
constexpr double kShareOfWidth = 0.86;  // of a cell, for the longest number
constexpr double kShareOfHeight = 0.8;  // of a cell, for several lines
constexpr double kLines = 0.92;  // of a cell, from the top of the first to the bottom of the last
constexpr double kSmallest = 9;  // font sizes
constexpr double kLargest = 22;

// Arrows.
constexpr double kLeastSpacing = 15;  // pixels from arrow to arrow
constexpr double kLongest = 34;       // pixels
constexpr double kShareOfSpacing = 0.62;
constexpr double kShareIfRaised = 0.42;
constexpr double kRise = 0.16;  // of a cell

// Dots.
constexpr double kDot = 9;           // pixels across
constexpr double kRim = 1.25;        // pixels
constexpr double kMostShare = 0.05;  // of the picture that dots may cover

/// From the top of a cell; the last ones are the heatmap's, if there is one.
std::vector<const Grid<double>*> numbers_of(const Scene& scene) {
  std::vector<const Grid<double>*> numbers;
  if (!scene.heatmap) return numbers;
  for (const Grid<double>& above : scene.numbers_above) numbers.push_back(&above);
  numbers.push_back(&scene.heatmap->values);
  return numbers;
}

std::vector<NumberText> texts_of(const std::vector<const Grid<double>*>& numbers) {
  std::vector<NumberText> texts;
  texts.reserve(numbers.size());
  for (const Grid<double>* values : numbers) texts.emplace_back(*values);
  return texts;
}

/// The largest size in which these lines fit into a cell; nothing if it is not readable.
std::optional<double> font_size(cairo_t* context, const std::vector<NumberText>& texts,
                                double scale) {
  int columns = 0;
  for (const NumberText& text : texts) columns = std::max(columns, text.columns());
  if (scale < kFrom || columns == 0) return std::nullopt;
  select_label_font(context, kLargest);
  const std::string longest(static_cast<std::size_t>(columns), '8');
  const double fitting = kLargest * kShareOfWidth * scale / text_width(context, longest);
  const double high = texts.size() > 1 ? kShareOfHeight / static_cast<double>(texts.size()) : 0.32;
  const double size = std::min({fitting, kLargest, high * scale});
  if (size < kSmallest) return std::nullopt;
  return size;
}

/// So that the path does not run through digits.
void draw_number_rim(cairo_t* context, Point baseline, const std::string& number,
                     const Colour& colour) {
  cairo_move_to(context, baseline.x, baseline.y);
  cairo_text_path(context, number.c_str());
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  stroke(context, 5, colour);
}

void trace_arrow(cairo_t* context, Point centre, double length, Direction direction) {
  const Cell drawn = step({}, direction);
  const double norm = std::hypot(drawn.x, drawn.y);
  const Point along{drawn.x / norm, drawn.y / norm};
  const Point tip{centre.x + along.x * length / 2, centre.y + along.y * length / 2};
  const double head = 0.36 * length;
  trace_line(context, {tip.x - along.x * length, tip.y - along.y * length}, tip);
  for (const double side : {-1.0, 1.0}) {
    trace_line(context,
               {tip.x - head * (along.x + side * 0.8 * along.y),
                tip.y - head * (along.y - side * 0.8 * along.x)},
               tip);
  }
}

void stroke_arrows(cairo_t* context, double length, const Colour& colour) {
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  stroke(context, std::clamp(0.1 * length, 1.2, 3.0), colour);
}

bool is_alone(const BitGrid& cells, Cell cell) {
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      const Cell other{x, y};
      if (other != cell && cells.contains(other) && cells[other]) return false;
    }
  }
  return true;
}

}  // namespace

bool shows_cell_numbers(const SceneDrawing& drawing) {
  const auto texts = texts_of(numbers_of(drawing.scene));
  return font_size(drawing.context, texts, drawing.view.scale()).has_value();
}

void draw_cell_numbers(const SceneDrawing& drawing) {
  const Scene& scene = drawing.scene;
  const double scale = drawing.view.scale();
  cairo_t* const context = drawing.context;
  const auto numbers = numbers_of(scene);
  const auto texts = texts_of(numbers);
  const auto size = font_size(context, texts, scale);
  if (!size) return;
  select_label_font(context, *size);
  const CellPaints paints(scene, drawing.style);
  const auto lines = static_cast<double>(numbers.size());
  const bool aside = !scene.path.cells().empty() || scene.arrows;
  const double last = lines > 1 ? (0.5 - 0.5 / lines) * kLines * scale + 0.35 * *size
                      : aside   ? 0.44 * scale
                                : 0.35 * *size;
  for (const Cell cell : every_cell(*numbers.back())) {
    if (!paints.heat(cell)) continue;
    const Colour under = paints[cell].colour;
    const Point centre = drawing.view.to_picture(centre_of(cell));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!std::isfinite((*numbers[i])[cell])) continue;
      const std::string number = texts[i]((*numbers[i])[cell]);
      const double up = (lines - 1 - static_cast<double>(i)) * kLines * scale / lines;
      const Point baseline{centre.x - text_width(context, number) / 2, centre.y + last - up};
      if (!scene.path.empty()) draw_number_rim(context, baseline, number, under);
      draw_text(context, baseline, number, readable_on(under));
    }
  }
}

void draw_arrow(cairo_t* context, Point centre, double length, Direction direction,
                const Colour& colour) {
  cairo_new_path(context);
  trace_arrow(context, centre, length, direction);
  stroke_arrows(context, length, colour);
}

void draw_arrows(const SceneDrawing& drawing, bool raised) {
  if (!drawing.scene.arrows) return;
  const ArrowField& arrows = *drawing.scene.arrows;
  const double scale = drawing.view.scale();
  const int block = std::max(1, static_cast<int>(std::ceil(kLeastSpacing / scale)));
  const double share = raised ? kShareIfRaised : kShareOfSpacing;
  const double length = std::min(kLongest, share * block * scale);
  const double rise = raised ? kRise * scale : 0;
  cairo_new_path(drawing.context);
  for (int y = block / 2; y < arrows.height(); y += block) {
    for (int x = block / 2; x < arrows.width(); x += block) {
      const auto direction = arrows[{x, y}];
      if (!direction) continue;
      const Point centre = drawing.view.to_picture(centre_of(Cell{x, y}));
      trace_arrow(drawing.context, {centre.x, centre.y - rise}, length,
                  row_order(drawing.scene.space).direction(*direction));
    }
  }
  stroke_arrows(drawing.context, length, drawing.style.arrows);
}

std::vector<Cell> sparse_cells(const MarkedCells& marked, double pixels_a_cell, double dot) {
  const BitGrid& cells = marked.cells;
  std::vector<Cell> sparse;
  if (marked.role != CellRole::expanded || pixels_a_cell >= dot) return sparse;
  for (const Cell cell : every_cell(cells)) {
    if (cells[cell] && is_alone(cells, cell)) sparse.push_back(cell);
  }
  const double pixels =
      static_cast<double>(cells.width()) * cells.height() * pixels_a_cell * pixels_a_cell;
  const double covered = static_cast<double>(sparse.size()) * dot * dot;
  if (covered > kMostShare * pixels) sparse.clear();
  return sparse;
}

void draw_sparse_cells(const SceneDrawing& drawing) {
  const bool dots = drawing.sizes.halo > 0;
  for (const MarkedCells& marked : drawing.scene.marked) {
    const Colour colour = drawing.style.of(marked.role);
    for (const Cell cell : sparse_cells(marked, drawing.view.scale(), dots ? kDot : 1)) {
      if (drawing.scene.space.map().state(cell) == CellState::occupied) continue;
      const Point centre = drawing.view.to_picture(centre_of(cell));
      if (dots) {
        trace_circle(drawing.context, centre, kDot / 2);
        fill_and_keep(drawing.context, colour);
        stroke(drawing.context, kRim, drawing.style.ink);
      } else {
        cairo_rectangle(drawing.context, std::floor(centre.x), std::floor(centre.y), 1, 1);
        fill(drawing.context, colour);
      }
    }
  }
}

}  // namespace wend
