// The layers of a search against an independent replay of its events, and against what a reference
// says of the costs, for every planner.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "conformance/trial.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr std::uint64_t kSearches = 200;  // for each planner
constexpr double kRounding = 1e-9;

enum class Kind { generate, expand, relax };

struct Entry {
  Kind kind;
  SearchEvent event;
};

/// Keeps all events as they come, and passes them on.
class EventLog final : public SearchObserver {
 public:
  explicit EventLog(SearchObserver& next) : next_(next) {}

  void on_generate(const SearchEvent& event) override {
    entries_.push_back({Kind::generate, event});
    next_.on_generate(event);
  }
  void on_expand(const SearchEvent& event) override {
    entries_.push_back({Kind::expand, event});
    next_.on_expand(event);
  }
  void on_relax(const SearchEvent& event) override {
    entries_.push_back({Kind::relax, event});
    next_.on_relax(event);
  }

  const std::vector<Entry>& entries() const { return entries_; }

 private:
  SearchObserver& next_;
  std::vector<Entry> entries_;
};

/// What the events say, by sets and maps.
struct Replay {
  std::map<Cell, std::uint32_t> generation;
  std::map<Cell, std::uint32_t> expansion;
  std::map<Cell, SearchEvent> known;  // the last event that reached the cell
  std::set<Cell> open;
  std::vector<Cell> expansions;
  std::uint32_t generated = 0;  // states, each once

  /// Of several corners at a cell the cheapest counts.
  void learn(const SearchEvent& event) {
    const auto before = known.find(event.cell);
    if (event.heading && before != known.end() && before->second.g <= event.g) return;
    known.insert_or_assign(event.cell, event);
  }

  void apply(const Entry& entry) {
    const Cell cell = entry.event.cell;
    switch (entry.kind) {
      case Kind::generate:
        // A corner is a state of its own in its cell; without one, a walk came back to the cell.
        if (!entry.event.heading && generation.contains(cell)) return;
        ++generated;
        if (generation.emplace(cell, generated).second) open.insert(cell);
        learn(entry.event);
        return;
      case Kind::relax:
        learn(entry.event);
        return;
      case Kind::expand:
        expansions.push_back(cell);
        expansion.emplace(cell, expansions.size());
        open.erase(cell);
        return;
    }
  }
};

void expect_snapshot(const SearchSnapshot& snapshot, const Replay& replay) {
  ASSERT_EQ(snapshot.current.has_value(), !replay.expansions.empty());
  if (snapshot.current) {
    EXPECT_EQ(*snapshot.current, replay.expansions.back());
  }
  EXPECT_EQ(snapshot.expanded.count(), replay.expansion.size());
  EXPECT_EQ(snapshot.frontier.count(), replay.open.size());
  for (const auto& [cell, order] : replay.expansion) EXPECT_TRUE(snapshot.expanded[cell]);
  for (const Cell cell : replay.open) EXPECT_TRUE(snapshot.frontier[cell]);
}

/// Every snapshot, from before the first expansion to the end. Returns the replay at the end.
Replay expect_snapshots(const SearchRecorder& recorder, const std::vector<Entry>& entries) {
  Replay replay;
  for (const Entry& entry : entries) {
    if (entry.kind == Kind::expand) {
      expect_snapshot(recorder.snapshot(replay.expansions.size()), replay);
    }
    replay.apply(entry);
  }
  expect_snapshot(recorder.snapshot(), replay);
  EXPECT_EQ(recorder.expansions(), replay.expansions);
  return replay;
}

template <class Visit>
void for_all_cells(const FreeSpace& space, Visit&& visit) {
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) visit(Cell{x, y});
  }
}

void expect_layers(const SearchLayers& layers, const Replay& replay, const FreeSpace& space) {
  const auto order_of = [](const auto& orders, Cell cell) {
    const auto found = orders.find(cell);
    return found == orders.end() ? 0U : found->second;
  };
  for_all_cells(space, [&](Cell cell) {
    EXPECT_EQ(layers.generation[cell], order_of(replay.generation, cell));
    EXPECT_EQ(layers.expansion[cell], order_of(replay.expansion, cell));
    const auto known = replay.known.find(cell);
    if (known == replay.known.end()) {
      EXPECT_TRUE(std::isnan(layers.g[cell]) && std::isnan(layers.h[cell]) &&
                  std::isnan(layers.f[cell]) && !layers.parent[cell]);
      return;
    }
    const SearchEvent& event = known->second;
    EXPECT_EQ(layers.g[cell], event.g);
    EXPECT_EQ(layers.h[cell], event.h);
    EXPECT_EQ(layers.f[cell], event.f);
    ASSERT_EQ(layers.parent[cell].has_value(), event.parent.has_value());
    if (event.parent) {
      EXPECT_EQ(*layers.parent[cell], nearest_direction(cell, *event.parent));
    }
  });
}

