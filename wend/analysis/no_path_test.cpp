#include "wend/analysis/no_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// "unknown", "squeeze+smaller", ...; "nothing" for a way without changes.
std::string text_of(bool unknown_free, bool squeeze, bool smaller_robot) {
  std::string text;
  if (unknown_free) text += "unknown+";
  if (squeeze) text += "squeeze+";
  if (smaller_robot) text += "smaller+";
  if (text.empty()) return "nothing";
  text.pop_back();
  return text;
}

std::vector<std::string> names_of(const std::vector<Way>& ways) {
  std::vector<std::string> names;
  names.reserve(ways.size());
  for (const Way& way : ways) {
    names.push_back(text_of(way.unknown_free, way.squeeze, way.smaller_robot));
  }
  return names;
}

constexpr GridMoves kFour{Connectivity::four, CornerRule::none};
constexpr GridMoves kOne{Connectivity::eight, CornerRule::one};
constexpr GridMoves kBoth{Connectivity::eight, CornerRule::both};

TEST(NoPath, SaysHowWideTheDoorIs) {
  const FreeSpace space =
      test::drawn_space("...#...\n.......\n...#...", {.footprint = Footprint::disc(0.75)});
  const NoPath why = explain_no_path(space, {0, 1}, {6, 1});
  EXPECT_THAT(names_of(why.ways), ElementsAre("smaller"));
  EXPECT_EQ(why.ways.front().widest.radius, 0.5);
  EXPECT_EQ(why.ways.front().widest.narrowest, (Point{3.5, 1.5}));
  ASSERT_TRUE(why.widest);
  EXPECT_EQ(why.widest->radius, 0.5);
  EXPECT_EQ(why.start_component, 6U) << "two columns of three";
  EXPECT_EQ(why.goal_component, 6U);
}

TEST(NoPath, SaysThatUnknownCellsAreInTheWay) {
  const FreeSpace space = test::drawn_space("..?..\n..?..");
  const NoPath why = explain_no_path(space, {0, 0}, {4, 0});
  EXPECT_THAT(names_of(why.ways), ElementsAre("unknown"));
  EXPECT_EQ(why.ways.front().widest.radius, test::kInfinite);
  EXPECT_EQ(why.ways.front().widest.path.size(), 5U);
  EXPECT_FALSE(why.widest);
}

TEST(NoPath, SaysThatTheRobotWouldHaveToSqueeze) {
  const FreeSpace space = test::drawn_space("..#\n.#.\n#..");
  for (const GridMoves moves : {GridMoves{}, kFour, kOne}) {
    const NoPath why = explain_no_path(space, {0, 0}, {2, 2}, moves);
    EXPECT_THAT(names_of(why.ways), ElementsAre("squeeze"))
        << "neither more neighbours nor one corner help";
    EXPECT_EQ(why.ways.front().widest.radius, 0) << "only a point gets between two corners";
    EXPECT_EQ(why.start_component, 3U);
  }
}

/// A disc of sqrt(2) cells fits between the corners (5,3) and (3,5), one of sqrt(1/2) onto the cells
/// beside the step from (3,3) to (4,4).
TEST(NoPath, ADiscSqueezesOnlyWhereItFits) {
  const auto explained = [](double radius, GridMoves moves) {
    const std::string_view map =
        ".....###\n.....###\n.....###\n........\n"
        "........\n###.....\n###.....\n###.....";
    const FreeSpace space = test::drawn_space(map, {.footprint = Footprint::disc(radius)});
    return explain_no_path(space, {1, 1}, {6, 6}, moves);
  };
  EXPECT_THAT(names_of(explained(0.7, {}).ways), ElementsAre("nothing"));
  EXPECT_THAT(names_of(explained(1.5, {}).ways), ElementsAre("smaller"));
  EXPECT_THAT(names_of(explained(1, kBoth).ways), ElementsAre("nothing"));
  const NoPath why = explained(1, {});
  ASSERT_THAT(names_of(why.ways), ElementsAre("squeeze", "smaller"));
  EXPECT_DOUBLE_EQ(why.ways[0].widest.radius, std::sqrt(2));
  EXPECT_EQ(why.ways[0].widest.narrowest, (Point{4, 4}));
  EXPECT_DOUBLE_EQ(why.ways[1].widest.radius, std::sqrt(0.5));
}

