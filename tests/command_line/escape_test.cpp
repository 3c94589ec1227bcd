// --escape, --closest and --nearest-limit of plan, follow and check.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A room of 3 x 2 m at 0.1 m a cell with a closet in it, and a mask with a zone at the left.
class EscapeCommand : public testing::Test {
 protected:
  static constexpr int kWidth = 30;
  static constexpr int kHeight = 20;

  void SetUp() override {
    write("room", [](int x, int y) {
      const bool in_box = x >= 20 && x <= 26 && y >= 6 && y <= 12;
      return in_box && (x == 20 || x == 26 || y == 6 || y == 12);
    });
    write("zone", [](int x, int y) { return x < 6 && y >= 5 && y < 15; });
  }

  template <class Blocked>
  void write(const std::string& name, const Blocked& blocked) const {
    std::string image = "P2 30 20 255";
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) image += blocked(x, y) ? " 0" : " 255";
    }
    folder_.write(name + ".pgm", image + "\n");
    folder_.write(name + ".yaml", "image: " + name +
                                      ".pgm\nmode: trinary\nresolution: 0.1\norigin: [0, 0, 0]\n"
                                      "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
  }

  std::string file(const std::string& name) const { return folder_ / name; }

  Outcome run(const std::string& command, const std::vector<std::string>& flags) const {
    std::vector<std::string> words{command, file("room.yaml")};
    words.insert(words.end(), flags.begin(), flags.end());
    return wend(words);
  }

  TemporaryFolder folder_;
};

TEST_F(EscapeCommand, LeadsOutOfTheZoneOfAMask) {
  std::vector<std::string> ends{"--mask",    file("zone.yaml"), "--start", "0.35,1.05", "--goal",
                                "1.55,1.05", "--robot-radius",  "0.15",    "--format",  "json"};
  const Outcome refused = run("plan", ends);
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(
      refused.err,
      AllOf(HasSubstr("the cell is blocked by the keep-out mask '"), HasSubstr("zone.yaml'"),
            HasSubstr("--escape 0.4 lets the robot leave it, by a way of 0.4 m")));
  ends.insert(ends.end(), {"--escape", "0.3"});
  EXPECT_THAT(run("plan", ends).err, HasSubstr("longer than the 0.3 m allowed: --escape 0.4"));
  ends.back() = "0.4";
  const Outcome planned = run("plan", ends);
  ASSERT_EQ(planned.code, 0) << planned.err;
  const json plan = json::parse(planned.out);
  EXPECT_NEAR(plan.at("lead_out").at("length_m").get<double>(), 0.4, 1e-9);
  EXPECT_EQ(plan.at("lead_out").at("points"), 4);
  EXPECT_EQ(plan.at("path").front(), json({3, 10}));
  EXPECT_NEAR(plan.at("length_m").get<double>(), 1.2, 1e-9);
  EXPECT_NEAR(plan.at("cost").get<double>(), 8, 1e-9) << "of the path behind the way out";
}

TEST_F(EscapeCommand, AcceptsInCheckWhatItPlans) {
  for (const std::string planner : {"astar", "any_angle", "lattice", "hybrid_astar", "car"}) {
    SCOPED_TRACE(planner);
    const std::vector<std::string> robot{"--mask", file("zone.yaml"), "--robot-radius", "0.15"};
    const std::string heading = planner == "astar" || planner == "any_angle" ? "" : ",20deg";
    std::vector<std::string> flags{"--start",   "0.4,1" + heading, "--goal",    "1.5,1",
                                   "--planner", planner,           "--escape",  "0.6",
                                   "-o",        file("a.csv"),     "--picture", "never"};
    flags.insert(flags.end(), robot.begin(), robot.end());
    const Outcome planned = run("plan", flags);
    ASSERT_EQ(planned.code, 0) << planned.err;
    EXPECT_THAT(planned.out, HasSubstr("lead out"));
    std::vector<std::string> check{file("a.csv")};
    check.insert(check.end(), robot.begin(), robot.end());
    EXPECT_EQ(run("check", check).code, 1) << "without --escape";
    check.insert(check.end(), {"--escape", "0.6"});
    const Outcome checked = run("check", check);
    EXPECT_EQ(checked.code, 0) << checked.err;
    EXPECT_THAT(checked.out, AllOf(HasSubstr("lead out: for 0."), HasSubstr("free: ")));
    check.back() = "0.1";
    EXPECT_EQ(run("check", check).code, 1);
  }
}

