// Searches in an order that was asked for, cell by cell against a textbook's search with a sorted list that shares no
// code with wend; and the numbers of two well-known exercises of a course.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

#include "wend/analysis/search_recorder.hpp"
#include "wend/base/random.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

using Rows = std::vector<std::string>;          // as drawn on a page: '.' is free
using Numbers = std::vector<std::vector<int>>;  // rows of a page

/// A map on a page, with row 0 at the top or at the bottom.
FreeSpace space_of(const Rows& rows, bool y_up) {
  const int height = static_cast<int>(rows.size());
  Grid<CellState> cells(static_cast<int>(rows.front().size()), height, CellState::free);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      const std::string& row = rows[static_cast<std::size_t>(y_up ? height - 1 - y : y)];
      if (row[static_cast<std::size_t>(x)] != '.') cells[{x, y}] = CellState::occupied;
    }
  }
  return *make_free_space(*make_grid_map(cells, Frame{.y_up = y_up}));
}

Cell flipped(Cell cell, const Rows& rows, bool y_up) {
  return y_up ? Cell{cell.x, static_cast<int>(rows.size()) - 1 - cell.y} : cell;
}

/// The cells of the page in the order in which a planner expands them.
std::vector<Cell> expansions(const std::string& planner, const OptionValues& options,
                             const Rows& rows, Cell start, Cell goal, bool y_up = false) {
  const FreeSpace space = space_of(rows, y_up);
  const auto made = make_planner(planner, space, options).value();
  SearchRecorder recorder(space);
  Query query = Query::between(flipped(start, rows, y_up), flipped(goal, rows, y_up));
  query.observer = &recorder;
  Plan plan;
  made->plan(query, plan);
  std::vector<Cell> cells;
  for (const Cell cell : recorder.expansions()) cells.push_back(flipped(cell, rows, y_up));
  return cells;
}

/// The order of expansion from 0, -1 where a cell was not expanded.
Numbers numbers(const std::vector<Cell>& cells, const Rows& rows) {
  Numbers grid(rows.size(), std::vector<int>(rows.front().size(), -1));
  int count = 0;
  for (const Cell cell : cells) {
    grid[static_cast<std::size_t>(cell.y)][static_cast<std::size_t>(cell.x)] = count++;
  }
  return grid;
}

const OptionValues kCourse{{"connectivity", "4"}, {"neighbour_order", "uldr"}, {"ties", "sorted"}};

TEST(SearchOrder, ReproducesTheExpansionGridOfACourse) {
  const Rows rows{"..#...", "......", "..#.#.", "..#.#.", "..#.#."};
  const Numbers expected{{0, 1, -1, 11, 15, 18},
                         {2, 3, 5, 8, 12, 16},
                         {4, 6, -1, 13, -1, 19},
                         {7, 9, -1, 17, -1, 21},
                         {10, 14, -1, 20, -1, 22}};
  EXPECT_EQ(numbers(expansions("dijkstra", kCourse, rows, {0, 0}, {5, 4}), rows), expected);
}

TEST(SearchOrder, ReproducesTheAStarGridOfACourse) {
  const Rows rows{".#....", ".#....", ".#....", ".#....", "....#."};
  const Numbers expected{{0, -1, -1, -1, -1, -1},
                         {1, -1, -1, -1, -1, -1},
                         {2, -1, -1, -1, -1, -1},
                         {3, -1, 8, 9, 10, 11},
                         {4, 5, 6, 7, -1, 12}};
  EXPECT_EQ(numbers(expansions("astar", kCourse, rows, {0, 0}, {5, 4}), rows), expected);
}

/// An entry of the open list of a textbook.
struct Open {
  int f;
  int g;
  Cell cell;
  int arrival;
};

struct Textbook {
  bool g_counts = true;     // f = g + h, else f = h
  bool h_counts = false;    // Manhattan distance
  bool keep_first = false;  // the first way to a cell
  std::string ties;
  std::string order;  // of neighbours: "uldr"

  bool before(const Open& a, const Open& b) const {
    if (a.f != b.f) return a.f < b.f;
    if (ties == "oldest") return a.arrival < b.arrival;
    if (ties == "newest") return a.arrival > b.arrival;
    return std::tuple(a.g, a.cell.y, a.cell.x) < std::tuple(b.g, b.cell.y, b.cell.x);
  }

  std::vector<Cell> expanded(const Rows& rows, Cell start, Cell goal) const {
    const int width = static_cast<int>(rows.front().size());
    const int height = static_cast<int>(rows.size());
    const auto at = [&](Cell cell) { return static_cast<std::size_t>(cell.y * width + cell.x); };
    std::vector<int> best(static_cast<std::size_t>(width * height), -1);
    std::vector<char> closed(best.size(), 0);
    int arrivals = 0;
    const auto entry = [&](Cell cell, int g) {
      const int h = std::abs(cell.x - goal.x) + std::abs(cell.y - goal.y);
      return Open{(g_counts ? g : 0) + (h_counts ? h : 0), g, cell, arrivals++};
    };
    std::vector<Open> open{entry(start, 0)};
    best[at(start)] = 0;
    std::vector<Cell> order_of_expansion;
    while (!open.empty()) {
      const auto least = std::min_element(open.begin(), open.end(),
                                          [this](auto& a, auto& b) { return before(a, b); });
      const Open next = *least;
      open.erase(least);
      if (closed[at(next.cell)] != 0) continue;
      closed[at(next.cell)] = 1;
      order_of_expansion.push_back(next.cell);
      if (next.cell == goal) break;
      for (const char letter : order) {
        const Cell to{next.cell.x + (letter == 'r') - (letter == 'l'),
                      next.cell.y + (letter == 'd') - (letter == 'u')};
        if (to.x < 0 || to.y < 0 || to.x >= width || to.y >= height) continue;
        if (rows[static_cast<std::size_t>(to.y)][static_cast<std::size_t>(to.x)] != '.') continue;
        int& known = best[at(to)];
        const bool better = known < 0 || (!keep_first && next.g + 1 < known);
        if (closed[at(to)] != 0 || !better) continue;
        known = next.g + 1;
        open.push_back(entry(to, known));
      }
    }
    return order_of_expansion;
  }
};

