#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// Everywhere a walk has been, whether it got to its goal or not.
class Footprints final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& event) override { cells.push_back(event.cell); }
  void on_expand(const SearchEvent&) override {}
  void on_relax(const SearchEvent&) override {}
  std::vector<Cell> cells;
};

struct Walk {
  Status status;
  Plan plan;
  std::vector<Cell> cells;
};

Walk walk(const FreeSpace& space, Cell from, Cell to, std::int64_t max_steps,
          std::int64_t seed = 1) {
  const auto planner =
      make_planner("random_walk", space,
                   {{"max_steps", std::to_string(max_steps)}, {"seed", std::to_string(seed)}});
  Walk walk{};
  Footprints footprints;
  Query query = Query::between(from, to);
  query.observer = &footprints;
  walk.status = (*planner)->plan(query, walk.plan);
  walk.cells = footprints.cells;
  return walk;
}

std::vector<Cell> free_neighbours(const FreeSpace& space, Cell cell) {
  std::vector<Cell> neighbours;
  for (const Cell next : {Cell{cell.x, cell.y + 1}, Cell{cell.x + 1, cell.y},
                          Cell{cell.x, cell.y - 1}, Cell{cell.x - 1, cell.y}}) {
    if (space.passable(next)) neighbours.push_back(next);
  }
  return neighbours;
}

/// The cells that the last `steps` steps before step `now` came to; cells[i] is where step i ended.
std::span<const Cell> recent(std::span<const Cell> cells, std::size_t now, std::size_t steps) {
  const std::size_t first = now >= steps ? now - steps : 0;
  return cells.subspan(first, now - first);
}

bool contains(std::span<const Cell> cells, Cell cell) {
  return std::find(cells.begin(), cells.end(), cell) != cells.end();
}

/// Runs walks of many lengths on random maps and shows each to `check`.
template <class Check>
void on_random_walks(Check&& check) {
  for (std::uint64_t seed = 1; seed <= 400 && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const FreeSpace space = *make_free_space(test::random_map(random));
    const auto cell = [&] { return test::random_cell(random, space.width(), space.height()); };
    const Cell start = cell();
    const Cell goal = cell();
    const int max_steps = random.between(0, test::one_of(random, std::array{10, 60, 400}));
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(max_steps) +
                 " steps at most\n" + test::drawing_of(space.map()));
    const Walk walked = walk(space, start, goal, max_steps, static_cast<std::int64_t>(seed));
    if (!walked.cells.empty()) check(space, walked, max_steps);
  }
}

TEST(RandomWalk, TakesOrthogonalStepsAndNotTooMany) {
  int found = 0;
  int lost = 0;
  on_random_walks([&](const FreeSpace& space, const Walk& walked, int max_steps) {
    EXPECT_LE(walked.cells.size(), static_cast<std::size_t>(max_steps) + 1);
    for (std::size_t i = 1; i < walked.cells.size(); ++i) {
      ASSERT_TRUE(contains(free_neighbours(space, walked.cells[i - 1]), walked.cells[i]));
    }
    (walked.status == Status::found ? found : lost) += 1;
    if (walked.status == Status::found) {
      EXPECT_TRUE(std::ranges::equal(walked.plan.path.cells(), walked.cells));
      EXPECT_EQ(walked.plan.bound, Plan::kNoBound);
    } else {
      EXPECT_EQ(walked.status, Status::step_limit);
      EXPECT_EQ(walked.cells.size(), static_cast<std::size_t>(max_steps) + 1);
      EXPECT_TRUE(walked.plan.path.empty());
      EXPECT_EQ(walked.plan.metrics.expanded, walked.cells.size());
    }
  });
  EXPECT_GT(found, 20);
  EXPECT_GT(lost, 20);
}

/// It enters no cell visited in the last floor(sqrt(max_steps)) steps unless that is the only way.
TEST(RandomWalk, RemembersItsLastSteps) {
  int forced = 0;
  on_random_walks([&](const FreeSpace& space, const Walk& walked, int max_steps) {
    const auto memory = static_cast<std::size_t>(std::floor(std::sqrt(max_steps)));
    for (std::size_t step = 1; step < walked.cells.size(); ++step) {
      const auto visited = recent(walked.cells, step, memory);
      if (!contains(visited, walked.cells[step])) continue;
      ++forced;
      for (const Cell other : free_neighbours(space, walked.cells[step - 1])) {
        ASSERT_TRUE(contains(visited, other)) << "step " << step << " went back though (" << other.x
                                              << "," << other.y << ") was another way";
      }
    }
  });
  EXPECT_GT(forced, 50) << "too few dead ends to say anything";
}

/// What is older than that it does not remember: sooner or later it comes back.
TEST(RandomWalk, ForgetsWhatIsOlder) {
  int returns_at_once = 0;
  on_random_walks([&](const FreeSpace&, const Walk& walked, int max_steps) {
    const auto memory = static_cast<std::size_t>(std::floor(std::sqrt(max_steps)));
    for (std::size_t step = memory + 1; step < walked.cells.size(); ++step) {
      returns_at_once += walked.cells[step - memory - 1] == walked.cells[step] ? 1 : 0;
    }
  });
  EXPECT_GT(returns_at_once, 10);
}

TEST(RandomWalk, GoesBackWhereThatIsTheOnlyWay) {
  const FreeSpace dead_end = test::drawn_space("...\n##.\n...");
  const Walk walked = walk(dead_end, {0, 0}, {0, 2}, 10'000);
  EXPECT_EQ(walked.status, Status::found);
}

TEST(RandomWalk, OfTheSameSeedIsTheSameWalk) {
  const FreeSpace space = test::open_space(30, 30);
  const Walk first = walk(space, {0, 0}, {29, 29}, 100'000, 7);
  EXPECT_EQ(walk(space, {0, 0}, {29, 29}, 100'000, 7).cells, first.cells);
  EXPECT_NE(walk(space, {0, 0}, {29, 29}, 100'000, 8).cells, first.cells);
}

/// One walk written down: it is the same on every platform.
TEST(RandomWalk, IsTheSameEverywhere) {
  std::string steps;
  const Walk walked = walk(test::open_space(9, 9), {4, 4}, {0, 0}, 30, 1);
  for (std::size_t i = 1; i < walked.cells.size(); ++i) {
    const int dx = walked.cells[i].x - walked.cells[i - 1].x;
    const int dy = walked.cells[i].y - walked.cells[i - 1].y;
    steps += dx > 0 ? 'r' : dx < 0 ? 'l' : dy > 0 ? 'd' : 'u';
  }
  EXPECT_EQ(steps, "rrulluldlulurull");
}

TEST(RandomWalk, WithoutStepsReachesOnlyItsStart) {
  const FreeSpace space = test::open_space(3, 3);
  EXPECT_EQ(walk(space, {1, 1}, {1, 1}, 0).status, Status::found);
  EXPECT_EQ(walk(space, {1, 1}, {1, 2}, 0).status, Status::step_limit);
  EXPECT_EQ(walk(test::open_space(2, 1), {0, 0}, {1, 0}, 1).status, Status::found);
  EXPECT_EQ(walk(test::open_space(3, 1), {0, 0}, {2, 0}, 1).status, Status::step_limit);
}

TEST(RandomWalk, PaysForTheTerrainItCrosses) {
  const Walk walked = walk(test::drawn_space(".3."), {0, 0}, {2, 0}, 100);
  ASSERT_EQ(walked.status, Status::found);
  EXPECT_EQ(walked.plan.cost, 4);
}

}  // namespace
}  // namespace wend
