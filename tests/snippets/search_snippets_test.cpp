// The snippets of the headers of search, jump and index and of the planners on them, compiled and run as
// they stand there.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "wend/index/file/index_sections.hpp"
#include "wend/jump/dead_ends.hpp"
#include "wend/jump/jump_graph.hpp"
#include "wend/jump/shortcut_graph.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/jump/goal_sight.hpp"
#include "wend/planner/jump/jump_point_search.hpp"
#include "wend/planner/jump/jump_trail.hpp"
#include "wend/planner/jump/known_jumps.hpp"
#include "wend/planner/jump/scanned_jumps.hpp"
#include "wend/planner/lattice/goal_costs.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/links.hpp"
#include "wend/sight/corner_sweep.hpp"
#include "wend/sight/portals.hpp"
#include "wend/sight/taut_graph.hpp"
#include "wend/sight/taut_map.hpp"
#include "wend/space/grid/grid_space.hpp"
#include "wend/space/grid/search_order.hpp"
#include "wend/space/grid/sight_grid.hpp"
#include "wend/space/lattice/motion_steps.hpp"

namespace {

using wend::BitGrid;
using wend::Cell;

/// 9 x 5 cells with a wall that leaves a gap at its end.
const wend::FreeSpace& walled_ground() {
  static const wend::FreeSpace space = *wend::make_free_space([] {
    wend::Grid<wend::CellState> cells(9, 5, wend::CellState::free);
    for (int y = 0; y < 4; ++y) cells[{4, y}] = wend::CellState::occupied;
    return *wend::make_grid_map(cells);
  }());
  return space;
}

TEST(SearchSnippets, SearchOrder) {
  const wend::SearchOrder order{wend::NeighbourOrder::uldr, wend::Ties::sorted};
  EXPECT_TRUE(order.chosen());
}

TEST(SearchSnippets, OfForwardSearchAndLimitCheck) {
  using wend::ByArrival, wend::DuplicateRule, wend::ExactGrid, wend::FifoFrontier;
  using wend::ForwardSearch, wend::SearchOutcome;
  const ExactGrid space(walled_ground(), {});
  const std::array starts{space.state(Cell{0, 0})};
  const wend::Limits limits;
  ByArrival priority;
  priority.begin(std::array{wend::GoalRegion({8, 0})}, limits);

  using BreadthFirst = ForwardSearch<ExactGrid, FifoFrontier, ByArrival, DuplicateRule::keep_first>;
  BreadthFirst search(space, priority);
  search.begin(starts, limits);
  while (search.outcome() == SearchOutcome::running) search.step();
  EXPECT_EQ(search.outcome(), SearchOutcome::found);
  EXPECT_EQ(search.goal().cell, (Cell{8, 0}));

  wend::LimitCheck check;
  SearchOutcome outcome = SearchOutcome::running;
  wend::Limits two;
  two.expansions = 2;
  check.begin(two);
  std::uint64_t expanded = 0;
  while (outcome == SearchOutcome::running) {
    if (check.due(expanded)) outcome = check.look(expanded);
    ++expanded;
  }
  EXPECT_EQ(outcome, SearchOutcome::expansion_limit);
  EXPECT_EQ(expanded, 3);
}

TEST(SearchSnippets, OfLinksAndSightGrid) {
  const wend::FreeSpace& space = walled_ground();
  const wend::SightGrid grid(space);
  double length = 0;
  if (grid.sees(grid.state({0, 0}), grid.state({5, 2}))) length = std::sqrt(29);
  EXPECT_EQ(length, 0) << "the wall is between them";
  EXPECT_TRUE(grid.sees(grid.state({0, 0}), grid.state({3, 2})));

  using Estimate = wend::RealEstimate<wend::SightGrid>;
  wend::ForwardSearch<wend::SightGrid, wend::HeapFrontier<wend::RealKey<double>>, Estimate,
                      wend::DuplicateRule::keep_cheaper, wend::ParentLinks>
      search(grid, Estimate(wend::HeuristicKind::euclidean, 0, 1, 1));
  const wend::Limits limits;
  search.priority().begin(std::array{wend::GoalRegion({8, 0})}, limits);
  search.begin(std::array{grid.state({0, 0})}, limits);
  EXPECT_EQ(search.run(), wend::SearchOutcome::found);
  EXPECT_DOUBLE_EQ(search.g(search.goal().number), 8 * std::sqrt(2))
      << "past the corner of the wall";
}

TEST(SearchSnippets, OfCornersAndTheirSight) {
  const wend::FreeSpace& space = walled_ground();
  std::vector<Cell> marked;
  const auto mark = [&](int x, int y) { marked.push_back({x, y}); };
  const wend::Portals portals(space.passable());
  for (const wend::TautCorner& corner : portals.corners()) mark(corner.x, corner.y);
  EXPECT_EQ(marked, (std::vector<Cell>{{4, 4}, {5, 4}})) << "the end of the wall";

  std::vector<std::uint32_t> seen;
  const auto see = [&](std::uint32_t corner, wend::Ray ray) {
    seen.push_back(corner);
    EXPECT_EQ(ray.y, 1);
  };
  wend::CornerSweep sweep(portals);
  sweep.from_point(wend::SightPoint::centre({0, 3}),
                   [&](std::uint32_t corner, wend::Ray ray) { see(corner, ray); });
  EXPECT_EQ(seen, std::vector<std::uint32_t>{0}) << "the other one lies behind it";

  const wend::SightPoint viewer =
      wend::SightPoint::at({2.25, 0.5}, {2, 0}, wend::SightPoint::finest(1000));
  EXPECT_EQ(viewer.point(), (wend::Point{2.25, 0.5}));

  wend::TautGraph graph(std::make_shared<const wend::Portals>(portals));
  double reached = 0;
  const auto reach = [&](const wend::TautGraph::Edge& edge) {
    EXPECT_EQ(edge.to, 1U);
    reached = edge.length;
  };
  const wend::Ray ray{7, 1};
  const std::uint32_t corner = 0;
  const wend::TautGraph::Edges ahead = graph.ahead_of(corner, ray);
  for (std::uint32_t i = ahead.begin; i < ahead.end; ++i) reach(graph.edge(i));
  EXPECT_EQ(reached, 1);

  marked.clear();
  const auto mark_corner = [&](std::uint32_t number) {
    marked.push_back({static_cast<int>(number), 0});
  };
  const auto shared = std::make_shared<const wend::Portals>(portals);
  const auto map = wend::TautMap::make(shared, wend::TautMap::usual_most_bytes(*shared));
  if (map != nullptr) map->for_each_seen({0, 3}, mark_corner);
  EXPECT_EQ(marked, std::vector<Cell>{Cell{}});

  const auto wants_more = [](double share) { return share < 1; };
  std::size_t edges = 0;
  const auto use = [&](const std::shared_ptr<const wend::TautMap>& made) {
    edges = made->graph().edges();
  };
  wend::TautMapMaking making(shared, wend::TautMap::usual_most_bytes(*shared));
  const auto state = making.go_on([&](double share) { return wants_more(share); });
  if (state == wend::TautMapMaking::State::finished) use(making.take());
  EXPECT_EQ(edges, 2U) << "between its corners, there and back";
}

TEST(SearchSnippets, OfGoalCosts) {
  using Frontier = wend::HeapFrontier<wend::RealKey<double>>;
  const auto robot = wend::MotionPrimitives::turning_circle(0);
  const wend::MotionLattice lattice(walled_ground(), *robot, {});
  wend::GoalCosts<wend::VertexSpace, Frontier, wend::ParentLinks> costs{wend::VertexSpace(lattice)};
  const wend::Limits limits;
  const Cell goal{8, 0};
  const Cell vertex{0, 0};
  costs.begin(limits);
  costs.add(costs.space().state(goal));
  const auto estimate = costs(costs.space().state(vertex));
  EXPECT_GT(estimate, 8 * std::sqrt(2)) << "around the wall";
  EXPECT_EQ(costs(costs.space().state(goal)), 0);
}

TEST(SearchSnippets, OfJumpGraphs) {
  const auto boards = std::make_shared<const wend::JumpBoards>(walled_ground().passable());
  std::vector<wend::Jump> jumps;
  const wend::JumpGraph graph(boards);
  graph.append_jumps({0, 0}, boards->moves({0, 0}), jumps);
  ASSERT_FALSE(jumps.empty()) << "the end of the wall is a jump point";
  const wend::Jump jump = jumps.front();
  jumps.clear();
  graph.append_jumps(graph.cell(jump.number()), graph.directions(jump), jumps);
  EXPECT_FALSE(jumps.empty());

  int reached = 0;
  const auto reach = [&](const wend::Shortcut& /*shortcut*/) { ++reached; };
  {
    wend::ShortcutGraph graph(std::make_shared<const wend::JumpGraph>(boards));
    for (const wend::Shortcut& shortcut : graph.shortcuts(jump)) reach(shortcut);
  }
  EXPECT_GT(reached, 0);
}

TEST(SearchSnippets, OfJumpScans) {
  const wend::FreeSpace& space = walled_ground();
  const Cell cell{0, 0};
  int used = 0;
  const auto use = [&](const wend::ScannedJump& /*jump*/) { return ++used > 0; };
  wend::JumpScan scan(space.passable());
  scan.visit_jumps(cell, 0xFF, [&](const wend::ScannedJump& jump) { return use(jump); });
  EXPECT_GT(used, 0) << "the end of the wall is a jump point";

  const wend::BitGrid& passable = space.passable();
  wend::ColumnTiles columns(passable);
  columns.prepare({3, 4});  // before what lies around the cell is read
  const bool free = (columns.line(3)[(4 + 1) / 64] >> (4 + 1) % 64 & 1U) != 0;
  EXPECT_EQ(free, (passable[Cell{3, 4}]));
}

TEST(SearchSnippets, OfCoarseBox) {
  const int width = 9;
  const int height = 5;
  const wend::CoarseRaster raster(width, height);
  wend::CoarseBox box;
  box.include(raster.place({3, 4}));
  EXPECT_TRUE(box.may_hold(raster.place({3, 4})));
}

TEST(SearchSnippets, OfDeadEnds) {
  const wend::JumpBoards boards(walled_ground().passable());
  const Cell start{0, 0};
  const std::array goals{Cell{8, 0}};
  const auto dead_ends = std::make_shared<const wend::DeadEnds>(boards);
  wend::OpenDeadEnds open(dead_ends);
  open.open_for(start, goals);
  EXPECT_TRUE(open.contains(open.number({4, 4}))) << "every path goes round the end of the wall";
}

TEST(SearchSnippets, OfJumpPointSearchAndItsParts) {
  const auto shared = std::make_shared<const wend::JumpBoards>(walled_ground().passable());
  const auto graph = std::make_shared<const wend::JumpGraph>(shared);
  const auto dead_ends = std::make_shared<const wend::DeadEnds>(*shared);
  std::vector<Cell> drawn;
  const auto draw = [&](std::span<const Cell> cells) { drawn.assign(cells.begin(), cells.end()); };
  const wend::Limits limits;
  {
    const std::array goals{wend::GoalRegion({8, 1})};
    const wend::FreeSpace& space = walled_ground();
    wend::JumpPointSearch search(wend::ScannedJumps<std::uint32_t>(space.passable()));
    search.begin({1, 1}, goals, limits);
    if (search.run() == wend::SearchOutcome::found) draw(search.waypoints());
  }
  ASSERT_FALSE(drawn.empty());
  EXPECT_EQ(drawn.front(), (Cell{1, 1}));
  EXPECT_EQ(drawn.back(), (Cell{8, 1}));

  const wend::JumpBoards& boards = *shared;
  const wend::KnownJumps<std::uint32_t> jumps(graph, dead_ends);
  const Cell goal{8, 4};
  const Cell start{0, 0};
  const Cell cell{0, 4};
  const std::array regions{wend::GoalRegion(goal)};
  const wend::DirectionSet directions = boards.moves(cell);
  const std::uint32_t g = 0;
  wend::GoalSight<std::uint32_t> goals;
  goals.begin(regions, start, boards);
  const auto view = goals.look(jumps, cell, directions, g);
  EXPECT_TRUE(view.nearest) << "the bottom row is free";

  const std::array jump_points{Cell{4, 4}};
  wend::JumpTrail trail;
  trail.begin(goal);
  trail.append_back(jump_points);
  trail.append(start);
  draw(trail.from_start());
  EXPECT_EQ(drawn.front(), start);
  EXPECT_EQ(drawn.back(), goal);
}

TEST(SearchSnippets, OfIndexSections) {
  const wend::FreeSpace& space = walled_ground();
  const std::vector<std::uint32_t> offsets{0, 3, 7};
  wend::IndexWriter writer("my_planner", 1, space.passable());
  writer.add(std::span<const std::uint32_t>(offsets));
  const wend::IndexBytes index = writer.finish();
  const auto reader = wend::IndexReader::open(index, "my_planner", 1, space.passable());
  ASSERT_TRUE(reader);
  const auto section = reader->section<std::uint32_t>(0);
  ASSERT_TRUE(section);
  EXPECT_TRUE(std::equal(section->begin(), section->end(), offsets.begin(), offsets.end()));
}

}  // namespace