struct Case {
  std::string planner;
  Textbook textbook;
};

/// What the planners are in a textbook.
std::vector<Case> cases(Random& random, const std::string& order) {
  const std::array<std::string, 3> all{"oldest", "newest", "sorted"};
  const std::string ties = all[random.below(all.size())];
  return {{"dijkstra", {.ties = ties, .order = order}},
          {"astar", {.h_counts = true, .ties = ties, .order = order}},
          {"greedy",
           {.g_counts = false, .h_counts = true, .keep_first = true, .ties = ties, .order = order}},
          {"bfs", {.g_counts = false, .keep_first = true, .ties = "oldest", .order = order}},
          {"dfs", {.g_counts = false, .keep_first = true, .ties = "newest", .order = order}}};
}

Rows random_rows(Random& random) {
  Rows rows(static_cast<std::size_t>(random.between(1, 9)),
            std::string(static_cast<std::size_t>(random.between(2, 9)), '.'));
  for (std::string& row : rows) {
    for (char& cell : row) cell = random.chance(0.25) ? '#' : '.';
  }
  rows.front().front() = rows.back().back() = '.';
  return rows;
}

/// A search that cannot be answered is not begun: there the textbook's is skipped too.
TEST(SearchOrder, ExpandsAsATextbookDoes) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    const Rows rows = random_rows(random);
    const Cell goal{static_cast<int>(rows.front().size()) - 1, static_cast<int>(rows.size()) - 1};
    std::string order = "dlru";
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (const Case& each : cases(random, order)) {
      OptionValues options{{"connectivity", "4"}, {"neighbour_order", order}};
      const bool by_arrival = each.planner == "bfs" || each.planner == "dfs";
      if (!by_arrival) options.emplace_back("ties", each.textbook.ties);
      if (each.planner == "greedy") options.emplace_back("heuristic", "manhattan");
      const bool y_up = random.chance(0.5);
      const auto got = expansions(each.planner, options, rows, {0, 0}, goal, y_up);
      if (got.empty()) continue;
      ++compared;
      EXPECT_EQ(got, each.textbook.expanded(rows, {0, 0}, goal))
          << each.planner << " " << order << " " << each.textbook.ties << " seed " << seed;
    }
  }
  EXPECT_GT(compared, 800U);
}

/// On 8 neighbours: straight ones in their order, then those beside the first letter, then the rest.
TEST(SearchOrder, TakesDiagonalNeighboursBehindTheOthers) {
  const Rows rows{".....", ".....", ".....", ".....", "....."};
  const auto cells = expansions("bfs", {{"neighbour_order", "uldr"}}, rows, {2, 2}, {4, 4});
  const std::vector<Cell> expected{{2, 2}, {2, 1}, {1, 2}, {2, 3}, {3, 2},
                                   {1, 1}, {3, 1}, {1, 3}, {3, 3}};
  ASSERT_GE(cells.size(), expected.size());
  EXPECT_EQ(std::vector<Cell>(cells.begin(), cells.begin() + 9), expected);
}

/// Costs and bounds are those of the planner's own order, also on 8 neighbours and on terrain.
TEST(SearchOrder, ChangesNoCost) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Rows rows = random_rows(random);
    FreeSpace space = space_of(rows, random.chance(0.5));
    if (random.chance(0.5)) {
      MapEdit edit;
      for (int y = 0; y < space.height(); ++y) {
        for (int x = 0; x < space.width(); ++x) {
          if (!space.passable({x, y})) continue;
          edit.cells.push_back({{x, y}, CellState::free, 1.0 + random.between(0, 12) / 4.0});
        }
      }
      ASSERT_TRUE(space.edit(edit));
    }
    const Query query =
        Query::between({0, space.map().frame().y_up ? space.height() - 1 : 0},
                       {space.width() - 1, space.map().frame().y_up ? 0 : space.height() - 1});
    for (const std::string planner : {"astar", "dijkstra"}) {
      Plan own;
      Plan ordered;
      const Status status = make_planner(planner, space, {}).value()->plan(query, own);
      const auto other =
          make_planner(planner, space, {{"neighbour_order", "rdlu"}, {"ties", "sorted"}});
      ASSERT_EQ(other.value()->plan(query, ordered), status);
      if (status != Status::found) continue;
      EXPECT_NEAR(ordered.cost, own.cost, 2e-6 * own.cost) << planner << " seed " << seed;
      EXPECT_EQ(ordered.bound, own.bound);
    }
  }
}

}  // namespace
}  // namespace wend