/// The parents lead back to the start, and g grows on the way by what the steps cost.
void expect_true_costs(const SearchLayers& layers, const Planner& planner, const PlannerInfo& info,
                       const Reference& reference) {
  const FreeSpace& space = planner.free_space();
  for_all_cells(space, [&](Cell cell) {
    if (std::isnan(layers.g[cell])) return;
    const bool at_corners = info.capabilities.any_angle && info.capabilities.jumps;
    EXPECT_NEAR(layers.h[cell], planner.heuristic(cell), at_corners ? 1 : kRounding);
    const bool jumps = jumps_on(space.uniform_terrain(), info.capabilities);
    const bool by_steps = !jumps && !info.capabilities.any_angle;
    if (!layers.parent[cell] || info.guarantee == Guarantee::none || !by_steps) return;
    const Cell parent = step(cell, *layers.parent[cell]);
    EXPECT_TRUE(reference.is_step(parent, cell));
    const double cost = info.capabilities.terrain
                            ? reference.step_cost(parent, cell)
                            : std::hypot(parent.x - cell.x, parent.y - cell.y);
    // On cells with costs, g is a sum of CostUnits.
    const double slack = space.uniform_terrain() ? kRounding : 1.6e-6;
    const double through = layers.g[parent] + cost;
    if (planner.anytime()) {  // the parent may have become cheaper since
      EXPECT_GE(layers.g[cell], through - slack * (1 + through));
    } else {
      EXPECT_NEAR(layers.g[cell], through, slack * (1 + layers.g[cell]));
    }
  });
}

class SearchRecorderOf : public ::testing::TestWithParam<std::string> {};

TEST_P(SearchRecorderOf, AgreesWithAReplayOfTheEvents) {
  const PlannerInfo& info = *planners().find(GetParam());
  int searches = 0;
  for (std::uint64_t seed = 1; seed <= kSearches; ++seed) {
    const Trial trial = random_trial(seed, info);
    SCOPED_TRACE(text_of(trial, seed));
    const FreeSpace space = *make_free_space(trial.map, trial.robot);
    const auto planner = info.make(space, trial.options);
    if (!planner && planner.error().status == Status::unsupported_map) continue;
    ASSERT_TRUE(planner);
    Random random(seed);
    const TestQuery test_query = random_test_query(random, trial.map);
    SCOPED_TRACE(text_of(test_query));
    SearchRecorder recorder(space);
    EventLog log(recorder);
    Query query = test_query.query();
    query.limits.expansions = static_cast<std::uint64_t>(random.between(0, 200));
    query.observer = &log;
    Plan plan;
    (*planner)->plan(query, plan);

    const Replay replay = expect_snapshots(recorder, log.entries());
    EXPECT_EQ(replay.expansions.size(), plan.metrics.expanded);
    if (log.entries().empty()) continue;
    ++searches;
    expect_layers(recorder.layers(), replay, space);
    expect_true_costs(recorder.layers(), **planner, info, reference_for(trial, info));
    if (HasFailure()) return;
  }
  EXPECT_GT(searches, static_cast<int>(kSearches / 10)) << "too few searches began to say anything";
}

TEST_P(SearchRecorderOf, ForgetsTheLastSearchWhenCleared) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(7, 5, CellState::free)));
  const auto record = [&](SearchRecorder& recorder, Cell start, Cell goal) {
    const auto planner = make_planner(GetParam(), space);
    ASSERT_TRUE(planner);
    Query query = Query::between(start, goal);
    query.observer = &recorder;
    ASSERT_TRUE((*planner)->plan(query));
  };
  SearchRecorder used(space);
  record(used, {6, 4}, {0, 0});
  used.clear();
  EXPECT_EQ(used.snapshot().expanded.count() + used.snapshot().frontier.count(), 0U);
  record(used, {0, 0}, {3, 2});
  SearchRecorder fresh(space);
  record(fresh, {0, 0}, {3, 2});
  EXPECT_EQ(used.expansions(), fresh.expansions());
  EXPECT_EQ(used.layers().generation, fresh.layers().generation);
  EXPECT_EQ(used.layers().expansion, fresh.layers().expansion);
}

/// Those that search, and do not look answers up in an index.
std::vector<std::string> searching_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (!info.capabilities.headings && !info.index_support) names.push_back(info.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Planners, SearchRecorderOf, ::testing::ValuesIn(searching_planners()),
                         [](const auto& param) { return param.param; });

}  // namespace
}  // namespace wend::test
