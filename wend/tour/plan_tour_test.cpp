#include "wend/tour/plan_tour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/random.hpp"
#include "wend/tour/lower_bound.hpp"
#include "wend/tour/order_problem.hpp"
#include "wend/tour/order_search.hpp"

namespace wend {
namespace {

struct Case {
  CostMatrix costs;
  TourOptions options;
};

CostMatrix random_costs(Random& random, int stops, bool symmetric, double no_way) {
  CostMatrix costs(stops);
  for (int from = 0; from < stops; ++from) {
    for (int to = 0; to < stops; ++to) {
      if (from == to) continue;
      const bool none = random.chance(no_way);
      const double cost = none ? CostMatrix::kNoWay : random.between(0, 20) * 0.5;
      costs.set(from, to, symmetric && to < from ? costs(to, from) : cost);
    }
  }
  return costs;
}

/// Options that some order obeys: they are made of a random one.
TourOptions random_options(Random& random, int stops) {
  std::vector<int> order(static_cast<std::size_t>(stops));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  TourOptions options;
  options.closed = random.chance(0.5);
  if (options.closed || random.chance(0.4)) options.start = order.front();
  if (!options.closed && stops > 1 && random.chance(0.4)) options.end = order.back();
  const auto pick = [&] { return static_cast<std::size_t>(random.below(order.size())); };
  for (int i = random.between(0, 3); i > 0 && stops > 1; --i) {
    const std::size_t a = pick();
    const std::size_t b = pick();
    if (a != b) options.before.push_back({order[std::min(a, b)], order[std::max(a, b)]});
  }
  for (int i = random.between(0, 2); i > 0 && stops > 2; --i) {
    const std::size_t a = pick();
    if (a + 1 < order.size()) options.fixed.push_back({order[a + 1], order[a]});
  }
  return options;
}

Case random_case(Random& random, int stops) {
  const double no_way = random.chance(0.3) ? 0.2 : 0;
  return {random_costs(random, stops, random.chance(0.5), no_way), random_options(random, stops)};
}

/// Independent of what the library does: every demand by its definition.
bool is_allowed(const TourOptions& options, const std::vector<int>& order) {
  const auto rank = [&](int stop) { return std::ranges::find(order, stop) - order.begin(); };
  if (options.closed && order.front() != options.start.value_or(0)) return false;
  if (options.start && order.front() != *options.start) return false;
  if (options.end && order.back() != *options.end) return false;
  for (const auto& [first, second] : options.before) {
    if (rank(first) >= rank(second)) return false;
  }
  const auto last = static_cast<std::ptrdiff_t>(order.size()) - 1;
  return std::ranges::all_of(options.fixed, [&](const StopPair& pair) {
    const auto apart = std::abs(rank(pair.first) - rank(pair.second));
    return apart == 1 || (options.closed && apart == last);
  });
}

double cost_of(const Case& trial, const std::vector<int>& order) {
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) sum += trial.costs(order[i - 1], order[i]);
  return trial.options.closed ? sum + trial.costs(order.back(), order.front()) : sum;
}

/// Tries every order.
double least_cost(const Case& trial) {
  std::vector<int> order(static_cast<std::size_t>(trial.costs.size()));
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    if (is_allowed(trial.options, order)) least = std::min(least, cost_of(trial, order));
  } while (std::ranges::next_permutation(order).found);
  return least;
}

bool visits_all(const std::vector<int>& order, int stops) {
  std::vector<int> sorted = order;
  std::ranges::sort(sorted);
  std::vector<int> all(static_cast<std::size_t>(stops));
  std::iota(all.begin(), all.end(), 0);
  return sorted == all;
}

TEST(PlanTour, IsTheBestOfAllOrdersOfFewStops) {
  int found = 0;
  for (int seed = 1; seed <= test::share_of(300) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    const Case trial = random_case(random, random.between(1, 6));
    const double least = least_cost(trial);
    const auto tour = plan_tour(trial.costs, trial.options);
    ASSERT_EQ(tour.has_value(), std::isfinite(least)) << (tour ? "" : tour.error().message);
    if (!tour) {
      ASSERT_EQ(tour.error().status, Status::unreachable);
      continue;
    }
    ++found;
    ASSERT_TRUE(visits_all(tour->order, trial.costs.size()));
    ASSERT_TRUE(is_allowed(trial.options, tour->order));
    ASSERT_DOUBLE_EQ(tour->cost, least);
    ASSERT_EQ(tour->bound, tour->cost);
  }
  EXPECT_GT(found, test::share_of(150));
}

