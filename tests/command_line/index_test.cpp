// `wend index` and `wend plan --index`: built, told, used, and refused with what is wrong.

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class IndexCommand : public testing::Test {
 protected:
  IndexCommand() { EXPECT_EQ(wend({"generate", "rooms", "--size", "60x40", "-o", map_}).code, 0); }

  std::string build(const std::string& planner) const {
    const std::string file = folder_ / (planner + ".idx");
    const Outcome outcome = wend({"index", "build", map_, "--planner", planner, "-o", file});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr(planner + " of 60 x 40 cells"), HasSubstr(" MB, ")));
    return file;
  }

  Outcome plan(const std::string& map, std::vector<std::string> more) const {
    std::vector<std::string> arguments{"plan", map, "--start", "1,1", "--goal", "58,38"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return wend(std::move(arguments));
  }

  /// What is wrong with an index, to who wants to plan with it and to who wants to know.
  void expect_refused(const std::string& index, const std::string& what) const {
    const Outcome planned = plan(map_, {"--index", index});
    EXPECT_NE(planned.code, 0);
    EXPECT_THAT(planned.out, IsEmpty());
    EXPECT_THAT(planned.err, HasSubstr(what));
  }

  TemporaryFolder folder_;
  std::string map_ = folder_ / "rooms.map";
};

TEST_F(IndexCommand, PlansAsAStarDoes) {
  const json expected = json::parse(plan(map_, {"--format", "json"}).out);
  const std::string index = build("hub_labels");
  const Outcome outcome = plan(map_, {"--index", index, "--format", "json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found.at("planner"), "hub_labels") << "the planner comes with the index";
  EXPECT_NEAR(found.at("cost").get<double>(), expected.at("cost").get<double>(), 1e-9);
}

TEST_F(IndexCommand, OfEuclideanLabelsPlansAsAnyAngleDoes) {
  const json expected = json::parse(plan(map_, {"--planner", "any_angle", "--format", "json"}).out);
  const std::string index = build("euclidean_labels");
  const Outcome outcome = plan(map_, {"--index", index, "--format", "json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found.at("planner"), "euclidean_labels");
  EXPECT_TRUE(found.at("waypoints"));
  EXPECT_NEAR(found.at("cost").get<double>(), expected.at("cost").get<double>(), 1e-9);
}

TEST_F(IndexCommand, PlanSaysThatItBuildsAnIndexAndDoesNotKeepIt) {
  const Outcome built = plan(map_, {"--planner", "hub_labels"});
  EXPECT_EQ(built.code, 0) << built.err;
  EXPECT_THAT(built.out, HasSubstr("not saved; `wend index build`"));
  EXPECT_THAT(plan(map_, {"--planner", "hub_labels", "--times"}).out, HasSubstr(", index "));
  const auto index_us = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--format", "json"});
    return json::parse(plan(map_, std::move(more)).out).at("times").at("index_us");
  };
  EXPECT_GT(index_us({"--planner", "hub_labels"}), 0);
  EXPECT_TRUE(index_us({"--planner", "jps"}).is_null());

  const std::string index = build("hub_labels");
  EXPECT_GT(index_us({"--index", index}), 0) << "to open it";
  EXPECT_THAT(plan(map_, {"--index", index}).out, Not(HasSubstr("not kept")));
}

TEST_F(IndexCommand, SaysWhatAnIndexHolds) {
  const std::string index = build("euclidean_labels");
  const Outcome text = wend({"index", "info", index});
  EXPECT_EQ(text.code, 0);
  EXPECT_THAT(text.out, AllOf(HasSubstr("euclidean_labels (version "), HasSubstr("60 x 40 cells"),
                              HasSubstr("bytes a passable cell")));
  const json info = json::parse(wend({"index", "info", index, "--format", "json"}).out);
  EXPECT_EQ(info.at("planner"), "euclidean_labels");
  EXPECT_EQ(info.at("index_bytes"), std::filesystem::file_size(index));
}

TEST_F(IndexCommand, TheSameBytesComeFromAnyNumberOfThreads) {
  const std::string one = folder_ / "one.idx";
  const std::string three = folder_ / "three.idx";
  ASSERT_EQ(wend({"index", "build", map_, "--threads", "1", "-o", one}).code, 0);
  ASSERT_EQ(wend({"index", "build", map_, "--threads", "3", "-o", three}).code, 0);
  EXPECT_EQ(bytes_of(one), bytes_of(three));
}

TEST_F(IndexCommand, RefusesAnIndexThatIsCutDamagedOrForAnotherMap) {
  const std::string index = build("hub_labels");
  const std::string bytes = bytes_of(index);
  const std::string bad = folder_.write("bad.idx", bytes.substr(0, bytes.size() / 2));
  expect_refused(bad, "bad.idx");
  EXPECT_EQ(wend({"index", "info", bad}).code, 2);

  std::string damaged = bytes;
  damaged[bytes.size() / 2] = static_cast<char>(damaged[bytes.size() / 2] ^ 0x10);
  expect_refused(folder_.write("bad.idx", damaged), "checksum");
  expect_refused(folder_.write("bad.idx", ""), "bad.idx");
  expect_refused(map_, "rooms.map");
  expect_refused(folder_ / "none.idx", "none.idx");

  const std::string other = folder_ / "other.map";
  ASSERT_EQ(wend({"generate", "rooms", "--size", "60x40", "--seed", "2", "-o", other}).code, 0);
  const Outcome elsewhere = plan(other, {"--index", index});
  EXPECT_NE(elsewhere.code, 0);
  EXPECT_THAT(elsewhere.err, HasSubstr("it was built for another map"));
}

TEST_F(IndexCommand, RefusesWhatItCannotBuild) {
  const auto refused = [&](std::vector<std::string> arguments, int code) {
    arguments.insert(arguments.begin(), {"index", "build"});
    const Outcome outcome = wend(std::move(arguments));
    EXPECT_EQ(outcome.code, code);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  const std::string index = folder_ / "rooms.idx";
  EXPECT_THAT(refused({map_, "--planner", "astar", "-o", index}, 2),
              HasSubstr("this planner does not use an index"));
  EXPECT_THAT(refused({map_}, 2), HasSubstr("--output"));
  EXPECT_THAT(refused({folder_ / "none.map", "-o", index}, 2), HasSubstr("none.map"));
  EXPECT_THAT(refused({map_, "-o", map_}, 2), HasSubstr("rooms.map"));
  const std::string rough = folder_ / "rough.txt";
  ASSERT_EQ(wend({"generate", "rough", "--size", "30x20", "-o", rough}).code, 0);
  EXPECT_THAT(refused({rough, "-o", index}, 1), HasSubstr("terrain"));
  EXPECT_FALSE(std::filesystem::exists(index)) << "nothing was built";
  EXPECT_THAT(bytes_of(map_), testing::StartsWith("type octile")) << "nothing was written over it";
}

}  // namespace
}  // namespace wend::test
