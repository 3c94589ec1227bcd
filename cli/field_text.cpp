#include "field_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "picture.hpp"
#include "plan_text.hpp"

namespace wend::cli {
namespace {

constexpr std::array<std::string_view, kDirections> kArrows{"↓", "↘", "→", "↗", "↑", "↖", "←", "↙"};

/// What stands for a cell that has no cost.
std::string_view mark_of(const FreeSpace& space, Cell cell) {
  switch (space.why_blocked(cell).value_or(BlockReason::outside)) {
    case BlockReason::obstacle:
      return "#";
    case BlockReason::unknown:
      return "?";
    case BlockReason::too_close:
      return ":";
    case BlockReason::outside:
      break;
  }
  return "-";  // free, but no path leads to the goal
}

/// The rows of a map as it is drawn.
std::vector<int> drawn_rows(const GridMap& map) {
  std::vector<int> rows(static_cast<std::size_t>(map.height()));
  std::iota(rows.begin(), rows.end(), 0);
  if (map.frame().y_up) std::reverse(rows.begin(), rows.end());
  return rows;
}

std::string cost_of(const CostToGo& field, const FreeSpace& space, Cell cell) {
  const double cost = field.cost(cell);
  if (!std::isfinite(cost)) return std::string(mark_of(space, cell));
  return fmt::format("{:.1f}", cost);
}

std::string cost_grid(const CostToGo& field, const FreeSpace& space) {
  std::size_t width = 1;
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      width = std::max(width, cost_of(field, space, {x, y}).size());
    }
  }
  std::string text;
  for (const int y : drawn_rows(space.map())) {
    for (int x = 0; x < space.width(); ++x) {
      text += fmt::format("{}{:>{}}", x > 0 ? " " : "", cost_of(field, space, {x, y}), width);
    }
    text += "\n";
  }
  return text;
}

std::string policy_grid(const CostToGo& field, const FreeSpace& space) {
  std::string text;
  for (const int y : drawn_rows(space.map())) {
    for (int x = 0; x < space.width(); ++x) {
      const Cell cell{x, y};
      const auto move = field.policy(cell);
      const bool goal = field.cost(cell) == 0;
      text += move ? kArrows[static_cast<std::size_t>(*move)] : goal ? "G" : mark_of(space, cell);
    }
    text += "\n";
  }
  return text;
}

bool fits(const std::string& grid, const Screen& screen) {
  const std::size_t line = grid.find('\n');
  return line <= static_cast<std::size_t>(std::max(screen.columns, 80));
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
  if (small) {
    const std::string costs = cost_grid(field, space);
    if (fits(costs, screen)) text += "cost to the goal\n" + costs + "\n";
    text += "which way to move\n" + policy_grid(field, space) + "\n";
  }
  for (const FieldStart& start : report.starts) text += start_text(start, small);
  return text + reach_text(field, space) + work_lines(report.metrics, report.seconds);
}

}  // namespace wend::cli
