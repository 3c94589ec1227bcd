#include "bench/scenario/scenario_verdict.hpp"

#include <gmock/gmock.h>

#include <limits>

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
  plan.bound = 1;
  return plan;
}

const Plan kStraight = plan_along({{0, 0}, {1, 0}, {2, 0}});

FreeSpace space_of(const Grid<CellState>& cells) { return *make_free_space(*make_grid_map(cells)); }

const Grid<CellState> kOpen(3, 2, CellState::free);

std::string verdict(const ScenarioQuery& query, Status status, const Plan& plan) {
  return wrong_answer(space_of(kOpen), {}, query, status, plan);
}

TEST(WrongAnswer, IsAnotherLength) {
  EXPECT_THAT(verdict(query_of_length(2), Status::found, kStraight), IsEmpty());
  EXPECT_THAT(verdict(query_of_length(2.1), Status::found, kStraight), HasSubstr("expected 2.1"));
}

TEST(WrongAnswer, IsALengthBeyondTheBoundOrShorterThanTheShortest) {
  Plan detour = plan_along({{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}});
  const auto with_bound = [&](double bound, double length) {
    detour.bound = bound;
    return verdict(query_of_length(length), Status::found, detour);
  };
  EXPECT_THAT(with_bound(1, 2), HasSubstr("found a path of length 4.00000000, expected 2"));
  EXPECT_THAT(with_bound(1.9, 2), HasSubstr("expected at most 1.9 times 2"));
  EXPECT_THAT(with_bound(2, 2), IsEmpty());
  EXPECT_THAT(with_bound(3, 2), IsEmpty());
  EXPECT_THAT(with_bound(Plan::kNoBound, 2), IsEmpty());
  for (const double bound : {1.0, 2.0, Plan::kNoBound}) {
    EXPECT_THAT(with_bound(bound, 4.1), HasSubstr("length 4.00000000, expected")) << bound;
  }
}

TEST(WrongAnswer, IsALineThatIsNotFreeWhateverTheLength) {
  const auto verdict_of_lines = [](const Grid<CellState>& cells) {
    return wrong_answer(space_of(cells), {}, query_of_length(9), Status::found,
                        plan_along({{0, 0}, {2, 0}}), PathKind::lines);
  };
  Grid<CellState> cells = kOpen;
  EXPECT_THAT(verdict_of_lines(cells), IsEmpty());
  cells[{1, 0}] = CellState::occupied;
  EXPECT_THAT(verdict_of_lines(cells), HasSubstr("(0,0) to (2,0) is not free"));
}

TEST(WrongAnswer, IsNoneWhereThereIsOne) {
  EXPECT_THAT(verdict(query_of_length(2), Status::start_blocked, {}),
              HasSubstr("found none (the robot does not fit at the start), expected one"));
}

TEST(WrongAnswer, IsOneWhereThereIsNone) {
  const double none = std::numeric_limits<double>::infinity();
  for (const double length : {0.0, none}) {
    EXPECT_THAT(verdict(query_of_length(length), Status::unreachable, {}), IsEmpty());
    EXPECT_THAT(verdict(query_of_length(length), Status::found, kStraight),
                HasSubstr("found a path of length 2, expected none"));
  }
}

TEST(WrongAnswer, IsNotOneThatRanOutOfTime) {
  EXPECT_THAT(verdict(query_of_length(2), Status::time_limit, {}), IsEmpty());
}

TEST(WrongAnswer, IsAPathThatBreaksTheRules) {
  Grid<CellState> cells = kOpen;
  cells[{1, 0}] = CellState::occupied;
  const auto walled = [&](double length, CornerRule rule, const Plan& plan) {
    return wrong_answer(space_of(cells), {Connectivity::eight, rule}, query_of_length(length),
                        Status::found, plan);
  };
  const Plan cuts = plan_along({{0, 0}, {1, 1}, {2, 0}});
  EXPECT_THAT(walled(2, CornerRule::none, kStraight), HasSubstr("(1,0)"));
  EXPECT_THAT(walled(2.82842712, CornerRule::none, cuts), HasSubstr("no step"));
  EXPECT_THAT(walled(2.82842712, CornerRule::one, cuts), IsEmpty());
  const auto open = [](std::vector<Cell> path) {
    return verdict(query_of_length(2), Status::found, plan_along(std::move(path)));
  };
  EXPECT_THAT(open({{0, 0}, {2, 0}}), HasSubstr("no step"));
  EXPECT_THAT(open({{0, 0}, {1, 0}}), HasSubstr("does not join"));
  EXPECT_THAT(open({}), HasSubstr("does not join"));
}

TEST(WrongAnswer, CountsTerrain) {
  Grid<double> terrain(3, 2, 1);
  terrain[{1, 0}] = 3;
  const FreeSpace rough = *make_free_space(*make_grid_map(kOpen, {}, terrain));
  EXPECT_THAT(wrong_answer(rough, {}, query_of_length(4), Status::found, kStraight), IsEmpty());
  EXPECT_THAT(wrong_answer(rough, {}, query_of_length(2), Status::found, kStraight),
              HasSubstr("length 4.0"));
}

}  // namespace
}  // namespace wend
