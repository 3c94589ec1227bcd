#include "bench/suites/cases/cases.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "bench/boost/boost_planner.hpp"
#include "bench/comparison/random_queries.hpp"
#include "bench/suites/se2/se2_case.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

constexpr int kSide = 1024;
constexpr std::uint64_t kQueries = 10;

GridMap map_of(std::string_view kind, int side = kSide) {
  return generated_map(kind, side, side,
                       kind == "random" ? OptionValues{{"density", "0.1"}} : OptionValues{});
}

FreeSpace space_of(const GridMap& map, const FreeSpaceOptions& robot = {}) {
  return value_or_refuse(make_free_space(map, robot));
}

std::vector<Query> queries_on(const FreeSpace& space, std::uint64_t count = kQueries) {
  std::vector<Query> queries;
  for (const CellPair& pair : random_pairs(space, count, 7)) {
    queries.push_back(Query::between(pair.start, pair.goal));
  }
  if (queries.empty()) throw Wrong("the robot fits nowhere on a map");
  return queries;
}

template <class Run>
double seconds(Run&& run) {
  return seconds_of(thread_cpu_seconds, std::forward<Run>(run));
}

/// Answers all; a query that lacks a path ends the program.
void answer(Planner& planner, const std::vector<Query>& queries) {
  Plan plan;
  for (const Query& query : queries) {
    if (planner.plan(query, plan) != Status::found) throw Wrong("no path between connected cells");
  }
}

/// The first query of a space that no planner has seen, making the planner counted; a mean.
Case first_query(std::string subject, std::string planner, const GridMap& map,
                 const FreeSpaceOptions& robot = {}) {
  return {std::move(subject), "first query",
          [map, robot, planner = std::move(planner), queries = queries_on(space_of(map, robot))] {
            double sum = 0;
            for (const Query& query : queries) {
              const FreeSpace space = space_of(map, robot);
              sum +=
                  seconds([&] { answer(*value_or_refuse(make_planner(planner, space)), {query}); });
            }
            return sum / static_cast<double>(queries.size());
          }};
}

/// Queries of a planner that has answered them before; a mean.
Case later_queries(std::string subject, std::unique_ptr<Planner> planner,
                   std::vector<Query> queries) {
  answer(*planner, queries);
  return {std::move(subject), "later queries",
          [planner = std::shared_ptr(std::move(planner)), queries = std::move(queries)] {
            return seconds([&] { answer(*planner, queries); }) /
                   static_cast<double>(queries.size());
          }};
}

Case later_queries(std::string subject, const std::string& planner, const GridMap& map,
                   const FreeSpaceOptions& robot = {}) {
  const FreeSpace space = space_of(map, robot);
  return later_queries(std::move(subject), value_or_refuse(make_planner(planner, space)),
                       queries_on(space));
}

Case labels(std::string subject, double radius) {
  const FreeSpace space = space_of(map_of("office", 256), {.footprint = Footprint::disc(radius)});
  const IndexSupport& support = *planners().find("euclidean_labels")->index_support;
  auto planner =
      value_or_refuse(support.make_planner(space, {}, value_or_refuse(support.build(space, {}))));
  return later_queries(std::move(subject), std::move(planner), queries_on(space, 1000));
}

Case drives(std::string_view kind, std::size_t robot) {
  const NamedRobot chosen = se2_robots()[robot];
  const GridMap map = in_metres(generated_map(kind, 600, 400), 0.1);
  const FreeSpace space = space_of(map, chosen.options);
  auto planner = value_or_refuse(make_planner("hybrid_astar", space));
  return later_queries("hybrid_astar, " + std::string(kind) + ", " + chosen.name,
                       std::move(planner), random_pose_queries(space, 20, 7));
}

/// An edit of one cell, and what a planner makes of it.
Case edit_after(const std::string& planner) {
  auto space = std::make_shared<FreeSpace>(space_of(map_of("office")));
  const auto made = std::shared_ptr(value_or_refuse(make_planner(planner, *space)));
  const std::vector<Query> queries = queries_on(*space, 2);
  return {planner, "an edit after a query", [=] {
            answer(*made, queries);
            const Cell cell = cell_at(queries.front().start.point());
            double sum = 0;
            for (const CellState state : {CellState::occupied, CellState::free}) {
              sum += seconds([&] {
                made->release();
                const auto change = value_or_refuse(space->edit({.cells = {{cell, state}}}));
                if (!made->update(*space, change)) throw Wrong("an edit was refused");
              });
            }
            return sum / 2;
          }};
}

