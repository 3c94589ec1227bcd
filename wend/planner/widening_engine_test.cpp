#include "wend/planner/widening_engine.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <vector>

namespace wend {
namespace {

using Engine = SearchEngine<int, int>;

/// What happened to an engine that does as it is told.
struct Record {
  int begun = 0;
  int start = 0;
  std::vector<int> goals;
  Limits limits;
  SearchObserver* observer = nullptr;
};

/// Ends after a given number of steps.
class ScriptedEngine final : public Engine {
 public:
  ScriptedEngine(Record& record, int steps, SearchOutcome end)
      : record_(record), steps_(steps), end_(end) {}

  bool allocated() const override { return true; }
  void begin(const int& start, std::span<const int> goals, const Limits& limits,
             SearchObserver* observer) override {
    ++record_.begun;
    record_.start = start;
    record_.goals.assign(goals.begin(), goals.end());
    record_.limits = limits;
    record_.observer = observer;
    metrics_ = {};
  }
  SearchOutcome step() override {
    ++metrics_.expanded;
    return metrics_.expanded < static_cast<std::uint64_t>(steps_) ? SearchOutcome::running : end_;
  }
  SearchOutcome run() override {
    while (step() == SearchOutcome::running) {
    }
    return end_;
  }
  const SearchMetrics& metrics() const override { return metrics_; }
  OpenList open_list(std::size_t most) const override { return {{}, most + metrics_.expanded}; }
  double heuristic(const int& place) const override { return place * steps_; }
  void write_path(Path& path) const override { path.append({steps_, 0}); }

 private:
  Record& record_;
  int steps_;
  SearchOutcome end_;
  SearchMetrics metrics_;
};

class NoWatcher final : public SearchObserver {
 public:
  void on_generate(const SearchEvent&) override {}
  void on_expand(const SearchEvent&) override {}
  void on_relax(const SearchEvent&) override {}
};

constexpr int kCompactSteps = 3;
constexpr int kWideSteps = 5;

class Widening : public ::testing::Test {
 protected:
  /// A compact engine that ends so, and a wide one that finds a goal.
  WideningEngine<Engine> engine_ending(SearchOutcome end) {
    return {[this, end] { return std::make_unique<ScriptedEngine>(compact_, kCompactSteps, end); },
            [this] {
              return std::make_unique<ScriptedEngine>(wide_, kWideSteps, SearchOutcome::found);
            }};
  }

  void begin(WideningEngine<Engine>& engine, SearchObserver* observer = nullptr) {
    engine.begin(7, std::vector<int>{8, 9}, limits_, observer);
  }

  Record compact_;
  Record wide_;
  Limits limits_;
};

TEST_F(Widening, StaysCompactWhileThatDoes) {
  for (const SearchOutcome end : {SearchOutcome::found, SearchOutcome::exhausted,
                                  SearchOutcome::time_limit, SearchOutcome::cancelled}) {
    auto engine = engine_ending(end);
    begin(engine);
    EXPECT_EQ(engine.run(), end);
    EXPECT_EQ(engine.metrics().expanded, 3U);
    EXPECT_EQ(engine.heuristic(1), kCompactSteps);
  }
  EXPECT_EQ(wide_.begun, 0);
}

TEST_F(Widening, BeginsAgainWhereCostsOutgrowTheirType) {
  auto engine = engine_ending(SearchOutcome::cost_overflow);
  limits_.expansions = 1000;
  begin(engine);
  EXPECT_EQ(engine.run(), SearchOutcome::found);
  EXPECT_EQ(wide_.begun, 1);
  EXPECT_EQ(wide_.start, 7);
  EXPECT_EQ(wide_.goals, (std::vector<int>{8, 9}));
  EXPECT_EQ(wide_.limits.expansions, 1000U);
  EXPECT_EQ(engine.metrics().expanded, 5U) << "of the search that counts";
  EXPECT_EQ(engine.heuristic(1), kWideSteps);
  Path path;
  engine.write_path(path);
  EXPECT_EQ(path.cells().front(), (Cell{kWideSteps, 0}));
}

TEST_F(Widening, IsWideFromThenOn) {
  auto engine = engine_ending(SearchOutcome::cost_overflow);
  for (int query = 1; query <= 3; ++query) {
    begin(engine);
    EXPECT_EQ(engine.run(), SearchOutcome::found);
    EXPECT_EQ(compact_.begun, 1);
    EXPECT_EQ(wide_.begun, query);
  }
}

TEST_F(Widening, StepsThroughBothSearches) {
  auto engine = engine_ending(SearchOutcome::cost_overflow);
  begin(engine);
  int steps = 1;
  while (engine.step() == SearchOutcome::running) ++steps;
  EXPECT_EQ(steps, kCompactSteps + kWideSteps);
}

/// Who watches must not see a search begin twice.
TEST_F(Widening, IsWideFromTheBeginningWhereSomebodyWatches) {
  auto engine = engine_ending(SearchOutcome::cost_overflow);
  NoWatcher watcher;
  begin(engine, &watcher);
  EXPECT_EQ(engine.run(), SearchOutcome::found);
  EXPECT_EQ(compact_.begun, 0);
  EXPECT_EQ(wide_.begun, 1);
  EXPECT_EQ(wide_.observer, &watcher);
}

TEST_F(Widening, LeavesTheSecondSearchTheTimeThatIsLeft) {
  double now = 100;
  limits_.clock = [&] { return now; };
  limits_.seconds = 10;
  auto engine = engine_ending(SearchOutcome::cost_overflow);
  begin(engine);
  EXPECT_EQ(engine.step(), SearchOutcome::running);
  now = 104;
  EXPECT_EQ(engine.run(), SearchOutcome::found);
  EXPECT_EQ(wide_.limits.seconds, 6);
}

}  // namespace
}  // namespace wend