TEST(NoPath, SaysWhichTwoChangesAreNeededTogether) {
  // A band of unknown cells, and behind it a door that is too narrow.
  const FreeSpace space =
      test::drawn_space("..?..#..\n..?.....\n..?..#..", {.footprint = Footprint::disc(0.75)});
  const NoPath why = explain_no_path(space, {0, 1}, {7, 1});
  EXPECT_THAT(names_of(why.ways), ElementsAre("unknown+smaller"));
  EXPECT_EQ(why.ways.front().widest.radius, 0.5);
  EXPECT_FALSE(why.widest);
}

TEST(NoPath, NamesEveryWayThatHelps) {
  // Through the unknown cells, or between the corners of two obstacles.
  const FreeSpace space = test::drawn_space("..#\n.#.\n?..");
  EXPECT_THAT(names_of(explain_no_path(space, {0, 0}, {2, 2}).ways),
              ElementsAre("unknown", "squeeze"));
}

TEST(NoPath, KnowsNoWayIntoASealedRoom) {
  const FreeSpace space =
      test::drawn_space(".....\n.###.\n.#.#.\n.###.\n...?.", {.footprint = Footprint::disc(0.5)});
  const NoPath why = explain_no_path(space, {0, 0}, {2, 2});
  EXPECT_THAT(why.ways, IsEmpty());
  EXPECT_FALSE(why.widest);
  EXPECT_EQ(why.start_component, 15U);
  EXPECT_EQ(why.goal_component, 1U);
}

TEST(NoPath, SaysWhatWouldFreeAnEnd) {
  const FreeSpace space = test::drawn_space("#....?", {.footprint = Footprint::disc(1)});
  EXPECT_THAT(names_of(explain_no_path(space, {0, 0}, {3, 0}).ways), IsEmpty()) << "an obstacle";
  const NoPath too_close = explain_no_path(space, {3, 0}, {1, 0});
  EXPECT_THAT(names_of(too_close.ways), ElementsAre("smaller"));
  EXPECT_EQ(too_close.goal_component, 0U);
  EXPECT_THAT(names_of(explain_no_path(space, {3, 0}, {5, 0}).ways), ElementsAre("unknown"));
  EXPECT_THAT(names_of(explain_no_path(space, {1, 0}, {5, 0}).ways),
              ElementsAre("unknown+smaller"));
}

TEST(NoPath, OfAPathNeedsNoChange) {
  const NoPath why = explain_no_path(test::open_space(3, 3), {0, 0}, {2, 2});
  EXPECT_THAT(names_of(why.ways), ElementsAre("nothing"));
  EXPECT_EQ(why.start_component, 9U);
}

/// Is there a path by the reference under these changes? A smaller robot is a point.
bool path_by_the_reference(const GridMap& map, test::Robot robot, GridMoves moves, Cell start,
                           Cell goal, const Way& changes) {
  robot.enters_unknown |= changes.unknown_free;
  if (changes.squeeze) moves = kBoth;
  if (changes.smaller_robot) robot.radius = 0;
  const test::Reference book(
      map, robot, {moves.connectivity == Connectivity::eight, static_cast<int>(moves.corner_rule)});
  return book.costs_from(start)[book.number(goal)] < test::kInfinite;
}

Way changes_of(unsigned bits) {
  Way way;
  way.unknown_free = (bits & 1U) != 0;
  way.squeeze = (bits & 2U) != 0;
  way.smaller_robot = (bits & 4U) != 0;
  return way;
}

/// The names of the minimal sets of changes under which the reference finds a path.
std::vector<std::string> minimal_changes(const std::vector<bool>& has_path) {
  std::vector<std::string> names;
  for (unsigned bits = 0; bits < has_path.size(); ++bits) {
    bool minimal = has_path[bits];
    for (unsigned part = 0; part < bits; ++part) {
      if ((part & bits) == part && has_path[part]) minimal = false;
    }
    const Way way = changes_of(bits);
    if (minimal) names.push_back(text_of(way.unknown_free, way.squeeze, way.smaller_robot));
  }
  return names;
}