/// The bytes of a costmap, dearer towards obstacles.
std::vector<std::uint8_t> costmap_of(const GridMap& map) {
  const FreeSpace space = space_of(map);
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const Cell cell{x, y};
      const double near = std::exp(-space.clearance(cell) / 5);
      bytes.push_back(space.passable(cell) ? static_cast<std::uint8_t>(252 * near) : 254);
    }
  }
  return bytes;
}

Case new_costmap() {
  const GridMap map = map_of("office");
  return {"astar", "a new costmap to its first path",
          [bytes = costmap_of(map), query = queries_on(space_of(map), 1)] {
            return seconds([&] {
              const FreeSpace space =
                  space_of(value_or_refuse(map_from_costmap(bytes, kSide, kSide, {})));
              answer(*value_or_refuse(make_planner("astar", space)), query);
            });
          }};
}

Case load(std::string subject, std::string file, std::string_view head, char free, char occupied) {
  const GridMap map = map_of("office");
  std::string bytes(head);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      bytes += map.state(Cell{x, y}) == CellState::free ? free : occupied;
    }
    if (head.starts_with("type")) bytes += '\n';
  }
  return {std::move(subject), "1024 x 1024 cells",
          [bytes = std::move(bytes), file = std::move(file)] {
            return seconds([&] { value_or_refuse(parse_map(bytes, file)); });
          }};
}

Case field_of(int side) {
  const FreeSpace space = space_of(map_of("office", side));
  return {"cost to go", std::to_string(side) + " x " + std::to_string(side) + " cells",
          [space, goal = cell_at(queries_on(space, 1).front().start.point())] {
            return seconds([&] { value_or_refuse(CostToGo::make(space, {&goal, 1})); });
          }};
}

}  // namespace

Case boost_case() {
  const FreeSpace space = space_of(map_of("office"));
  return later_queries("boost-astar", value_or_refuse(boost_astar_planner().make(space, {})),
                       queries_on(space));
}

std::vector<Case> all_cases() {
  const FreeSpaceOptions keeps_away{.clearance_distance = 0.35};
  const GridMap office = in_metres(map_of("office"), 0.05);
  const GridMap warehouse = in_metres(map_of("warehouse"), 0.05);
  std::vector<Case> cases;
  for (const char* const kind : {"office", "maze", "random"}) {
    cases.push_back(first_query("jps, " + std::string(kind), "jps", map_of(kind)));
    cases.push_back(first_query("any_angle, " + std::string(kind), "any_angle", map_of(kind)));
  }
  cases.push_back(later_queries("theta_star, office", "theta_star", map_of("office", 512)));
  cases.push_back(first_query("astar, graded costs", "astar", office, keeps_away));
  cases.push_back(later_queries("astar, graded costs", "astar", office, keeps_away));
  cases.push_back(later_queries("astar, sparse costs", "astar", warehouse, keeps_away));
  cases.push_back(new_costmap());
  cases.push_back(later_queries("ara_star, office", "ara_star", map_of("office")));
  cases.push_back(later_queries("ara_star, graded costs", "ara_star", office, keeps_away));
  cases.push_back(drives("warehouse", 0));
  cases.push_back(drives("warehouse", 1));
  cases.push_back(labels("euclidean_labels, a point", 0));
  cases.push_back(labels("euclidean_labels, a disc", 1));
  cases.push_back(edit_after("astar"));
  cases.push_back(edit_after("jps"));
  cases.push_back(field_of(1024));
  cases.push_back(field_of(4096));
  cases.push_back(load(".map", "a.map", "type octile\nheight 1024\nwidth 1024\nmap\n", '.', '@'));
  cases.push_back(load("PGM", "a.pgm", "P5\n1024 1024\n255\n", '\xfe', '\0'));
  return cases;
}

}  // namespace wend::bench