/// The search that is meant for many stops, on few, from the exact order.
TEST(OrderSearch, ObeysAndKeepsTheBestOrder) {
  int best = 0;
  int tried = 0;
  for (int seed = 1; seed <= test::share_of(60) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    Case trial = random_case(random, random.between(9, 11));
    const auto exact = plan_tour(trial.costs, trial.options);
    if (!exact) continue;
    ++tried;
    const OrderProblem problem = *make_order_problem(trial.costs, trial.options);
    const double bound = lower_bound(problem, exact->cost, {});
    ASSERT_LE(bound, exact->cost);
    const auto search = make_order_search(problem, exact->order, 1);
    search->settle();
    for (int i = 0; i < 300; ++i) search->kick();
    const std::vector<int> order = search->order();
    ASSERT_TRUE(visits_all(order, trial.costs.size()));
    ASSERT_TRUE(is_allowed(trial.options, order));
    const double cost = cost_of(trial, order);
    ASSERT_GE(cost, exact->cost - 1e-9);
    if (cost <= exact->cost + 1e-9) ++best;
  }
  EXPECT_EQ(best, tried) << "a search never loses what it began with";
}

TEST(PlanTour, ObeysOnManyStops) {
  int found = 0;
  for (int seed = 1; seed <= test::share_of(40) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    Case trial{random_costs(random, 13 + random.between(0, 30), random.chance(0.5), 0), {}};
    trial.options = random_options(random, trial.costs.size());
    trial.options.kicks = 100;
    const auto tour = plan_tour(trial.costs, trial.options);
    ASSERT_TRUE(tour) << tour.error().message;
    ++found;
    ASSERT_TRUE(visits_all(tour->order, trial.costs.size()));
    ASSERT_TRUE(is_allowed(trial.options, tour->order));
    ASSERT_DOUBLE_EQ(tour->cost, cost_of(trial, tour->order));
    ASSERT_LE(tour->bound, tour->cost);
    ASSERT_EQ(tour->kicks, 100U);
    const auto again = plan_tour(trial.costs, trial.options);
    ASSERT_EQ(again->order, tour->order) << "the same seed";
  }
  EXPECT_GT(found, 0);
}

/// Points on a circle: the best order goes around.
CostMatrix circle(int stops, double uphill) {
  CostMatrix costs(stops);
  const auto at = [&](int stop) { return 2 * 3.14159265358979 * (stop * 7 % stops) / stops; };
  for (int from = 0; from < stops; ++from) {
    for (int to = 0; to < stops; ++to) {
      const double climb = std::sin(at(to)) - std::sin(at(from));
      costs.set(from, to, 2 * std::abs(std::sin((at(to) - at(from)) / 2)) * 10 + uphill * climb);
    }
  }
  for (int from = 0; from < stops; ++from) {
    for (int to = 0; to < stops; ++to) costs.set(from, to, std::max(0.0, costs(from, to)));
  }
  return costs;
}

TEST(PlanTour, GoesAroundACircleAndProvesIt) {
  const int stops = 60;
  const double around = stops * 2 * std::sin(3.14159265358979 / stops) * 10;
  const auto closed = plan_tour(circle(stops, 0), {.closed = true});
  ASSERT_TRUE(closed);
  EXPECT_NEAR(closed->cost, around, 1e-9);
  EXPECT_NEAR(closed->bound, around, 1e-6 * around);
  const auto open = plan_tour(circle(stops, 0));
  EXPECT_NEAR(open->cost, around * (stops - 1) / stops, 1e-9);
  // What goes up must come down: slopes change neither the best tour nor the bound.
  const auto hilly = plan_tour(circle(stops, 0.5), {.closed = true});
  EXPECT_NEAR(hilly->cost, around, 1e-9);
  EXPECT_GT(hilly->bound, 0.99 * around);
}

TEST(PlanTour, KeepsSwathsTogetherAmongManyStops) {
  CostMatrix costs = circle(80, 0);
  TourOptions options{.closed = true, .kicks = 500};
  for (int stop = 0; stop < 80; stop += 2) options.fixed.push_back({stop, stop + 1});
  for (const double uphill : {0.0, 0.5}) {
    const auto tour = plan_tour(circle(80, uphill), options);
    ASSERT_TRUE(tour) << tour.error().message;
    EXPECT_TRUE(is_allowed(options, tour->order));
    EXPECT_LE(tour->bound, tour->cost);
  }
}

