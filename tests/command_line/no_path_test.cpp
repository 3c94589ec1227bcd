// The files that commands write if there is no path: the reason takes the place of an old path.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"
#include "tests/command_line/walled_off_grid.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* kWhyWalledOff = "there is no path from start (0,0) to goal (6,0)";

class NoPath : public testing::Test {
 protected:
  Outcome plan(std::vector<std::string> more) const {
    more.insert(more.begin(), {"plan", map_, "--start", "0,0", "--goal", "6,0"});
    return wend(std::move(more));
  }

  /// A file that an earlier command is said to have written.
  std::string old(const std::string& name) const { return folder_.write(name, "old"); }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kWalledOff);
};

TEST_F(NoPath, TakesThePlaceOfAnOldPath) {
  const std::string csv = old("plan.csv");
  const std::string in_json = old("plan.json");
  EXPECT_EQ(plan({"-o", csv, "-o", in_json}).code, 1);
  EXPECT_THAT(bytes_of(csv),
              AllOf(StartsWith("# no path: unreachable: " + std::string(kWhyWalledOff)),
                    EndsWith("\nx,y,x_m,y_m\n")));
  const json failed = json::parse(bytes_of(in_json));
  EXPECT_EQ(failed.at("status"), "unreachable");
  EXPECT_THAT(failed.at("reason"), StartsWith(kWhyWalledOff));
  EXPECT_EQ(failed.at("path"), json::array());
  EXPECT_EQ(failed.at("schema"), 1);
}

TEST_F(NoPath, TakesThePlaceOfAnOldDrive) {
  const std::string csv = old("drive.csv");
  const std::string in_json = old("drive.json");
  const std::string svg = old("drive.svg");
  const std::string gif = old("drive.gif");
  const Outcome run = wend({"follow", map_, "--start", "0,0", "--goal", "6,0", "--margin", "0",
                            "-o", csv, "-o", in_json, "-o", svg, "-o", gif});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(bytes_of(csv), StartsWith("# no path: unreachable: " + std::string(kWhyWalledOff)));
  EXPECT_EQ(json::parse(bytes_of(in_json)).at("status"), "unreachable");
  EXPECT_THAT(bytes_of(svg), StartsWith("<?xml"));
  EXPECT_THAT(bytes_of(gif), StartsWith("GIF89a"));
  const std::string next = old("next.csv");
  EXPECT_EQ(wend({"follow", map_, "--path", csv, "-o", next}).code, 1);
  EXPECT_EQ(bytes_of(next), bytes_of(csv));
}

TEST_F(NoPath, IsRefusedWithItsReasonByWhatTakesPaths) {
  const std::string csv = old("plan.csv");
  const std::string in_json = old("plan.json");
  plan({"-o", csv, "-o", in_json});
  for (const std::string& file : {csv, in_json}) {
    for (const std::vector<std::string>& command : {std::vector<std::string>{"check", map_, file},
                                                    {"smooth", map_, file},
                                                    {"view", map_, file},
                                                    {"follow", map_, "--path", file}}) {
      const Outcome refused = wend(command);
      EXPECT_EQ(refused.code, 1) << command.front();
      EXPECT_THAT(refused.err, StartsWith("wend: " + file + ": no path: " + kWhyWalledOff));
      EXPECT_THAT(refused.out, IsEmpty());
    }
  }
}

TEST_F(NoPath, IsPassedOnBySmooth) {
  const std::string failed = old("plan.csv");
  plan({"-o", failed});
  const std::string csv = old("smooth.csv");
  const std::string in_json = old("smooth.json");
  const std::string picture = old("smooth.png");
  EXPECT_EQ(wend({"smooth", map_, failed, "-o", csv, "-o", in_json, "-o", picture}).code, 1);
  EXPECT_EQ(bytes_of(csv), bytes_of(failed));
  EXPECT_THAT(bytes_of(picture), StartsWith("\x89PNG"));
  for (const std::string& file : {csv, in_json}) {
    EXPECT_THAT(wend({"check", map_, file}).err,
                HasSubstr(std::string("no path: ") + kWhyWalledOff));
  }
}

TEST_F(NoPath, OfAPathThatCollidesIsWrittenBySmooth) {
  const std::string path = folder_.write("through.csv", "x,y,x_m,y_m\n0,0,0,0\n0,1,0,1\n1,1,1,1\n");
  const std::string csv = old("smooth.csv");
  const Outcome refused = wend({"smooth", map_, path, "-o", csv});
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr("the path is not free"));
  EXPECT_THAT(bytes_of(csv), StartsWith("# no path: not_free: the path is not free"));
}

TEST_F(NoPath, IsShownInPicturesWithStatusAndReason) {
  for (const char* const name : {"plan.png", "plan.pdf", "plan.gif"}) {
    const std::string picture = old(name);
    EXPECT_EQ(plan({"-o", picture}).code, 1);
    EXPECT_THAT(bytes_of(picture), Not(StartsWith("old"))) << name;
  }
  const std::string svg = old("plan.svg");
  plan({"-o", svg});
  // The caption's letters are drawn as shapes: two reasons make two pictures.
  const std::string unreachable = bytes_of(svg);
  EXPECT_EQ(wend({"plan", map_, "--start", "0,0", "--goal", "6,3", "-o", svg}).code, 1);
  EXPECT_NE(bytes_of(svg), unreachable);
  EXPECT_THAT(bytes_of(svg), HasSubstr("<svg"));
}

TEST_F(NoPath, WithoutAnySearchIsAFilmOfOnePicture) {
  const std::string film = old("plan.gif");
  EXPECT_EQ(wend({"plan", map_, "--start", "9,9", "--goal", "6,3", "-o", film}).code, 1);
  EXPECT_THAT(bytes_of(film), StartsWith("GIF89a"));
}

TEST_F(NoPath, OfACarSaysSoToo) {
  const std::string csv = old("plan.csv");
  const std::string picture = old("plan.png");
  const Outcome refused = wend({"plan", map_, "--planner", "car", "--start", "0,0,E", "--goal",
                                "7,4,any", "-o", csv, "-o", picture});
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(bytes_of(csv), StartsWith("# no path: "));
  EXPECT_THAT(bytes_of(picture), StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace wend::test
