// The flag --mask of the commands that read a map.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

/// An open map in metres, 6 x 3 cells of 0.5 m, with two masks: a keep-out zone across the two lower rows, and a
/// slow middle row.
class Masks : public testing::Test {
 protected:
  void SetUp() override {
    write("room", "trinary", "0 0 0",
          "P2 6 3 255  255 255 255 255 255 255  255 255 255 255 255 255 "
          "255 255 255 255 255 255\n");
    write("zone", "trinary", "1 0 0", "P2 1 2 255  0 0\n");
    write("slow", "raw", "0 0.5 0", "P2 6 1 255  25 25 25 25 25 25\n");
    write("far", "trinary", "90 0 0", "P2 1 1 255  0\n");
  }

  void write(const std::string& name, const std::string& mode, const std::string& origin,
             const std::string& image) const {
    std::string commas = origin;
    std::ranges::replace(commas, ' ', ',');
    folder_.write(name + ".pgm", image);
    folder_.write(name + ".yaml", "image: " + name + ".pgm\nmode: " + mode +
                                      "\nresolution: 0.5\norigin: [" + commas +
                                      "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
  }

  std::string file(const std::string& name) const { return folder_ / (name + ".yaml"); }

  /// Runs a command on the room, from one end of the middle row to the other.
  json planned(std::vector<std::string> flags, const std::string& command = "plan") const {
    std::vector<std::string> words{command,  file("room"), "--start",  "0.25,0.75",
                                   "--goal", "2.75,0.75",  "--format", "json"};
    words.insert(words.end(), flags.begin(), flags.end());
    const Outcome outcome = wend(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? json::parse(outcome.out) : json();
  }

  TemporaryFolder folder_;
};

TEST_F(Masks, KeepPathsOutOfTheirZones) {
  EXPECT_EQ(planned({}).at("cost"), 5);
  const json around = planned({"--mask", file("zone")});
  EXPECT_NEAR(around.at("cost").get<double>(), 3 + 2 * std::sqrt(2), 1e-12);
  EXPECT_EQ(planned({"--mask", "keepout:" + file("zone")}).at("path"), around.at("path"));
}

TEST_F(Masks, MakeSlowGroundCostItsTime) {
  const json by_speed = planned({"--mask", "speed:" + file("slow")});
  EXPECT_NEAR(by_speed.at("cost").get<double>(), 5 + 2 * (4 + 1) / 2.0, 1e-9)
      << "25 percent: it leaves the row at once, for 4 times the time";
  const json slower = planned({"--mask", "speed:multiplier=0.04:top_speed=2:" + file("slow")});
  EXPECT_NEAR(slower.at("cost").get<double>(), 3 + 2 * std::sqrt(2) * (2 + 1) / 2, 1e-9)
      << "1 m/s of 2";
}

TEST_F(Masks, CanBeLaidOneAfterAnother) {
  const Outcome info = wend({"info", file("room"), "--mask", file("zone"), "--mask",
                             "speed:" + file("slow"), "--format", "json"});
  ASSERT_EQ(info.code, 0) << info.err;
  const json said = json::parse(info.out);
  EXPECT_EQ(said.at("occupied"), 2);
  EXPECT_EQ(said.at("terrain").at("greatest"), 4);
}

TEST_F(Masks, ApplyToEveryCommandThatReadsAMap) {
  const std::string zone = file("zone");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"view", file("room"), "--mask", zone},
           {"field", file("room"), "--goal", "2.75,0.75", "--mask", zone},
           {"explain", file("room"), "--start", "0.25,0.75", "--goal", "2.75,0.75", "--mask", zone},
           {"compare", file("room"), "--start", "0.25,0.75", "--goal", "2.75,0.75", "--mask", zone},
       }) {
    const Outcome outcome = wend(words);
    EXPECT_EQ(outcome.code, 0) << words.front() << ": " << outcome.err;
  }
  const std::string written = folder_ / "under.txt";
  const Outcome converted = wend({"convert", file("room"), written, "--mask", zone});
  ASSERT_EQ(converted.code, 0) << converted.err;
  EXPECT_EQ(bytes_of(written), "......\n..#...\n..#...\n");
}

TEST_F(Masks, ThatDoNotFitAreRefusedWithTheReason) {
  const auto refusal = [&](const std::string& mask) {
    const Outcome outcome = wend({"info", file("room"), "--mask", mask});
    EXPECT_EQ(outcome.code, 2) << mask;
    return outcome.err;
  };
  EXPECT_THAT(refusal("none.yaml"), HasSubstr("none.yaml"));
  EXPECT_THAT(refusal(file("far")),
              AllOf(HasSubstr("--mask " + file("far")), HasSubstr("does not touch the map"),
                    HasSubstr("x from 90 to 90.5")));
  EXPECT_THAT(refusal("speed:" + file("zone")), HasSubstr("mode: scale or mode: raw"));
  EXPECT_THAT(refusal("speed:base=fast:" + file("slow")),
              HasSubstr("base of a speed mask is 'fast'"));
  EXPECT_THAT(refusal("keepout:"), HasSubstr("needs a file"));
  const std::string grid = folder_.write("grid.txt", "...\n...\n");
  EXPECT_THAT(refusal(grid), HasSubstr("3 x 2 cells, the map 6 x 3 cells, and the mask has no "
                                       "resolution: the same size expected"));
  folder_.write("zone.pgm", "P5 600 2 255\nabc");
  EXPECT_THAT(refusal(file("zone")), HasSubstr("zone.pgm"));
}

}  // namespace
}  // namespace wend::test
