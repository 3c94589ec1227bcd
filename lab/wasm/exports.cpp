// What the page calls, of both modules.

#include "lab/wasm/exchange.hpp"

namespace {

using wend::lab::CellByte;
using wend::lab::input;
using wend::lab::input_bytes;
using wend::lab::input_text;
using wend::lab::lab;
using wend::lab::output;

}  // namespace

WEND_LAB_EXPORT(input) void* lab_input(std::size_t bytes) {
  input().resize(bytes / sizeof(std::uint64_t) + 1);
  return input().data();
}
WEND_LAB_EXPORT(text) const char* lab_text() { return output().data(); }
WEND_LAB_EXPORT(text_size) std::size_t lab_text_size() { return output().size(); }

WEND_LAB_EXPORT(load)
void lab_load(int width, int height, double resolution, double origin_x, double origin_y,
              double origin_yaw, bool y_up, bool metric) {
  const wend::Frame frame{resolution, {origin_x, origin_y, origin_yaw}, y_up, metric};
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  output() = lab().load({input_bytes(), size}, width, height, frame);
}

WEND_LAB_EXPORT(generate)
void lab_generate(std::size_t text, int width, int height, double seed) {
  output() = lab().generate(input_text(0, text), width, height, static_cast<std::uint64_t>(seed));
}

WEND_LAB_EXPORT(edit) void lab_edit(std::size_t count) {
  output() = lab().edit({reinterpret_cast<const CellByte*>(input().data()), count});
}

/// The input has the footprint, then the fields.
WEND_LAB_EXPORT(robot) void lab_robot(std::size_t footprint, std::size_t fields) {
  output() = lab().set_robot(input_text(0, footprint), input_text(footprint, fields));
}

/// The input has the planner, then the smoother, then the fields.
WEND_LAB_EXPORT(plan)
void lab_plan(std::size_t planner, std::size_t smoother, std::size_t fields, double start_x,
              double start_y, double start_heading, double goal_x, double goal_y,
              double goal_heading, bool headings, bool record) {
  const std::string words(input_text(0, planner + smoother + fields));
  const std::string_view text = words;
  output() = lab().plan({.start = {start_x, start_y, start_heading},
                         .goal = {goal_x, goal_y, goal_heading},
                         .headings = headings,
                         .record = record,
                         .planner = text.substr(0, planner),
                         .fields = text.substr(planner + smoother),
                         .smoother = text.substr(planner, smoother)});
}

WEND_LAB_EXPORT(places)
void lab_places(double start_x, double start_y, double start_heading, double goal_x, double goal_y,
                double goal_heading, bool headings) {
  output() =
      lab().places({start_x, start_y, start_heading}, {goal_x, goal_y, goal_heading}, headings);
}

WEND_LAB_EXPORT(cell) void lab_cell(int x, int y) { output() = lab().cell({x, y}); }

WEND_LAB_EXPORT(show) void lab_show(std::size_t text) {
  output() = lab().show(input_text(0, text));
}

WEND_LAB_EXPORT(paint)
const std::uint32_t* lab_paint(int width, int height, double left, double top, double cells,
                               std::uint32_t step) {
  lab().paint({width, height, left, top, cells, false}, step);
  return lab().pixels().data();
}

WEND_LAB_EXPORT(palette) void* lab_palette() { return &lab().palette(); }
WEND_LAB_EXPORT(cells) const void* lab_cells() { return lab().cells().data(); }
WEND_LAB_EXPORT(cells_size) std::size_t lab_cells_size() { return lab().cells().size(); }
WEND_LAB_EXPORT(points) const void* lab_points() { return lab().points().data(); }
WEND_LAB_EXPORT(points_size) std::size_t lab_points_size() { return lab().points().size(); }
WEND_LAB_EXPORT(steps) std::uint32_t lab_steps() { return lab().replay().steps(); }
WEND_LAB_EXPORT(expanded_at) std::uint32_t lab_expanded_at(std::uint32_t step) {
  return lab().replay().expanded_at(step);
}
WEND_LAB_EXPORT(expansion) const void* lab_expansion() { return lab().replay().expansion().data(); }
WEND_LAB_EXPORT(generation) const void* lab_generation() {
  return lab().replay().generation().data();
}
/// g, h and f of each cell.
WEND_LAB_EXPORT(known) const void* lab_known() { return lab().replay().known().data(); }
WEND_LAB_EXPORT(parents) const void* lab_parents() { return lab().replay().parent().data(); }
