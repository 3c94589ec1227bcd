// `wend cover`, from outside.

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

class CoverCommand : public testing::Test {
 protected:
  CoverCommand() {
    const Outcome made =
        wend({"generate", "office", "--size", "120x80", "--seed", "3", "-o", map_});
    EXPECT_EQ(made.code, 0) << made.err;
  }

  Outcome cover(std::vector<std::string> more) const {
    more.insert(more.begin(), {"cover", map_, "--robot-radius", "0.15", "--tool-width", "0.3"});
    return wend(std::move(more));
  }

  std::string file(const std::string& name) const { return folder_ / name; }

  TemporaryFolder folder_;
  std::string map_ = folder_ / "office.yaml";
};

TEST_F(CoverCommand, WritesAPathThatCheckFindsFree) {
  const Outcome covered = cover({"-o", file("cover.csv"), "--format", "json"});
  ASSERT_EQ(covered.code, 0) << covered.err;
  EXPECT_THAT(covered.err, IsEmpty());
  const json report = json::parse(covered.out);
  EXPECT_GE(report["covered_share"].get<double>(), 0.999);
  EXPECT_GT(report["length_m"].get<double>(), 0.9 * report["lower_bound_m"].get<double>());
  EXPECT_GT(report["turns"].get<int>(), 0);
  EXPECT_TRUE(report["missed"].is_array());
  const Outcome checked = wend({"check", map_, file("cover.csv"), "--robot-radius", "0.15"});
  EXPECT_EQ(checked.code, 0) << checked.err;
}

TEST_F(CoverCommand, GoesOnFromAMaskOfItsOwn) {
  ASSERT_EQ(cover({"-o", file("done.pgm")}).code, 0);
  const Outcome rest =
      cover({"--covered", file("done.pgm"), "--share", "0.998", "--format", "json"});
  ASSERT_EQ(rest.code, 0) << rest.err;
  EXPECT_EQ(json::parse(rest.out)["length_m"].get<double>(), 0);
}

TEST_F(CoverCommand, DrawsPicturesAndFilms) {
  const Outcome drawn = cover({"-o", file("cover.png"), "-o", file("cover.gif")});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_GT(std::filesystem::file_size(file("cover.png")), 1000U);
  EXPECT_GT(std::filesystem::file_size(file("cover.gif")), 1000U);
}

TEST_F(CoverCommand, NamesTheOptionThatIsWrong) {
  const auto error_of = [&](std::vector<std::string> more) {
    const Outcome outcome = cover(std::move(more));
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_THAT(error_of({"--angle", "steep"}), HasSubstr("--angle"));
  EXPECT_THAT(error_of({"--angle", "nan"}), HasSubstr("--angle"));
  EXPECT_THAT(error_of({"--share", "0"}), HasSubstr("--share"));
  EXPECT_THAT(error_of({"--overlap", "5"}), HasSubstr("overlap"));
  EXPECT_THAT(error_of({"--area", file("none.yaml")}), HasSubstr("none.yaml"));
  const Outcome narrow = wend({"cover", map_, "--tool-width", "0.01"});
  EXPECT_EQ(narrow.code, 2);
  EXPECT_THAT(narrow.err, HasSubstr("tool_width"));
}

TEST_F(CoverCommand, SaysThatTheRobotIsTooLarge) {
  const Outcome outcome = wend({"cover", map_, "--robot-radius", "9", "--tool-width", "0.3"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the robot fits nowhere"));
}

}  // namespace
}  // namespace wend::test
