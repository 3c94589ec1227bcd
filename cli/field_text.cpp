#include "field_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "picture.hpp"
#include "plan_text.hpp"
#include "wend/render/text_layers.hpp"
#include "wend/render/text_picture.hpp"

namespace wend::cli {
namespace {

/// Costs as heat, the policy as arrows.
Scene scene_of(const CostToGo& field, const FreeSpace& space, const FieldReport& report) {
  Scene scene{.space = space};
  for (const Cell goal : report.goals) scene.goals.emplace_back(centre_of(goal));
  scene.heatmap = {"cost to the goal", field.costs()};
  ArrowField arrows(space.width(), space.height());
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) arrows[{x, y}] = field.policy({x, y});
  }
  scene.arrows = std::move(arrows);
  return scene;
}

/// Does a grid of cells so many columns wide fit on the screen?
bool fits(const FreeSpace& space, int columns_a_cell, const Screen& screen) {
  return space.width() * columns_a_cell <= std::max(screen.columns, 80);
}

std::string grids(const CostToGo& field, const Scene& scene, const Screen& screen) {
  const TerminalColours colours = screen.terminal.colours;
  std::string text;
  if (fits(scene.space, columns_a_number(field.costs()), screen)) {
    text += "cost to the goal\n" + text_numbers(scene, colours) + "\n";
  }
  text += "which way to move\n";
  const bool wide = fits(scene.space, 2, screen);
  text += wide ? text_arrows(scene, colours)
               : text_picture(scene, {.colours = colours != TerminalColours::none});
  return text + "\n";
}

std::string start_text(const FieldStart& start, bool small) {
  const PlanResult& result = start.result;
  if (result.status != Status::found) return {};
  const std::string text = fmt::format("from {}: cost {:.6g}, {} steps\n", cell_text(start.start),
                                       result.plan.cost, result.plan.path.size() - 1);
  return small ? text + "  " + path_line(result.plan.path) : text;
}

std::string reach_text(const CostToGo& field, const FreeSpace& space) {
  std::size_t reached = 0;
  double farthest = 0;
  for (const double cost : field.costs().values()) {
    if (!std::isfinite(cost)) continue;
    ++reached;
    farthest = std::max(farthest, cost);
  }
  return fmt::format("reached   {} of {} passable cells, the farthest at cost {:.6g}\n", reached,
                     space.passable().count(), farthest);
}

}  // namespace

std::string field_text(const CostToGo& field, const FreeSpace& space, const FieldReport& report,
                       const Screen& screen) {
  std::string text;
  const bool small = is_small(space.map(), screen);
  if (small) text += grids(field, scene_of(field, space, report), screen);
  for (const FieldStart& start : report.starts) text += start_text(start, small);
  return text + reach_text(field, space) + work_lines(report.metrics, report.times);
}

}  // namespace wend::cli
