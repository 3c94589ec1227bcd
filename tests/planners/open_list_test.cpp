// The open list of a stepped search against the search itself: what it names first is what is
// expanded next, and what it names later keeps its order. For every planner that can be stepped.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/testing/car_trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr std::uint64_t kTrials = 150;  // for each planner
constexpr int kMostSteps = 120;
constexpr std::size_t kAll = 1'000'000;

using State = std::tuple<Cell, std::optional<double>, double>;  // with g

State state_of(const SearchEvent& event) { return {event.cell, event.heading, event.g}; }

std::vector<State> states_of(const OpenList& list) {
  std::vector<State> states;
  for (const OpenEntry& entry : list.entries) states.push_back(state_of(entry.state));
  return states;
}

/// Keeps what was expanded last, and how many states are open.
class Watcher final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& event) override { add(event); }
  void on_relax(const SearchEvent& event) override { add(event); }
  void on_expand(const SearchEvent& event) override { expanded_ = event; }

  const std::optional<SearchEvent>& expanded() const { return expanded_; }
  /// Those reached since the last call.
  std::vector<State> take_reached() { return std::exchange(reached_, {}); }

 private:
  void add(const SearchEvent& event) { reached_.push_back(state_of(event)); }

  std::optional<SearchEvent> expanded_;
  std::vector<State> reached_;
};

void expect_ties_say_what_decides(const OpenList& list, bool jumps) {
  for (std::size_t i = 1; i < list.entries.size(); ++i) {
    const SearchEvent& before = list.entries[i - 1].state;
    const OpenEntry& entry = list.entries[i];
    if (entry.tie == OpenTie::none || jumps) continue;
    EXPECT_NEAR(entry.state.f, before.f, 1e-6);
    if (entry.tie == OpenTie::g) {
      EXPECT_GT(before.g + 1e-9, entry.state.g);
    } else if (entry.tie == OpenTie::newest) {
      EXPECT_NEAR(before.g, entry.state.g, 1e-6);
    }
  }
}

/// Without what was reached meanwhile, a list is the one before without its first entry. A planner
/// that jumps drops entries that have become useless.
void expect_same_order(const std::vector<State>& before, const std::vector<State>& now,
                       const std::vector<State>& reached, bool may_drop) {
  const auto is_in = [](const std::vector<State>& states, const State& state) {
    return std::find(states.begin(), states.end(), state) != states.end();
  };
  std::vector<State> kept;
  for (const State& state : now) {
    if (is_in(before, state) && !is_in(reached, state)) kept.push_back(state);
  }
  std::vector<State> expected;
  for (std::size_t i = 1; i < before.size(); ++i) {
    if (is_in(reached, before[i]) || (may_drop && !is_in(now, before[i]))) continue;
    const auto is_cheaper = [&](const State& state) {
      return std::get<Cell>(state) == std::get<Cell>(before[i]) &&
             std::get<1>(state) == std::get<1>(before[i]);
    };
    if (std::none_of(reached.begin(), reached.end(), is_cheaper)) expected.push_back(before[i]);
  }
  EXPECT_EQ(kept, expected);
}

class OpenListOf : public ::testing::TestWithParam<std::string> {
 protected:
  const PlannerInfo& info() const { return *planners().find(GetParam()); }

