#include "wend/report/text_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wend {
namespace {

TEST(TextTable, AlignsItsColumns) {
  TextTable table({{"planner"}, {"us", Align::right}});
  table.add({"astar", "1.5"});
  table.add({"random_walk", "12.25"});
  EXPECT_EQ(table.text(),
            "planner         us\n"
            "astar          1.5\n"
            "random_walk  12.25\n");
}

TEST(TextTable, IsAsWideAsItsLongestLine) {
  TextTable table({{"a"}, {"long title"}});
  table.add({"wide field", ""});
  EXPECT_EQ(table.width(), 22U) << "the title; spaces at the end of a line do not count";
  table.add({"", "→ longer field"});
  EXPECT_EQ(table.width(), 26U);
}

TEST(TextTable, CountsCharactersAndNotBytes) {
  TextTable table({{"→"}, {"b"}});
  table.add({"ab", "c"});
  EXPECT_EQ(table.text(), "→   b\nab  c\n");
}

TEST(TextTable, TitlesOfSeveralLinesEndAboveTheRows) {
  TextTable table({{"planner"}, {"length\ncells", Align::right}, {"length\nm", Align::right}});
  table.add({"astar", "12", "1.2"});
  EXPECT_EQ(table.text(),
            "         length  length\n"
            "planner   cells       m\n"
            "astar        12     1.2\n");
}

TEST(TextTable, BreaksLongFieldsAfterCommas) {
  TextTable table({{"planner", Align::left, 16}, {"us", Align::right}});
  table.add({"astar:weight=2,heuristic=euclidean,w=3", "1.5"});
  table.add({"random_walk_without_commas", "12.25"});
  table.add({"a:b=1,c=2", "3"});
  EXPECT_EQ(table.text(),
            "planner                        us\n"
            "astar:weight=2,               1.5\n"
            "  heuristic=euclidean,\n"
            "  w=3\n"
            "random_walk_without_commas  12.25\n"
            "a:b=1,c=2                       3\n");
}

TEST(TextTable, LetsFurtherLinesReachBelowOtherColumns) {
  TextTable table({{"planner", Align::left, 8}, {"us", Align::right}});
  table.add({"astar:w=2,heuristic=euclidean", "1.5"});
  EXPECT_EQ(table.text(),
            "planner      us\n"
            "astar:w=2,  1.5\n"
            "  heuristic=euclidean\n");
  EXPECT_EQ(table.width(), 21U);
}

TEST(TextTable, PutsColumnsBelowForWhichThereIsNoRoom) {
  TextTable table(
      {{"planner", Align::left, 8}, {"us", Align::right}, {"cost"}, {"expanded", Align::right}});
  table.add({"astar:w=2,h=1", "1.5", "7", "12"});
  table.add({"bfs", "2", "8", "345"});
  EXPECT_EQ(table.text(table.width()), table.text());
  EXPECT_EQ(table.text(21),
            "planner      us  cost\n"
            "astar:w=2,  1.5  7\n"
            "  h=1\n"
            "bfs           2  8\n"
            "\n"
            "planner     expanded\n"
            "astar:w=2,        12\n"
            "  h=1\n"
            "bfs              345\n");
  const std::string narrow = table.text(1);
  EXPECT_EQ(std::ranges::count(narrow, '\n'), 3 * 4 + 2) << "a column each: " << narrow;
}

TEST(TextTable, IsItsTitlesWithoutRows) { EXPECT_EQ(TextTable({{"a"}, {"b"}}).text(), "a  b\n"); }

}  // namespace
}  // namespace wend