TEST(PlanTour, NamesWhatContradicts) {
  const CostMatrix costs(4, 1.0);
  const auto refused = [&](const TourOptions& options) {
    const auto tour = plan_tour(costs, options);
    EXPECT_FALSE(tour);
    if (tour) return std::string();
    EXPECT_EQ(tour.error().status, Status::invalid_option);
    return tour.error().message;
  };
  EXPECT_EQ(refused({.start = 4}), "start: there is no stop 4; stops are 0 to 3");
  EXPECT_EQ(refused({.closed = true, .end = 1}), "end: a closed tour ends where it starts");
  EXPECT_EQ(refused({.start = 1, .end = 1}),
            "end: an open tour cannot end with the stop it starts with; ask for a closed one");
  EXPECT_EQ(refused({.before = {{2, 2}}}), "before: stop 2 is paired with itself");
  EXPECT_EQ(refused({.before = {{1, 2}, {2, 1}}}),
            "no order obeys all of start, end, before and fixed: they contradict each other");
  EXPECT_EQ(refused({.fixed = {{0, 1}, {1, 2}, {2, 0}}}),
            "fixed: the pairs form a ring that leaves stops out");
  EXPECT_EQ(refused({.fixed = {{0, 1}, {0, 2}, {0, 3}}}),
            "fixed: stop 0 cannot follow more than two others directly");
}

TEST(PlanTour, RefusesCostsThatAreNone) {
  EXPECT_EQ(plan_tour(CostMatrix()).error().message, "there are no stops to order");
  CostMatrix costs(3, 1.0);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    costs.set(1, 2, bad);
    EXPECT_EQ(plan_tour(costs).error().message,
              "the cost from stop 1 to stop 2 is negative or NaN");
  }
}

TEST(PlanTour, RefusesOrOrdersAbsurdCosts) {
  for (const double absurd : {1e300, 1.7e308, 1e149, 5e-324, 1e-200}) {
    for (const int stops : {5, 20}) {
      CostMatrix costs(stops, absurd);
      const auto tour = plan_tour(costs, {.closed = true});
      ASSERT_EQ(tour.has_value(), absurd <= 1e150);
      if (!tour) continue;
      EXPECT_TRUE(std::isfinite(tour->cost));
      EXPECT_GE(tour->bound, 0);
      EXPECT_LE(tour->bound, tour->cost);
    }
  }
}

TEST(PlanTour, OfOneStopOrEqualStopsCostsNothing) {
  EXPECT_EQ(plan_tour(CostMatrix(1))->order, std::vector<int>{0});
  EXPECT_EQ(plan_tour(CostMatrix(1), {.closed = true, .start = 0})->cost, 0);
  const auto tour = plan_tour(CostMatrix(40, 0.0));
  ASSERT_TRUE(tour);
  EXPECT_EQ(tour->cost, 0);
  EXPECT_EQ(tour->bound, 0);
}

TEST(PlanTour, StopsWhenItIsCancelledOrTimeEnds) {
  Random random(1);
  const CostMatrix costs = random_costs(random, 50, true, 0);
  std::atomic<bool> cancel = true;
  TourOptions options;
  options.limits.cancel = &cancel;
  const auto cancelled = plan_tour(costs, options);
  ASSERT_TRUE(cancelled) << "there is a first order";
  EXPECT_EQ(cancelled->status, Status::cancelled);
  options.limits = {};
  double now = 0;
  options.limits.seconds = 10;
  options.limits.clock = [&now] { return now += 0.01; };
  const auto timed = plan_tour(costs, options);
  ASSERT_TRUE(timed);
  EXPECT_EQ(timed->status, Status::time_limit);
  EXPECT_GT(timed->kicks, 100U);
  EXPECT_LT(timed->cost, cancelled->cost);
}

TEST(PlanTour, TellsEveryBetterOrder) {
  Random random(2);
  const CostMatrix costs = random_costs(random, 40, true, 0);
  std::vector<double> told;
  TourOptions options;
  options.improved = [&told](double cost, std::span<const int> /*order*/) { told.push_back(cost); };
  const auto tour = plan_tour(costs, options);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told, std::greater<>()));
  EXPECT_EQ(told.back(), tour->cost);
}

}  // namespace
}  // namespace wend
