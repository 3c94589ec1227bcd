#include "wend/io/query/query_csv.hpp"

#include <gmock/gmock.h>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<QueryRow> rows_in(std::string_view text) {
  const auto rows = parse_query_csv(text, "q.csv");
  EXPECT_TRUE(rows) << error_of(rows);
  return rows.value_or(std::vector<QueryRow>{});
}

QueryRow row(std::size_t line, std::string start, std::string goal) {
  return {line, std::move(start), std::move(goal), ""};
}

TEST(QueryCsv, ReadsAColumnForEachNumber) {
  EXPECT_THAT(rows_in("start_x,start_y,goal_x,goal_y\n1,1,15,9\n\n2.5, -1 ,3e0,8\r\n"),
              ElementsAre(row(2, "1,1", "15,9"), row(4, "2.5,-1", "3e0,8")));
}

TEST(QueryCsv, ReadsAColumnForEachEnd) {
  EXPECT_THAT(rows_in("start,goal\n\"1,1\",\"15,9\"\n"), ElementsAre(row(2, "1,1", "15,9")));
  EXPECT_THAT(rows_in("start;goal\n1,1;15,9\n"), ElementsAre(row(2, "1,1", "15,9")));
}

TEST(QueryCsv, TakesColumnsInAnyOrderAndLeavesOthersAlone) {
  EXPECT_THAT(rows_in("\xEF\xBB\xBFid,goal_y,goal_x,start,id\n7,9,15,\"1,1\",\"a \"\"b\"\"\"\n"),
              ElementsAre(row(2, "1,1", "15,9")));
}

TEST(QueryCsv, ReadsHeadingsOfACar) {
  EXPECT_THAT(rows_in("start_x,start_y,start_heading,goal_x,goal_y,goal_heading\n"
                      "1,1,E,5,5,any\n1,1,45deg,5,5,\n"),
              ElementsAre(row(2, "1,1,E", "5,5,any"), row(3, "1,1,45deg", "5,5")));
}

TEST(QueryCsv, KeepsBadRowsWithWhatIsWrong) {
  const auto rows =
      rows_in("start,goal\n1,1,2,2\n\"1,1\",\"2,2\n\"1,1\"x,\"2,2\"\n\"1,1\",\"2,2\"\n");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].wrong, "4 columns, expected 2 as in the header");
  EXPECT_EQ(rows[1].wrong, "unterminated quoted field");
  EXPECT_EQ(rows[2].wrong, "'x' after a quoted field");
  EXPECT_EQ(rows[2].line, 4U);
  EXPECT_EQ(rows[3], row(5, "1,1", "2,2"));
}

TEST(QueryCsv, NeedsAHeader) {
  const auto error = [](std::string_view text) { return error_of(parse_query_csv(text, "q.csv")); };
  EXPECT_EQ(error("1,1,2,2\n"),
            "q.csv:1: the first line must name the columns start_x and start_y, or start, not "
            "'1,1,2,2'");
  EXPECT_THAT(error("start_x,start_y,goal_x\n"),
              HasSubstr("the columns goal_x and goal_y, or goal"));
  EXPECT_EQ(error("start,goal,start\n"), "q.csv:1: duplicate column 'start'");
  EXPECT_THAT(error(""), HasSubstr("q.csv:1: the first line must name"));
  EXPECT_THAT(error("\"start"), HasSubstr("q.csv:1: unterminated quoted field"));
  EXPECT_THAT(rows_in("start,goal\n"), IsEmpty());
}

TEST(QueryCsv, IsReadFromAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_query_csv(folder.write("q.csv", "start;goal\n1,1;2,2\n"))->size(), 1U);
  EXPECT_THAT(error_of(load_query_csv(folder / "none.csv")), HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace wend