TEST(NoPath, NamesTheMinimalChangesThatMakeAPath) {
  int with_ways = 0;
  int with_two_changes = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(1500U) && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 9), random.between(1, 9));
    const FreeSpaceOptions options = test::random_robot(random, map.frame().resolution);
    const FreeSpace space = *make_free_space(map, options);
    const GridMoves moves{random.chance(0.8) ? Connectivity::eight : Connectivity::four,
                          static_cast<CornerRule>(random.between(0, 2))};
    const test::Robot robot = test::robot_in_cells(options, map.frame());
    const Cell start = test::random_cell(random, map.width(), map.height());
    const Cell goal = test::random_cell(random, map.width(), map.height());
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));

    const NoPath why = explain_no_path(space, start, goal, moves);
    std::vector<bool> has_path;
    for (unsigned bits = 0; bits < 8; ++bits) {
      has_path.push_back(path_by_the_reference(map, robot, moves, start, goal, changes_of(bits)));
    }
    ASSERT_THAT(names_of(why.ways),
                ::testing::UnorderedElementsAreArray(minimal_changes(has_path)));
    ASSERT_EQ(why.widest.has_value(), has_path[4]);
    const auto count = [](const Way& way) {
      return int{way.unknown_free} + int{way.squeeze} + int{way.smaller_robot};
    };
    ASSERT_TRUE(std::is_sorted(why.ways.begin(), why.ways.end(), [&](const Way& a, const Way& b) {
      return count(a) < count(b);
    })) << "fewest changes first";
    for (const Way& way : why.ways) {
      with_two_changes += count(way) > 1 ? 1 : 0;
      ASSERT_EQ(way.widest.radius < robot.radius - 1e-7, way.smaller_robot);
      ASSERT_EQ(way.widest.path.cells().front(), start);
      ASSERT_EQ(way.widest.path.cells().back(), goal);
    }
    with_ways += !why.ways.empty() && !has_path[0] ? 1 : 0;
  }
  EXPECT_GT(with_ways, test::share_of(150));
  EXPECT_GT(with_two_changes, test::share_of(15));
}

/// The cells that the reference's robot can reach.
BitGrid reached_by_the_reference(const test::Reference& book, const GridMap& map, Cell from) {
  const std::vector<double> steps = book.steps_from(from);
  BitGrid reached(map.width(), map.height());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      reached.set({x, y}, steps[book.number({x, y})] < test::kInfinite);
    }
  }
  return reached;
}

TEST(NoPath, KnowsTheCellsThatEachEndReaches) {
  int labels_count_too_much = 0;
  for (std::uint64_t seed = 1; seed <= 1000 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 9), random.between(1, 9));
    const FreeSpaceOptions options = test::random_robot(random, map.frame().resolution);
    const bool eight = random.chance(0.8);
    const int corners = random.chance(0.6) ? 2 : random.between(0, 1);
    const GridMoves moves{eight ? Connectivity::eight : Connectivity::four,
                          static_cast<CornerRule>(corners)};
    const test::Reference book(map, test::robot_in_cells(options, map.frame()), {eight, corners});
    const FreeSpace space = *make_free_space(map, options);
    const Cell start = test::random_cell(random, map.width(), map.height());
    const Cell goal = test::random_cell(random, map.width(), map.height());
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    const NoPath why = explain_no_path(space, start, goal, moves);
    const BitGrid reached = reached_by_the_reference(book, map, start);
    ASSERT_TRUE(component_of(space, start, moves) == reached);
    ASSERT_EQ(component_size(space, start, moves), reached.count());
    ASSERT_EQ(why.start_component, reached.count());
    ASSERT_EQ(why.goal_component, reached_by_the_reference(book, map, goal).count());
    const auto by_labels = space.components().size_of_component(start, moves.adjacency());
    labels_count_too_much += by_labels > reached.count() ? 1 : 0;
  }
  EXPECT_GT(labels_count_too_much, 5) << "discs that do not fit between two corners";
}

}  // namespace
}  // namespace wend