  /// Steps through a search; the number of steps.
  int expect_true_lists(Planner& planner, Query query) const {
    Watcher watcher;
    query.observer = &watcher;
    Plan plan;
    auto outcome = planner.begin(query, plan);
    int steps = 0;
    while (!outcome && steps < kMostSteps) {
      const OpenList list = planner.open_list(kAll);
      const OpenList next = planner.open_list(3);
      EXPECT_EQ(list.count, list.entries.size());
      EXPECT_EQ(next.count, list.count);
      EXPECT_EQ(next.entries.size(), std::min<std::size_t>(3, list.count));
      const bool jumps = jumps_on(planner.free_space().uniform_terrain(), info().capabilities);
      expect_ties_say_what_decides(list, jumps);
      watcher.take_reached();
      const double bound = plan.bound;
      outcome = planner.step(plan);
      if (list.entries.empty()) {
        EXPECT_TRUE(outcome) << "there is nothing to expand";
        EXPECT_EQ(plan.metrics.expanded, static_cast<std::uint64_t>(steps));
        break;
      }
      EXPECT_EQ(watcher.expanded()->cell, list.entries.front().state.cell) << "after " << steps;
      // Lazy Theta* chooses the parent of a cell, and so its g, when it expands the cell.
      if (!info().capabilities.any_angle) {
        EXPECT_EQ(state_of(*watcher.expanded()), state_of(list.entries.front().state))
            << "after " << steps << " expansions";
      }
      EXPECT_EQ(state_of(next.entries.front().state), state_of(list.entries.front().state));
      // The order of an anytime planner is another one for each weight.
      const bool ordered_anew = planner.anytime() && plan.bound != bound;
      if (info().guarantee != Guarantee::none && !outcome && !ordered_anew) {
        expect_same_order(states_of(list), states_of(planner.open_list(kAll)),
                          watcher.take_reached(), jumps);
      }
      ++steps;
      if (HasFailure()) break;
    }
    return steps;
  }
};

TEST_P(OpenListOf, NamesWhatIsExpandedNextInOrder) {
  int steps = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(kTrials) && !HasFailure(); ++seed) {
    const bool car = info().capabilities.vertices == Vertices::corners;
    const Trial trial = car ? random_car_trial(seed, info()) : random_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = info().make(*make_free_space(trial.map, trial.robot), trial.options);
    if (!planner) continue;  // such a map, or such options on it
    Random random(seed);
    for (int i = 0; i < 3; ++i) {
      const Query query = car ? random_drive(random, car_reference_for(trial, info()))
                              : random_test_query(random, trial.map).query();
      SCOPED_TRACE(text_of(query));
      steps += expect_true_lists(**planner, query);
    }
  }
  EXPECT_GT(steps, test::share_of(50)) << "too few steps to say anything";
}

TEST_P(OpenListOf, IsTheStartBeforeTheFirstStep) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(7, 5, CellState::free)));
  const auto planner = make_planner(GetParam(), space);
  ASSERT_TRUE(planner);
  Plan plan;
  ASSERT_FALSE((*planner)->begin(Query{{2.5, 1.5, 0}, {Pose{6.5, 4.5, 0}}}, plan));
  const OpenList list = (*planner)->open_list(10);
  ASSERT_EQ(list.entries.size(), 1U);
  EXPECT_EQ(list.count, 1U);
  EXPECT_EQ(list.entries.front().state.g, 0);
  EXPECT_FALSE(list.entries.front().state.parent);
  EXPECT_EQ((*planner)->open_list(0).count, 1U);
}

std::vector<std::string> steppable_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (info.capabilities.can_step) names.push_back(info.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Planners, OpenListOf, ::testing::ValuesIn(steppable_planners()),
                         [](const auto& param) { return param.param; });

/// By hand: around a start in the open A* has eight neighbours, the straight one ahead first.
TEST(OpenList, SaysWhatDecidesBetweenEqualEntries) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(9, 5, CellState::free)));
  const auto planner = make_planner("astar", space);
  Plan plan;
  ASSERT_FALSE((*planner)->begin(Query::between({4, 2}, {8, 2}), plan));
  ASSERT_FALSE((*planner)->step(plan));
  const OpenList list = (*planner)->open_list(10);
  ASSERT_EQ(list.count, 8U);
  EXPECT_EQ(list.entries[0].state.cell, (Cell{5, 2}));
  EXPECT_EQ(list.entries[0].state.parent, (Cell{4, 2}));
  EXPECT_EQ(list.entries[0].tie, OpenTie::none);
  EXPECT_EQ(list.entries[1].tie, OpenTie::none) << "the diagonals have a larger f";
  EXPECT_EQ(list.entries[2].tie, OpenTie::newest) << "and one another's f and g";
}

}  // namespace
}  // namespace wend::test
