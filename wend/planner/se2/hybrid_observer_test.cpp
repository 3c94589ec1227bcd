// What hybrid_astar tells an observer: what it drives to each pose, which is free; and nothing changes.

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// Looks at every event while it is told.
class WayWatcher final : public SearchObserver {
 public:
  WayWatcher(const FreeSpace& space, double radius) : space_(space), radius_(radius) {}

  void on_generate(const SearchEvent& event) override {
    look_at(event);
    reached_.insert(key_of(event.way.back()));
    if (!event.parent) return;
    EXPECT_TRUE(reached_.contains(key_of(event.way.front()))) << "from a pose that was reached";
  }
  void on_expand(const SearchEvent& event) override {
    ++expanded_;
    look_at(event);
    EXPECT_TRUE(reached_.contains(key_of(event.way.back()))) << "was reached before";
  }
  void on_relax(const SearchEvent& /*event*/) override {}

  std::uint64_t expanded() const { return expanded_; }
  int curves() const { return curves_; }

 private:
  using Key = std::tuple<double, double, double>;
  static Key key_of(const Pose& pose) { return {pose.x, pose.y, pose.heading}; }

  void look_at(const SearchEvent& event) {
    ASSERT_FALSE(event.way.empty());
    EXPECT_EQ(event.cell, cell_at(event.way.back().point()));
    EXPECT_EQ(event.heading, event.way.back().heading);
    EXPECT_EQ(event.parent.has_value(), event.way.size() > 1);
    const Path way = Path::through({event.way.begin(), event.way.end()});
    EXPECT_FALSE(first_collision(way, space_));
    EXPECT_GE(measure(way, space_)->smallest_turning_radius, radius_ * (1 - 1e-6));
    if (!event.parent) return;
    EXPECT_EQ(*event.parent, cell_at(event.way.front().point()));
    EXPECT_EQ(event.parent_heading, event.way.front().heading);
    if (event.way.size() > 2) ++curves_;
  }

  const FreeSpace& space_;
  double radius_;
  std::set<Key> reached_;
  std::uint64_t expanded_ = 0;
  int curves_ = 0;
};

TEST(HybridAStarObserver, IsToldWhatIsDrivenAndChangesNothing) {
  constexpr double kTurnsIn = 3;
  int curves = 0;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Grid<CellState> states(30, 30, CellState::free);
    for (const Cell cell : every_cell(states)) {
      if (random.chance(0.03)) states[cell] = CellState::occupied;
    }
    const FreeSpace space = *make_free_space(
        *make_grid_map(states), {.footprint = *parse_footprint("1.4,0.8;-1,0.8;-1,-0.8;1.4,-0.8")});
    const auto planner = *make_planner("hybrid_astar", space, {{"turning_radius", "3"}});
    const Pose start{30 * random.uniform(), 30 * random.uniform(), 6 * random.uniform() - 3};
    const Pose goal{30 * random.uniform(), 30 * random.uniform(), 6 * random.uniform() - 3};
    Query query{start, {Goal(goal)}};
    const auto alone = planner->plan(query);
    WayWatcher watcher(space, kTurnsIn);
    query.observer = &watcher;
    const auto watched = planner->plan(query);
    ASSERT_EQ(alone.has_value(), watched.has_value());
    if (!alone) continue;
    EXPECT_EQ(alone->path, watched->path);
    EXPECT_EQ(alone->metrics.expanded, watched->metrics.expanded);
    EXPECT_EQ(watcher.expanded(), watched->metrics.expanded);
    curves += watcher.curves();
  }
  EXPECT_GT(curves, 20) << "connections of several motions";
}

}  // namespace
}  // namespace wend
