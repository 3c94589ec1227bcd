#include "wend/base/registry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace wend {
namespace {

struct Tool {
  std::string name;
  int size;
};

const Registry<Tool>& tools() {
  static const Registry<Tool> registry({{"hammer", 3}, {"saw", 5}, {"chisel", 1}});
  return registry;
}

TEST(Registry, FindsEntriesByName) {
  for (const Tool& tool : tools()) {
    ASSERT_NE(tools().find(tool.name), nullptr);
    EXPECT_EQ(tools().find(tool.name)->size, tool.size);
  }
  EXPECT_EQ(tools().find("drill"), nullptr);
  EXPECT_EQ(tools().find("Hammer"), nullptr);
  EXPECT_EQ(tools().find(""), nullptr);
}

TEST(Registry, KeepsTheOrderOfItsEntries) {
  EXPECT_EQ(tools().size(), 3U);
  EXPECT_EQ(tools().names(), (std::vector<std::string>{"hammer", "saw", "chisel"}));
}

TEST(Registry, SuggestsTheNameThatWasMeant) {
  EXPECT_EQ(tools().unknown("tool", "hamer"), "there is no tool 'hamer': did you mean 'hammer'?");
}

TEST(Registry, ListsAllNamesWhereNoneIsNear) {
  EXPECT_EQ(tools().unknown("tool", "drill"),
            "there is no tool 'drill': choose from hammer, saw, chisel");
}

const std::vector<std::string> kPlanners{"bfs",      "dfs",   "greedy",
                                         "dijkstra", "astar", "random_walk"};

/// The edit distance by its recursive definition.
std::size_t edits(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return std::max(a.size(), b.size());
  if (a.front() == b.front()) return edits(a.substr(1), b.substr(1));
  std::size_t least =
      std::min({edits(a.substr(1), b), edits(a, b.substr(1)), edits(a.substr(1), b.substr(1))});
  const bool swapped = a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0];
  if (swapped) least = std::min(least, edits(a.substr(2), b.substr(2)));
  return 1 + least;
}

TEST(ClosestName, FindsMisspeltNames) {
  EXPECT_EQ(closest_name("astr", kPlanners), "astar");
  EXPECT_EQ(closest_name("a-star", kPlanners), "astar");
  EXPECT_EQ(closest_name("djikstra", kPlanners), "dijkstra");
  EXPECT_EQ(closest_name("randomwalk", kPlanners), "random_walk");
  EXPECT_EQ(closest_name("plna", std::vector<std::string>{"plan"}), "plan");
  EXPECT_EQ(closest_name("bsf", std::vector<std::string>{"bfs"}), "bfs");
  EXPECT_EQ(closest_name("sfb", std::vector<std::string>{"bfs"}), std::nullopt);  // two of three
}

TEST(ClosestName, FindsNothingWhereMoreThanAThirdDiffers) {
  EXPECT_EQ(closest_name("theta", kPlanners), std::nullopt);
  EXPECT_EQ(closest_name("", kPlanners), std::nullopt);
  EXPECT_EQ(closest_name("astar", {}), std::nullopt);
}

TEST(ClosestName, TakesTheFirstOfEquallyNearNames) {
  EXPECT_EQ(closest_name("mapx", std::vector<std::string>{"mapa", "mapb"}), "mapa");
}

/// A word with a letter inserted, deleted, changed, or swapped with the next one.
std::string misspelt(std::string word) {
  const auto at = *rc::gen::inRange<std::size_t>(0, word.size() + 1);
  const auto change = *rc::gen::inRange(0, 4);
  if (change == 3) {
    if (at + 1 < word.size()) std::swap(word[at], word[at + 1]);
    return word;
  }
  if (at < word.size() && change != 0) word.erase(at, 1);
  if (change != 1) word.insert(at, 1, 'x');
  return word;
}

RC_GTEST_PROP(ClosestName, HasTheLeastEditDistance, ()) {
  const auto word = rc::gen::resize(7, rc::gen::container<std::string>(rc::gen::inRange('a', 'd')));
  const auto names = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(word));
  const auto typed = misspelt(*rc::gen::elementOf(names));
  const auto near_enough = [&](const std::string& name) {
    return 3 * edits(typed, name) <= std::max(typed.size(), name.size());
  };
  const auto closest = closest_name(typed, names);
  if (!closest) {
    RC_ASSERT(std::none_of(names.begin(), names.end(), near_enough));
    return;
  }
  RC_ASSERT(std::count(names.begin(), names.end(), *closest) > 0);
  RC_ASSERT(near_enough(*closest));
  for (const std::string& name : names) {
    if (near_enough(name)) RC_ASSERT(edits(typed, *closest) <= edits(typed, name));
  }
}

}  // namespace
}  // namespace wend
