// `wend plan --planner ara_star`: the paths that it tells, and their plot.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class AnytimeCommand : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(wend({"generate", "rooms", "--size", "201x101", "--seed", "1", "-o", map_}).code, 0);
  }

  Outcome plan(const std::vector<std::string>& more,
               const std::string& planner = "ara_star") const {
    std::vector<std::string> arguments{"plan",   map_,     "--start",   "1,1",
                                       "--goal", "199,99", "--planner", planner};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return wend(std::move(arguments));
  }

  TemporaryFolder folder_;
  std::string map_ = folder_ / "rooms.txt";
};

TEST_F(AnytimeCommand, ListsItsPaths) {
  const Outcome outcome = plan({});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, HasSubstr("paths     after"));
  EXPECT_THAT(outcome.out, HasSubstr("expanded: cost"));
  EXPECT_THAT(outcome.out, HasSubstr("quality   optimal"));
}

TEST_F(AnytimeCommand, HasItsPathsInTheJson) {
  const json answer = json::parse(plan({"--format", "json", "--initial-weight", "10"}).out);
  const json& solutions = answer.at("solutions");
  ASSERT_GT(solutions.size(), 1U);
  for (std::size_t i = 1; i < solutions.size(); ++i) {
    for (const char* key : {"cost", "bound"}) {
      EXPECT_LE(solutions[i].at(key).get<double>(), solutions[i - 1].at(key).get<double>());
    }
    EXPECT_GE(solutions[i].at("search_us"), solutions[i - 1].at("search_us"));
  }
  EXPECT_EQ(solutions.back().at("bound"), 1);
  EXPECT_EQ(solutions.back().at("cost"), answer.at("cost"));
  EXPECT_EQ(solutions.back().at("expanded"), answer.at("metrics").at("expanded"));
}

TEST_F(AnytimeCommand, AnswersAtALimitWithItsBestPath) {
  const json all = json::parse(plan({"--format", "json", "--initial-weight", "10"}).out);
  const auto first = all.at("solutions").front().at("expanded").get<std::uint64_t>();
  const std::vector<std::string> limited{"--format", "json", "--initial-weight", "10",
                                         "--limit-expansions"};
  std::vector<std::string> enough = limited;
  enough.push_back(std::to_string(first));
  const json answer = json::parse(plan(enough).out);
  EXPECT_EQ(answer.at("status"), "found");
  EXPECT_GT(answer.at("bound"), 1);
  EXPECT_EQ(answer.at("metrics").at("expanded"), first);
  std::vector<std::string> too_few = limited;
  too_few.emplace_back("2");
  const Outcome outcome = plan(too_few);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("expansion_limit"), HasSubstr("\"solutions\":[]")));
}

TEST_F(AnytimeCommand, ListsTheDrivesOfAnInitialWeight) {
  const std::string yard = folder_ / "yard.txt";  // the doors of rooms are too narrow for a car
  ASSERT_EQ(wend({"generate", "car", "--size", "41x41", "--seed", "3", "-o", yard}).code, 0);
  for (const std::string planner : {"lattice", "car"}) {
    SCOPED_TRACE(planner);
    const std::vector<std::string> ends{"--start",   "1,1,E", "--goal",   "39,39,any",
                                        "--planner", planner, "--format", "json"};
    std::vector<std::string> arguments{"plan", yard};
    arguments.insert(arguments.end(), ends.begin(), ends.end());
    EXPECT_THAT(wend(std::vector<std::string>(arguments)).out, Not(HasSubstr("solutions")));
    std::vector<std::string> plotted = arguments;
    plotted.insert(plotted.end(), {"--plot", (folder_ / "bounds.svg").string()});
    EXPECT_THAT(wend(std::move(plotted)).err,
                HasSubstr("--plot changes nothing without --initial-weight above 1"));
    arguments.insert(arguments.end(), {"--initial-weight", "5"});
    const json answer = json::parse(wend(std::move(arguments)).out);
    ASSERT_EQ(answer.at("status"), "found") << planner;
    ASSERT_GT(answer.at("solutions").size(), 1U);
    EXPECT_EQ(answer.at("solutions").back().at("cost"), answer.at("cost"));
    EXPECT_EQ(answer.at("bound"), 1);
  }
}

TEST_F(AnytimeCommand, KeepsTheWordsOfItsPlotOnThePage) {
  const std::string plot = folder_ / "bounds.svg";
  const Outcome outcome = plan({"--plot", plot});
  if (outcome.err.find("needs the program gnuplot") != std::string::npos) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  const std::string svg = bytes_of(plot);
  std::smatch page;
  ASSERT_TRUE(std::regex_search(svg, page, std::regex(R"(viewBox="0 0 (\d+) (\d+)\")")));
  const double height = std::stod(page[2]);
  constexpr double kBelowBaseline = 5;  // pixels of a letter that reaches down
  int words = 0;
  const std::regex baseline(R"(translate\(([\d.]+),([\d.]+)\)[^<]*<text)");
  for (std::sregex_iterator text(svg.begin(), svg.end(), baseline), end; text != end; ++text) {
    EXPECT_LE(std::stod((*text)[2]) + kBelowBaseline, height);
    ++words;
  }
  EXPECT_GT(words, 5);
  EXPECT_THAT(svg, HasSubstr("lower bound"));
}

TEST_F(AnytimeCommand, PlotsOnlyWhatIsAnytime) {
  const Outcome outcome = plan({"--plot", (folder_ / "bounds.svg").string()}, "astar");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--plot changes nothing for the planner astar"));
  EXPECT_THAT(plan({"--format", "json"}, "astar").out, Not(HasSubstr("solutions")));
}

}  // namespace
}  // namespace wend::test