TEST_F(EscapeCommand, LetsASimulatedRobotLeave) {
  const std::vector<std::string> ends{
      "--mask",    file("zone.yaml"), "--start", "0.55,1.05", "--goal",
      "1.55,1.05", "--robot-radius",  "0.15",    "--format",  "json"};
  EXPECT_EQ(run("follow", ends).code, 1);
  std::vector<std::string> flags = ends;
  flags.insert(flags.end(), {"--escape", "0.6"});
  const Outcome followed = run("follow", flags);
  EXPECT_EQ(followed.code, 0) << followed.err;
  const json drive = json::parse(followed.out);
  EXPECT_EQ(drive.at("drives").at(0).at("collisions"), 0) << followed.out;
}

TEST_F(EscapeCommand, EndsAtTheClosestPlace) {
  for (const std::string planner : {"astar", "jps", "theta_star", "lattice", "car"}) {
    SCOPED_TRACE(planner);
    const std::string heading = planner == "lattice" || planner == "car" ? ",E" : "";
    const auto plan = [&](const std::string& goal) {
      return run("plan", {"--start", "0.5,1" + heading, "--goal", goal, "--planner", planner,
                          "--closest", "--format", "json"});
    };
    for (const std::string goal : {"2.35,1.05", "2.35,1.35", "1.5,2.6"}) {
      SCOPED_TRACE(goal);  // walled in, blocked, outside the map
      const Outcome outcome = plan(goal);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr("planning to the closest reachable place"));
      EXPECT_GT(json::parse(outcome.out).at("remaining").at("m"), 0.05);
    }
    const Outcome free = plan("1.5,1.05");
    EXPECT_EQ(json::parse(free.out).at("remaining").at("m"), 0);
    EXPECT_THAT(free.err, Not(HasSubstr("closest")));
  }
}

TEST_F(EscapeCommand, LimitsByHowMuchEndsMove) {
  const auto plan = [&](std::vector<std::string> flags) {
    flags.insert(flags.end(), {"--mask", file("zone.yaml"), "--start", "1.5,1", "--goal",
                               "0.05,1.05", "--nearest", "--format", "json"});
    return run("plan", flags);
  };
  EXPECT_EQ(plan({}).code, 0) << "0.5 m, within 1 m";
  const Outcome far = plan({"--nearest-limit", "0.3"});
  EXPECT_EQ(far.code, 1);
  EXPECT_THAT(far.err, HasSubstr("m away, more than the limit of 0.3 m (--nearest-limit 0."));
}

TEST_F(EscapeCommand, AnswersManyQueriesSo) {
  folder_.write("queries.csv", "start,goal\n\"0.35,1.05\",\"2.35,1.05\"\n");
  const Outcome outcome =
      run("plan", {"--mask", file("zone.yaml"), "--queries", file("queries.csv"), "--escape", "1",
                   "--closest", "--format", "json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json answer = json::parse(outcome.out).at("answers").at(0);
  EXPECT_EQ(answer.at("status"), "found");
  EXPECT_GT(answer.at("lead_out").at("points"), 0);
  EXPECT_GT(answer.at("remaining").at("m"), 0.3);
  EXPECT_THAT(answer.at("reason").get<std::string>(),
              AllOf(HasSubstr("a way out of"), HasSubstr("closest reachable place")));
}

}  // namespace
}  // namespace wend::test
