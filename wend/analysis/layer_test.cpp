#include "wend/analysis/layer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/testing/drawn_map.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

constexpr std::string_view kLayerMap = R"(
..3..
.##.?
.....
)";
constexpr Cell kLayerStart{0, 0};
constexpr Cell kLayerGoal{3, 1};

/// A search on the map above, and all its layers.
class Layers : public ::testing::Test {
 protected:
  Layers()
      : space_(test::drawn_space(kLayerMap)),
        planner_(*make_planner("astar", space_, {{"connectivity", "4"}})),
        recorder_(space_) {
    Query query = Query::between(kLayerStart, kLayerGoal);
    query.observer = &recorder_;
    plan_ = *planner_->plan(query);
  }

  Layer of(LayerKind kind) const { return search_layer(kind, *planner_, recorder_); }

  template <class Check>
  void for_all_cells(Check&& check) const {
    for (int y = 0; y < space_.height(); ++y) {
      for (int x = 0; x < space_.width(); ++x) {
        SCOPED_TRACE(testing::Message() << x << "," << y);
        check(Cell{x, y});
      }
    }
  }

  FreeSpace space_;
  std::unique_ptr<Planner> planner_;
  SearchRecorder recorder_;
  Plan plan_;
};

TEST_F(Layers, OfTheOrderCountFromTheStart) {
  const Layer expansion = of(LayerKind::expansion);
  const Layer generation = of(LayerKind::generation);
  EXPECT_EQ(expansion.numbers[kLayerStart], 1);
  EXPECT_EQ(generation.numbers[kLayerStart], 1);
  EXPECT_EQ(expansion.numbers[kLayerGoal], static_cast<double>(plan_.metrics.expanded));
  for_all_cells([&](Cell cell) {
    EXPECT_EQ(std::isnan(expansion.numbers[cell]), recorder_.layers().expansion[cell] == 0);
    EXPECT_EQ(std::isnan(generation.numbers[cell]), recorder_.layers().generation[cell] == 0);
  });
}

TEST(LayersOfPoses, OfTheOrderHaveTheMotionsToEachExpansion) {
  const FreeSpace space = test::open_space(20, 20);
  const auto planner = *make_planner("hybrid_astar", space, {{"turning_radius", "2"}});
  SearchRecorder recorder(space);
  Query query{{3.5, 3.5, 0}, {Goal(Pose{15.5, 12.5, 2})}};
  query.observer = &recorder;
  const Plan plan = *planner->plan(query);
  const Layer order = search_layer(LayerKind::expansion, *planner, recorder);
  EXPECT_EQ(order.motions.size(), plan.metrics.expanded);
  ASSERT_FALSE(order.motions.empty());
  EXPECT_EQ(order.motions.branch(0).front(), query.start);
  EXPECT_TRUE(search_layer(LayerKind::g, *planner, recorder).motions.empty());
  recorder.clear();
  EXPECT_TRUE(recorder.motions().empty());
}

TEST_F(Layers, OnCellsHaveNoMotions) { EXPECT_TRUE(of(LayerKind::expansion).motions.empty()); }

TEST_F(Layers, ClosedAndFrontierShareOutTheReachedCells) {
  const Layer closed = of(LayerKind::closed);
  const Layer frontier = of(LayerKind::frontier);
  std::uint64_t reached = 0;
  for_all_cells([&](Cell cell) {
    if (!space_.passable(cell)) {
      EXPECT_TRUE(std::isnan(closed.numbers[cell]) && std::isnan(frontier.numbers[cell]));
      return;
    }
    const double sum = closed.numbers[cell] + frontier.numbers[cell];
    EXPECT_EQ(sum, recorder_.layers().generation[cell] != 0 ? 1 : 0);
    reached += sum > 0 ? 1 : 0;
  });
  EXPECT_EQ(reached, plan_.metrics.generated);
}

TEST_F(Layers, OfCostsAddUp) {
  const Layer g = of(LayerKind::g);
  const Layer h = of(LayerKind::heuristic);
  const Layer f = of(LayerKind::f);
  EXPECT_EQ(g.numbers[kLayerGoal], plan_.cost);
  for_all_cells([&](Cell cell) {
    if (!space_.passable(cell)) {
      EXPECT_TRUE(std::isnan(h.numbers[cell]));
      return;
    }
    // Of every cell, whether the search reached it or not.
    EXPECT_EQ(h.numbers[cell], std::abs(cell.x - kLayerGoal.x) + std::abs(cell.y - kLayerGoal.y));
    if (!std::isnan(g.numbers[cell])) {
      EXPECT_EQ(f.numbers[cell], g.numbers[cell] + h.numbers[cell]);
    }
  });
}

TEST_F(Layers, ParentsLeadBackAlongThePath) {
  const Layer parent = of(LayerKind::parent);
  EXPECT_TRUE(parent.numbers.empty());
  EXPECT_FALSE(parent.arrows[kLayerStart]);
  const auto cells = plan_.path.cells();
  for (std::size_t i = 1; i < cells.size(); ++i) {
    ASSERT_TRUE(parent.arrows[cells[i]]);
    EXPECT_EQ(step(cells[i], *parent.arrows[cells[i]]), cells[i - 1]);
  }
}

TEST_F(Layers, OfTheFieldAreItsCostsAndItsPolicy) {
  const auto field = CostToGo::make(space_, std::array{kLayerGoal});
  ASSERT_TRUE(field);
  const Layer cost = cost_to_go_layer(LayerKind::cost, space_, *field);
  const Layer policy = cost_to_go_layer(LayerKind::policy, space_, *field);
  EXPECT_EQ(cost.numbers[kLayerGoal], 0);
  for_all_cells([&](Cell cell) {
    if (space_.passable(cell)) {
      EXPECT_EQ(cost.numbers[cell], field->cost(cell));
    } else {
      EXPECT_TRUE(std::isnan(cost.numbers[cell]));
    }
    EXPECT_EQ(policy.arrows[cell], field->policy(cell));
  });
}

TEST_F(Layers, OfTheMapSayWhatItHolds) {
  const Layer occupied = map_layer(LayerKind::occupied, space_);
  EXPECT_EQ(occupied.numbers[kLayerStart], 0);
  EXPECT_EQ(occupied.numbers[(Cell{1, 1})], 1);
  EXPECT_TRUE(std::isnan(occupied.numbers[(Cell{4, 1})])) << "unknown is neither";
  const Layer terrain = map_layer(LayerKind::terrain, space_);
  EXPECT_EQ(terrain.numbers[kLayerStart], 1);
  EXPECT_EQ(terrain.numbers[(Cell{2, 0})], 3);
  EXPECT_TRUE(std::isnan(terrain.numbers[(Cell{1, 1})]));
  const Layer clearance = map_layer(LayerKind::clearance, space_);
  EXPECT_EQ(clearance.numbers[(Cell{1, 0})], 0.5);
  EXPECT_EQ(clearance.numbers[kLayerStart], std::hypot(0.5, 0.5));
}

TEST(LayerKinds, HaveTitlesAndSources) {
  for (const auto& choice : choice_names(LayerKind{})) {
    EXPECT_FALSE(title_of(choice.value).empty()) << choice.name;
  }
  EXPECT_EQ(source_of(LayerKind::parent), LayerSource::search);
  EXPECT_EQ(source_of(LayerKind::policy), LayerSource::cost_to_go);
  EXPECT_EQ(source_of(LayerKind::clearance), LayerSource::map);
}

}  // namespace
}  // namespace wend
