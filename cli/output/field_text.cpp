#include "cli/output/field_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "cli/output/picture.hpp"
#include "cli/output/plan_text.hpp"
#include "cli/output/terminal.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend::cli {
namespace {

constexpr int kColumnsAnArrow = 2;

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

std::string grids(const CostToGo& field, const Scene& scene, const Screen& screen) {
  const int columns_a_cost = columns_a_number(field.costs());
  const auto fits = [&](int columns_a_cell) {
    return scene.space.width() * columns_a_cell <= screen.columns;
  };
  // Colours are of whole rows.
  const TerminalColours colours =
      fits(columns_a_cost) ? screen.terminal.colours : TerminalColours::none;
  std::string text = "cost to the goal\n" +
                     folded_grid(text_numbers(scene, colours), columns_a_cost, screen.columns) +
                     "\nwhich way to move\n";
  const bool coloured = screen.terminal.colours != TerminalColours::none;
  text += fits(kColumnsAnArrow) ? text_arrows(scene, screen.terminal.colours)
                                : text_picture(scene, {.colours = coloured});
  return text + "\n";
}

/// The cells of a path, as path_line() has them, on as many lines as it takes.
std::string path_lines(const Path& path, int columns) {
  constexpr std::string_view kIndent = "  ";
  std::string text;
  std::string line(kIndent);
  for (std::size_t i = 0; i < path.cells().size(); ++i) {
    const bool last = i + 1 == path.cells().size();
    const std::string cell = cell_text(path.cells()[i]) + (last ? "" : ">");
    const bool full = line.size() + cell.size() > static_cast<std::size_t>(columns);
    if (full && line.size() > kIndent.size()) {
      text += line + "\n";
      line = kIndent;
    }
    line += cell;
  }
  return text + line + "\n";
}

std::string start_text(const FieldStart& start, bool small, int columns) {
  const PlanResult& result = start.result;
  if (result.status != Status::found) return {};
  const std::string text = fmt::format("from {}: cost {:.6g}, {} steps\n", cell_text(start.start),
                                       result.plan.cost, result.plan.path.size() - 1);
  return small ? text + path_lines(result.plan.path, columns) : text;
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
  for (const FieldStart& start : report.starts) text += start_text(start, small, screen.columns);
  return text + reach_text(field, space) + work_line(report.metrics);
}

}  // namespace wend::cli
