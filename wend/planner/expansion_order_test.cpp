// Golden orders of expansion on a small map, drawn as numbers: they are the same on every platform,
// and a change of a rule of order (successors, ties, duplicates) shows here.
//
// From 1, the start, on; '#' is blocked, '.' was not expanded.

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>

#include "tests/testing/drawn_map.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

constexpr std::string_view kMap = R"(
.......
.###...
...#.#.
.#...#.
.....#.
)";
constexpr Cell kStart{0, 2};
constexpr Cell kGoal{6, 4};

class OrderRecorder final : public SearchObserver {
 public:
  explicit OrderRecorder(const FreeSpace& space) : order_(space.width(), space.height(), 0) {}

  void on_generate(const SearchEvent&) override {}
  void on_expand(const SearchEvent& event) override { order_[event.cell] = ++count_; }
  void on_relax(const SearchEvent&) override {}

  const Grid<int>& order() const { return order_; }

 private:
  Grid<int> order_;
  int count_ = 0;
};

std::string drawn_order(const FreeSpace& space, const Grid<int>& order) {
  std::ostringstream text;
  text << '\n';
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      if (x > 0) text << ' ';
      if (order[{x, y}] > 0) {
        text << std::setw(2) << order[{x, y}];
      } else {
        text << (space.passable({x, y}) ? " ." : " #");
      }
    }
    text << '\n';
  }
  return text.str();
}

std::string order_of(std::string_view planner, const OptionValues& options = {}) {
  const FreeSpace space = test::drawn_space(kMap);
  OrderRecorder recorder(space);
  Query query = Query::between(kStart, kGoal);
  query.observer = &recorder;
  const auto made = make_planner(planner, space, options);
  EXPECT_TRUE(made && (*made)->plan(query));
  return drawn_order(space, recorder.order());
}

TEST(ExpansionOrder, OfBfs) {
  EXPECT_EQ(order_of("bfs"), R"(
 7 10 14 17 19 22 24
 4  #  #  # 20 21 23
 1  3  6  # 18  # 25
 2  #  9 13 16  # 26
 5  8 11 12 15  # 27
)");
  EXPECT_EQ(order_of("bfs", {{"connectivity", "4"}}), R"(
 7 10 13 16 19 21 23
 4  #  #  # 20 22 24
 1  3  6  # 18  # 25
 2  #  9 12 15  # 26
 5  8 11 14 17  # 27
)");
}

TEST(ExpansionOrder, OfDfs) {
  EXPECT_EQ(order_of("dfs"), R"(
 3  4  5  6  7  8  9
 2  #  #  #  .  . 10
 1  .  .  #  .  # 11
 .  #  .  .  .  # 12
 .  .  .  .  .  # 13
)");
  EXPECT_EQ(order_of("dfs", {{"connectivity", "4"}}), R"(
 3  4  5  6  7  8  9
 2  #  #  #  .  . 10
 1  .  .  #  .  # 11
 .  #  .  .  .  # 12
 .  .  .  .  .  # 13
)");
}

TEST(ExpansionOrder, OfGreedy) {
  EXPECT_EQ(order_of("greedy"), R"(
 .  .  .  .  .  .  .
 .  #  #  # 10 11 12
 1  2  3  #  8  # 13
 .  #  4  9  7  # 14
 .  .  .  5  6  # 15
)");
  EXPECT_EQ(order_of("greedy", {{"connectivity", "4"}}), R"(
 .  .  .  .  .  .  .
 .  #  #  # 10 11 12
 1  2  3  #  8  # 13
 .  #  4  5  6  # 14
 .  .  .  9  7  # 15
)");
}

TEST(ExpansionOrder, OfDijkstra) {
  EXPECT_EQ(order_of("dijkstra"), R"(
 7  8 13 15 19 20 23
 2  #  #  # 21 22 24
 1  3  6  # 18  # 25
 4  #  9 11 16  # 26
 5 10 12 14 17  # 27
)");
  EXPECT_EQ(order_of("dijkstra", {{"connectivity", "4"}}), R"(
 7  8 13 14 19 20 22
 2  #  #  # 21 23 24
 1  3  6  # 17  # 25
 4  #  9 11 15  # 26
 5 10 12 16 18  # 27
)");
}

TEST(ExpansionOrder, OfAStar) {
  EXPECT_EQ(order_of("astar"), R"(
15 16 17 18 20  .  .
13  #  #  # 19 21 22
 1  2  3  # 14  # 23
 9  #  4  7  8  # 24
11 12 10  5  6  # 25
)");
  EXPECT_EQ(order_of("astar", {{"connectivity", "4"}}), R"(
 .  .  .  .  .  .  .
14  #  #  # 15 16 17
 1  2  3  # 13  # 18
10  #  4  5  6  # 19
11 12  9  8  7  # 20
)");
  EXPECT_EQ(order_of("astar", {{"weight", "3"}}), R"(
 .  .  .  .  .  .  .
 .  #  #  # 11 12 13
 1  2  3  #  9  # 14
 .  #  4  8  7  # 15
 .  . 10  5  6  # 16
)");
}

}  // namespace
}  // namespace wend
