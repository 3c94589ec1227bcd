// `--plugin`, from outside: planners from shared objects, and files that are none.

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"
#include "tests/testing/build_paths.hpp"
#include "wend/version.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string plugin(const std::string& name) { return plugin_folder() / (name + ".so"); }

class Plugin : public testing::Test {
 protected:
  std::string map() const { return folder_.write("map.txt", ".....\n.###.\n.....\n"); }

  Outcome plan_by(const std::string& planner, const std::string& file) const {
    return wend({"--plugin", file, "plan", map(), "--start", "0,1", "--goal", "4,1", "--planner",
                 planner, "--format", "json"});
  }

  void expect_refused(const std::string& file, const std::string& why) const {
    const Outcome outcome = plan_by("astar", file);
    EXPECT_EQ(outcome.code, 2) << outcome.out;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("--plugin " + file + ": "), HasSubstr(why)));
  }

  TemporaryFolder folder_;
};

TEST_F(Plugin, ItsPlannerPlansLikeAnyOther) {
  const Outcome outcome = plan_by("swirl", plugin("swirl"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json plan = json::parse(outcome.out);
  EXPECT_EQ(plan["planner"], "swirl");
  EXPECT_EQ(plan["cost"], 6);
}

TEST_F(Plugin, ItsPlannersAreComparedBenchedAndListed) {
  const Outcome compared = wend({"--plugin", plugin("swirl"), "compare", map(), "--start", "0,1",
                                 "--goal", "4,1", "--planner", "astar,swirl"});
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_THAT(compared.out, AllOf(HasSubstr("astar"), HasSubstr("swirl")));
  const std::string scenario = folder_.write("map.scen", "version 1\n0 map.txt 5 3 0 1 4 1 6\n");
  const Outcome benched = wend(
      {"--plugin", plugin("swirl"), "bench", scenario, "--map", map(), "--planner", "astar,swirl"});
  EXPECT_EQ(benched.code, 0) << benched.err;
  EXPECT_THAT(benched.out, HasSubstr("swirl"));
  EXPECT_THAT(wend({"planners", "--plugin=" + plugin("swirl")}).out, HasSubstr("swirl"));
  EXPECT_THAT(wend({"planners"}).out, Not(HasSubstr("swirl")));
}

TEST_F(Plugin, SeveralPluginsAndSeveralPlannersOfOneAreLoaded) {
  const Outcome outcome = wend({"--plugin", plugin("two_planners"), "--plugin", plugin("swirl"),
                                "planners", "--format", "json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("\"one\""), HasSubstr("\"two\""), HasSubstr("\"swirl\"")));
}

TEST_F(Plugin, ItsOptionsAreChecked) {
  const Outcome outcome = plan_by("swirl:weight=2", plugin("swirl"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("unknown option 'weight'"));
}

TEST_F(Plugin, WithoutItThePlannerIsUnknown) {
  EXPECT_THAT(wend({"plan", map(), "--start", "0,1", "--goal", "4,1", "--planner", "swirl"}).err,
              HasSubstr("there is no planner 'swirl'"));
}

TEST_F(Plugin, AnotherVersionIsRefusedBeforeItRuns) {
  expect_refused(plugin("other_version"),
                 "compiled for wend 0.1.7, but this is wend " WEND_VERSION);
}

TEST_F(Plugin, AnotherCopyOfTheLibraryIsRefused) {
  expect_refused(plugin("own_copy"), "another copy of libwend");
}

TEST_F(Plugin, ATakenNameIsRefused) {
  expect_refused(plugin("taken_names"), "there is already a planner 'astar'");
}

TEST_F(Plugin, TwiceTheSameIsATakenName) {
  const Outcome outcome =
      wend({"--plugin", plugin("swirl"), "--plugin", plugin("swirl"), "planners"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("there is already a planner 'swirl'"));
}

TEST_F(Plugin, WhatIsNotAPluginIsRefused) {
  expect_refused((folder_ / "missing.so").string(), "No such file");
  expect_refused(map(), "not a plugin of wend");
  std::filesystem::create_directory(folder_ / "folder");
  expect_refused((folder_ / "folder").string(), "");
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  expect_refused((folder_ / "pipe").string(), "");
}

TEST_F(Plugin, HalfAPluginIsRefused) {
  const std::string whole = bytes_of(plugin("swirl"));
  for (const std::size_t part : {2, 3, 10}) {
    expect_refused(folder_.write("half.so", whole.substr(0, whole.size() / part)), "");
  }
}

TEST_F(Plugin, AMissingNameIsAnError) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"planners", "--plugin"}, {"--plugin=", "planners"}}) {
    const Outcome outcome = wend(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--plugin: the name of a shared object is missing"));
  }
}

class BrokenPlanner : public testing::Test {
 protected:
  static Outcome test(std::vector<std::string> more) {
    more.insert(more.begin(), {"--plugin", plugin_, "test-planner"});
    return wend(std::move(more));
  }

  inline static const std::string plugin_ = plugin("endless");
};

TEST_F(BrokenPlanner, ThatHangsEndsTheCheckWhichIsNamed) {
  const Outcome outcome = test({"endless", "--limit-time", "0.2", "--seed", "5"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("answers         answers agree with the reference"),
                                 HasSubstr("FAILED (1 maps"), HasSubstr("none for 0.2 s"),
                                 HasSubstr("again:    wend --plugin " + plugin_ +
                                           " test-planner endless --seed 5 --maps 1\n"),
                                 HasSubstr("endless failed 1 of 1 checks\n")));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("the check 'answers' ended"),
                                 HasSubstr("the checks behind it did not run")));
}

TEST_F(BrokenPlanner, ThatHangsIsReportedInJsonToo) {
  const auto json =
      nlohmann::json::parse(test({"endless", "--limit-time", "0.2", "--format", "json"}).out);
  EXPECT_EQ(json.at("passed"), false);
  EXPECT_EQ(json.at("checks").size(), 1U);
  EXPECT_EQ(json.at("checks").at(0).at("smallest").at("came"), "none for 0.2 s");
}

TEST_F(BrokenPlanner, ThatThrowsViolatesChecksAndTheOthersRun) {
  const Outcome outcome = test({"throwing", "--maps", "3"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("an exception: the map is too beautiful"),
                                 HasSubstr("again:    wend --plugin " + plugin_ + " test-planner"),
                                 HasSubstr("y_up "), HasSubstr("throwing failed ")));
}

}  // namespace
}  // namespace wend::test
