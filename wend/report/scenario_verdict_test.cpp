#include "wend/report/scenario_verdict.hpp"

#include <gmock/gmock.h>

namespace wend {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

ScenarioQuery query_of_length(double length) {
  ScenarioQuery query{};
  query.start = {0, 0};
  query.goal = {2, 0};
  query.length = length;
  return query;
}

Plan plan_along(std::vector<Cell> cells) {
  Plan plan;
  plan.path = Path(std::move(cells));
  return plan;
}

const Plan kStraight = plan_along({{0, 0}, {1, 0}, {2, 0}});

TEST(WrongAnswer, IsAnotherLength) {
  EXPECT_THAT(wrong_answer(query_of_length(2), Status::found, kStraight), IsEmpty());
  EXPECT_THAT(wrong_answer(query_of_length(2.1), Status::found, kStraight),
              HasSubstr("the file says 2.1"));
}

TEST(WrongAnswer, IsNoneWhereThereIsOne) {
  EXPECT_THAT(wrong_answer(query_of_length(2), Status::start_blocked, {}),
              HasSubstr("found none (the robot cannot stand on the start)"));
}

TEST(WrongAnswer, IsOneWhereThereIsNone) {
  EXPECT_THAT(wrong_answer(query_of_length(0), Status::unreachable, {}), IsEmpty());
  EXPECT_THAT(wrong_answer(query_of_length(0), Status::found, kStraight),
              HasSubstr("the file says that there is none"));
}

TEST(WrongPath, IsOneThatBreaksTheRules) {
  Grid<CellState> cells(3, 2, CellState::free);
  const FreeSpace open{GridMap(cells)};
  cells[{1, 0}] = CellState::occupied;
  const FreeSpace walled{GridMap(cells)};
  const ScenarioQuery query = query_of_length(2);
  EXPECT_THAT(wrong_path(open, query, kStraight.path), IsEmpty());
  EXPECT_THAT(wrong_path(walled, query, kStraight.path), HasSubstr("(1,0)"));
  EXPECT_THAT(wrong_path(open, query, Path({{0, 0}, {2, 0}})), HasSubstr("no step"));
  EXPECT_THAT(wrong_path(open, query, Path({{0, 0}, {1, 0}})), HasSubstr("does not join"));
  EXPECT_THAT(wrong_path(open, query, Path()), HasSubstr("does not join"));
  const Path cuts({{0, 0}, {1, 1}, {2, 0}});
  EXPECT_THAT(wrong_path(walled, query, cuts), HasSubstr("no step"));
  EXPECT_THAT(wrong_path(open, query, cuts), IsEmpty());
}

}  // namespace
}  // namespace wend
