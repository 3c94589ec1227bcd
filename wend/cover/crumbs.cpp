#include "wend/cover/crumbs.hpp"

#include <algorithm>
#include <optional>

#include "wend/cover/area_parts.hpp"

namespace wend {
namespace {

std::size_t gain_at(const CoverageArea& area, Point place) {
  std::size_t gain = 0;
  area.visit_left(place, place, [&](Cell) { ++gain; });
  return gain;
}

/// The place from which the tool covers this cell and as many others as possible; of such places, the nearest one.
/// For a wide tool, of every so many places.
std::optional<Point> best_place(const CoverageArea& area, Cell cell, int every) {
  std::optional<Point> best;
  std::size_t most = 0;
  double nearest = 0;
  const Point centre = centre_of(cell);
  const BitGrid& places = area.reachable();
  visit_cells_near({centre, centre}, area.reach(), places.width(), places.height(), [&](Cell at) {
    if (!places[at] || at.x % every != 0 || at.y % every != 0) return;
    const std::size_t gain = gain_at(area, centre_of(at));
    const double away = distance(centre, centre_of(at));
    if (gain < most || (gain == most && best && away >= nearest)) return;
    most = gain;
    nearest = away;
    best = centre_of(at);
  });
  return best;
}

/// The nearest place from which the tool covers this cell.
std::optional<Point> nearest_place(const CoverageArea& area, Cell cell) {
  std::optional<Point> best;
  const Point centre = centre_of(cell);
  const BitGrid& places = area.reachable();
  visit_cells_near({centre, centre}, area.reach(), places.width(), places.height(), [&](Cell at) {
    const Point place = centre_of(at);
    if (places[at] && (!best || distance(centre, place) < distance(centre, *best))) best = place;
  });
  return best;
}

/// Strokes through the cells of a part that are left.
std::vector<Stroke> strokes_over(CoverageArea& area, const std::vector<Cell>& part) {
  const int every = std::max(1, static_cast<int>(area.reach() / 4));
  std::vector<Stroke> strokes;
  for (const Cell cell : part) {
    if (!area.left()[cell]) continue;
    auto place = best_place(area, cell, every);
    if (!place) place = nearest_place(area, cell);
    if (!place) continue;
    const bool joins = !strokes.empty() &&
                       distance(strokes.back().back(), *place) < 2 * area.tool_width() &&
                       area.free_along(strokes.back().back(), *place);
    if (joins) {
      area.cover(std::vector{strokes.back().back(), *place});
      strokes.back().push_back(*place);
    } else {
      area.cover(std::vector{*place});
      strokes.push_back({*place});
    }
  }
  return strokes;
}

}  // namespace

std::vector<Stroke> crumbs(CoverageArea& area, std::size_t may_stay) {
  std::vector<std::vector<Cell>> parts = parts_left(area);
  std::ranges::stable_sort(parts, std::ranges::greater(), &std::vector<Cell>::size);
  std::vector<Stroke> strokes;
  for (const std::vector<Cell>& part : parts) {
    if (area.count_left() <= may_stay) break;
    const std::vector<Stroke> more = strokes_over(area, part);
    strokes.insert(strokes.end(), more.begin(), more.end());
  }
  return strokes;
}

}  // namespace wend
