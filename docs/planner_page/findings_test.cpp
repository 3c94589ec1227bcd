#include "docs/planner_page/findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wend::planner_page {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

MeasuredPlanner row(const std::string& role, double cost, double expanded, double us) {
  MeasuredPlanner planner;
  planner.role = planner.planner = role;
  planner.solved = 10;
  planner.cost = planner.worst_cost = cost;
  planner.expanded = expanded;
  planner.us = us;
  planner.us_of_astar = us / 100;
  planner.clearance = 0.5;
  planner.ns_an_expansion = 1000 * us / expanded;
  return planner;
}

MeasuredFamily family(const std::string& title) {
  MeasuredFamily family;
  family.title = title;
  family.queries = family.solved_by_all = 10;
  family.planners = {row("astar", 1, 1000, 100),
                     row("dijkstra", 1, 4000, 300),
                     row("greedy", 1.2, 100, 20),
                     row("bfs", 1.1, 4000, 200),
                     row("dfs", 30, 3000, 300),
                     row("astar:weight=2", 1.3, 200, 60),
                     row("astar:heuristic=euclidean", 1, 1500, 250)};
  return family;
}

/// As things mostly are.
Measurements measurements() {
  Measurements all;
  all.families = {family("Field"), family("Maze")};
  all.families[1].is_maze = true;
  all.families[1].planners[0].expanded = 3900;
  all.small = family("Small");
  all.no_path = family("No path");
  for (MeasuredPlanner& planner : all.no_path.planners) planner.expanded = 0;
  all.clearance_distance.rows = {{0, 1, 0.3, 0.2, 100, 10}, {1, 1.1, 0.8, 0.3, 200, 50}};
  return all;
}

MeasuredPlanner& planner_of(MeasuredFamily& family, std::string_view role) {
  return const_cast<MeasuredPlanner&>(*family.find(role));
}

TEST(Findings, SayWhereTheEstimateHelps) {
  EXPECT_THAT(
      findings(measurements()),
      AllOf(HasSubstr("25 % of the cells that `dijkstra` did on *Field* and 98 % on *Maze*"),
            HasSubstr("In a maze the way leads away"),
            HasSubstr("`dijkstra` was never the faster of the two")));
}

TEST(Findings, DoNotBlameAMazeForWhatHappenedElsewhere) {
  Measurements all = measurements();
  planner_of(all.families[0], "astar").expanded = 3950;
  planner_of(all.families[1], "astar").expanded = 400;
  EXPECT_THAT(findings(all), Not(HasSubstr("In a maze the way leads away")));
}

TEST(Findings, NameTheMapsWhereDijkstraWasFaster) {
  Measurements all = measurements();
  planner_of(all.families[1], "dijkstra").us = 80;
  const std::string text = findings(all);
  EXPECT_THAT(text, HasSubstr("`dijkstra` was the faster of the two on *Maze*"));
  EXPECT_THAT(text, Not(HasSubstr("never the faster")));
}

TEST(Findings, ClaimABoundOnlyIfItHeld) {
  EXPECT_THAT(findings(measurements()), HasSubstr("a path may cost twice the optimum"));
  Measurements all = measurements();
  planner_of(all.families[0], "astar:weight=2").worst_cost = 2.1;
  EXPECT_THAT(findings(all), Not(HasSubstr("a path may cost twice the optimum")));
}

TEST(Findings, SayWhereAWeightPaid) {
  Measurements all = measurements();
  planner_of(all.families[1], "astar:weight=2").us = 350;
  planner_of(all.families[1], "astar:weight=2").expanded = 3800;
  EXPECT_THAT(findings(all),
              AllOf(HasSubstr("faster on *Field*, up to 1.67 times, but slower on *Maze*"),
                    HasSubstr("It paid off where it expanded no more than 20 % of the cells")));
  planner_of(all.families[1], "astar:weight=2").expanded = 100;
  EXPECT_THAT(findings(all), Not(HasSubstr("It paid off")));
}

TEST(Findings, CallAQueueCheaperOnlyIfItWas) {
  EXPECT_THAT(findings(measurements()), HasSubstr("a queue needs no keys and no order."));
  Measurements all = measurements();
  planner_of(all.families[0], "bfs").ns_an_expansion = 1e6;
  EXPECT_THAT(findings(all), HasSubstr("are half as large"));
}

TEST(Findings, PraiseTheStackOnlyInMazes) {
  Measurements all = measurements();
  planner_of(all.families[0], "dfs").worst_cost = 1;
  EXPECT_THAT(findings(all), Not(HasSubstr("one way joins any two places")));
  planner_of(all.families[1], "dfs").worst_cost = 1;
  EXPECT_THAT(findings(all), HasSubstr("On *Maze* they were the cheapest all the same"));
}

TEST(Findings, KnowFourNeighboursAndTerrain) {
  Measurements all = measurements();
  EXPECT_THAT(findings(all), AllOf(Not(HasSubstr("On 4 neighbours")), Not(HasSubstr("Terrain"))));
  all.families.push_back(family("Four"));
  all.families.back().eight_neighbours = false;
  EXPECT_THAT(findings(all), Not(HasSubstr("so the fewest of them are the cheapest path")));
  planner_of(all.families.back(), "bfs").worst_cost = 1;
  EXPECT_THAT(findings(all), HasSubstr("so the fewest of them are the cheapest path"));
  all.families.push_back(family("Hills"));
  all.families.back().uniform_terrain = false;
  EXPECT_THAT(findings(all), HasSubstr("`greedy`, `bfs` and `dfs` do not look at what a cell "
                                       "costs: on *Hills* their paths cost 1.10 to 30 times"));
}

TEST(Findings, SayWhetherAnybodySearchedForWhatIsNotThere) {
  Measurements all = measurements();
  EXPECT_THAT(findings(all), HasSubstr("not a single expansion"));
  planner_of(all.no_path, "bfs").expanded = 1;
  EXPECT_THAT(findings(all), HasSubstr("some planners searched first"));
}

TEST(Findings, TellTheWinners) {
  EXPECT_THAT(findings(measurements()),
              HasSubstr("`astar` was the fastest on 2 of 2 maps. Of all, `greedy` was the fastest "
                        "on 2 of 2 maps"));
}

}  // namespace
}  // namespace wend::planner_page
