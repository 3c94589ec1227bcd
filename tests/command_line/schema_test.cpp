// Every JSON that wend writes begins with the number of its schema.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using testing::StartsWith;

class Schema : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(shell("cd " + (folder_ / "").string() +
                    " && $WEND generate random --size 12x9 --density 0 -o grid.txt"
                    " && $WEND plan grid.txt --start 1,1 --goal 10,7 -o path.csv -o plan.json")
                  .code,
              0);
  }

  /// The line of JSON that a command prints.
  Outcome printed_by(const std::string& command) const {
    return shell("cd " + (folder_ / "").string() + " && $WEND " + command + " --format json");
  }

  TemporaryFolder folder_;
};

TEST_F(Schema, IsTheFirstKeyOfEveryReport) {
  for (const std::string command :
       {"generate random --size 9x9 -o other.txt", "info grid.txt", "convert grid.txt grid.map",
        "planners", "test-planner bfs --maps 2", "plan grid.txt --start 1,1 --goal 10,7",
        "plan grid.txt --planner car --start 1,1,E --goal 9,7,E",
        "plan grid.txt --start 1,1 --goal 99,7", "field grid.txt --goal 10,7 --start 1,1",
        "compare grid.txt --start 1,1 --goal 10,7", "explain grid.txt --start 1,1 --goal 10,7",
        "smooth grid.txt path.csv", "check grid.txt path.csv", "follow grid.txt --path path.csv",
        "index build grid.txt --planner euclidean_labels -o grid.idx", "index info grid.idx"}) {
    const Outcome outcome = printed_by(command);
    EXPECT_THAT(outcome.out, StartsWith(R"({"schema":1,)")) << command << '\n' << outcome.err;
    EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << command;
  }
}

TEST_F(Schema, IsInFilesTooWhichAreReadBack) {
  EXPECT_THAT(bytes_of(folder_ / "plan.json"), StartsWith(R"({"schema":1,)"));
  EXPECT_EQ(printed_by("check grid.txt plan.json").code, 0);
}

}  // namespace
}  // namespace wend::test
