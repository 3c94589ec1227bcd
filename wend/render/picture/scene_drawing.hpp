#pragma once

// How a scene is drawn on a cairo context, one layer over the other. draw_scene() has their order;
// the functions of each group below are in the source file that the group names.

#include <optional>
#include <span>

#include "wend/render/legend.hpp"
#include "wend/render/picture/canvas.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// In pixels, so that marks stay visible however small the cells are.
struct MarkSizes {
  double line = 3;    // width of the path
  double halo = 1.5;  // width of the rim around path and marks; 0 where a pixel is half a character
  double mark = 8;    // radius of start and goal; half the side of squares
};

/// What marks and lines are drawn with.
struct Pen {
  cairo_t* context;
  MarkSizes sizes;
  const Style& style;
};

/// What is drawn, and where.
struct SceneDrawing : Pen {
  const Scene& scene;
  const MapView& view;
};

/// All of it. PNGs get the map as an image, vector formats as rectangles while they are few.
void draw_scene(cairo_t* context, const Scene& scene, const MapView& view, const Style& style,
                PictureKind kind);

// map_drawing.cpp: the map, and what tells where on it one is.

void draw_map(const SceneDrawing& drawing, PictureKind kind);

/// The map as a dominant_image().
void draw_dominant_map(const SceneDrawing& drawing);

/// Over the cells that need them. None where cells are too small to see a stripe.
void draw_stripes(const SceneDrawing& drawing);

/// Grid lines between all cells, or of a car's lattice, if there is room; and a frame around the
/// map.
void draw_grid_lines(const SceneDrawing& drawing);

/// The numbers of a lattice's corners at the sides of the map, in the room that axis_room() asks
/// for, where its places are corners: columns along row 0 (so above the map where y is down, below it
/// where y is up), rows at the left. Every corner has its number where there is room, else every
/// second, fifth, tenth and so on.
void draw_axes(const SceneDrawing& drawing);

/// In pixels.
struct PictureArea {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

void trace_area(cairo_t* context, const PictureArea& area);

/// Fills an area with diagonal stripes in the colour of rough ground over that of a role, so that
/// both are seen; stripes of areas beside each other meet.
void draw_stripes(cairo_t* context, const PictureArea& area, const Stripes& stripes);

// cell_layers.cpp: what is known of every cell.

/// Are the cells large enough for the numbers of the scene's heatmap, if it has one?
bool shows_cell_numbers(const SceneDrawing& drawing);

/// The heatmap's values. None where the longest number does not fit into a cell. Cells without a
/// finite value, and obstacles, stay empty. With arrows or a path of cells the numbers lie below the
/// middle of the cell.
void draw_cell_numbers(const SceneDrawing& drawing);

/// Which way to move. Where cells are too small for an arrow each, blocks of cells share that of
/// their middle cell. Raised ones leave room for a number below them.
void draw_arrows(const SceneDrawing& drawing, bool raised);

/// An arrow `length` pixels long.
void draw_arrow(cairo_t* context, Point centre, double length, Direction direction,
                const Colour& colour);

/// The sparse_cells() as dots with a rim in their roles' colours; without a halo, a pixel each.
void draw_sparse_cells(const SceneDrawing& drawing);

// path_drawing.cpp: the path, lines, and the robot to scale.

/// The path, the lines exactly through their points, and the robot: where it is, or at the start.
///
/// A car's path is drawn as its arcs, solid forwards and dashed in reverse, with small arrows along
/// the headings of poses that are far enough apart. Planned and possible lines are dashed, smoothed
/// ones wide, driven ones thin, so that each stays visible where they overlap.
void draw_path(const SceneDrawing& drawing);

/// Traces the way of the base point between poses.
void trace_drive(cairo_t* context, std::span<const Pose> poses, const MapView& view);

/// Horizontal pieces that long, as legends show them.
void draw_driven_sample(const Pen& pen, Point centre, double length, bool reverse);
void draw_line_sample(const Pen& pen, Point centre, double length, LineRole role);

// motions_drawing.cpp: what a search over poses drove.

/// The scene's motions as thin lines in the colours of its heatmap; later ones over earlier ones.
void draw_motions(const SceneDrawing& drawing);

// footprint_drawing.cpp: a robot whose shape is a polygon, to scale.

/// Traces the outline of the robot at a pose.
void trace_footprint(const SceneDrawing& drawing, const Pose& pose);

/// At both ends of the path and along it, facing along it, far enough apart. None where outlines
/// would be only specks, or without a path.
void draw_footprints(const SceneDrawing& drawing);

// marks.cpp: start, goals, and what a scene points out.

/// Sizes for a picture of that scale: by the cells, or by a car's lattice, whose corners need room.
MarkSizes mark_sizes(const Scene& scene, const MapView& view);

/// The same where a pixel is half a character: marks are squares, which hide one cell at most, or one pixel where
/// many cells share it.
MarkSizes block_mark_sizes(const MapView& view);

/// How far the mark of the narrowest place reaches, in radii of the other marks.
inline constexpr double kNarrowestReach = 2.3;

/// The mark that the legend has under that name: start, goal, narrowest (a ring with four ticks),
/// nearest_free (a diamond) or collision (a cross). `angle` is clockwise from the right: a start or a
/// goal has a tip that points there.
void draw_mark(const Pen& pen, Swatch mark, Point centre, std::optional<double> angle = {});

/// Edges included.
inline bool on_map(const Scene& scene, Point point) {
  return point.x >= 0 && point.y >= 0 && point.x <= scene.space.width() &&
         point.y <= scene.space.height();
}

/// All marks of the scene that lie on the map.
void draw_marks(const SceneDrawing& drawing);

/// Strokes what is traced, with a halo on both sides.
void stroke_with_halo(const Pen& pen, double width, const Colour& colour);

/// Fills what is traced, with a halo around it.
void fill_with_halo(const Pen& pen, const Colour& colour);

// footer.cpp: a scale bar on the left, and on the right the legend, on as many lines as it needs.

class Footer {
 public:
  static constexpr int kLine = 34;  // pixels from one line to the next

  /// For that many pixels of width. The scale bar is left out where it has none.
  Footer(std::vector<LegendItem> legend, std::optional<ScaleBar> bar, double width);

  /// At least one.
  int lines() const { return static_cast<int>(rows_.size()); }

  /// `left` is the left end of the middle of the first line.
  void draw(cairo_t* context, Point left, const Style& style) const;

 private:
  /// Distributes the legend over rows.
  void arrange(cairo_t* context, std::vector<LegendItem> legend);

  std::optional<ScaleBar> bar_;
  std::vector<std::vector<LegendItem>> rows_;
  double width_;
};

}  // namespace wend
