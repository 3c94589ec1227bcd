#include "wend/io/query/stop_csv.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace wend {
namespace {

using Stops = std::vector<std::string>;
using Pairs = std::vector<std::pair<int, int>>;

TEST(StopCsv, ReadsColumnsInAnyOrder) {
  EXPECT_EQ(*parse_stop_csv("x,y\n1,2\n\n3.5,4\n", "a.csv"), (Stops{"1,2", "3.5,4"}));
  EXPECT_EQ(*parse_stop_csv("name;y;x;heading\r\nbin; 2 ;1;E\r\nbox;4;3;\r\n", "a.csv"),
            (Stops{"1,2,E", "3,4"}));
  EXPECT_EQ(*parse_stop_csv("x,y", "a.csv"), Stops());
}

TEST(StopCsv, NamesTheLineThatIsWrong) {
  EXPECT_EQ(parse_stop_csv("", "a.csv").error().message,
            "a.csv:1: the first line must name the columns x and y, not ''");
  EXPECT_EQ(parse_stop_csv("x,y\n1,2\n1\n", "a.csv").error().message,
            "a.csv:3: 1 columns, expected 2 as in the header");
  EXPECT_EQ(load_stop_csv("/nowhere/stops.csv").error().status, Status::invalid_file);
}

TEST(StopPairCsv, ReadsRows) {
  EXPECT_EQ(*parse_stop_pair_csv("first,second\n0,3\n2,1\n", "a.csv"), (Pairs{{0, 3}, {2, 1}}));
  EXPECT_EQ(parse_stop_pair_csv("a,b\n", "a.csv").error().message,
            "a.csv:1: the first line must name the columns first and second, not 'a,b'");
  for (const char* bad : {"-1,0", "1.5,0", "x,0", "99999999999,0", ",0"}) {
    const auto pairs = parse_stop_pair_csv("first,second\n" + std::string(bad), "a.csv");
    ASSERT_FALSE(pairs) << bad;
    EXPECT_EQ(pairs.error().message,
              "a.csv:2: first and second must be rows of the stops, counted from 0");
  }
}

}  // namespace
}  // namespace wend
