// The script, and what gnuplot makes of it where it is installed.

#include "bench/comparison/comparison_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "wend/base/random.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Each planner is slower than the one before; the last one fails often.
Comparison made_up(const std::vector<std::string>& planners, int queries, double spread) {
  Random random(3);
  Comparison comparison{{.resolution = 0.05, .metric = true}, {}};
  for (int i = 0; i < queries; ++i) {
    ComparedQuery query;
    const double length = 20 + 980 * random.uniform();
    for (std::size_t planner = 0; planner < planners.size(); ++planner) {
      const double work = std::pow(length / 20, spread) * (1 + random.uniform());
      ComparisonRow row{.planner = planners[planner], .length = length};
      row.expanded = static_cast<std::uint64_t>(20 * work * std::pow(3, planner));
      row.times = {.preparation = 2e-3,
                   .first = static_cast<double>(row.expanded) * 2e-7,
                   .later = static_cast<double>(row.expanded) * 1e-7};
      if (planner + 1 == planners.size() && random.chance(0.4)) row.status = Status::step_limit;
      query.rows.push_back(row);
    }
    comparison.queries.push_back(query);
  }
  return comparison;
}

const std::vector<std::string> kPlanners{"astar", "astar:weight=2", "dijkstra", "random_walk"};

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class Gnuplot : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v gnuplot > /dev/null") != 0) GTEST_SKIP() << "gnuplot is missing";
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// The picture; a complaint of gnuplot is a failure.
  std::string drawn(const std::string& script) const {
    std::ofstream(folder_ / "script") << script;
    const std::string run = "cd '" + folder_.string() + "' && gnuplot script > picture 2> errors";
    EXPECT_EQ(std::system(run.c_str()), 0);
    EXPECT_THAT(text_of(folder_ / "errors"), IsEmpty());
    return text_of(folder_ / "picture");
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) / ("wend_gnuplot_" + std::to_string(getpid()));
};

TEST_F(Gnuplot, DrawsEveryKindOfPicture) {
  const Comparison comparison = made_up(kPlanners, 40, 2);
  const auto picture = [&](PlotKind kind) { return drawn(comparison_plot(comparison, kind)); };
  EXPECT_THAT(picture(PlotKind::png), StartsWith("\x89PNG"));
  EXPECT_THAT(picture(PlotKind::pdf), StartsWith("%PDF"));
  const std::string svg = picture(PlotKind::svg);
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  for (const std::string& planner : kPlanners) EXPECT_THAT(svg, HasSubstr(planner));
  for (const char* label :
       {"path length, m", "expansions", "queries solved, %", "first query, CPU time, ms",
        "later queries, CPU time, ms", "astar, 2 ms to prepare"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
}

TEST_F(Gnuplot, DrawsWhatIsOddWithoutComplaint) {
  const auto svg = [&](const Comparison& comparison) {
    return drawn(comparison_plot(comparison, PlotKind::svg, kDarkPlot));
  };
  EXPECT_THAT(svg({}), HasSubstr("on 0 queries"));
  EXPECT_THAT(svg(made_up({"a"}, 1, 1)), HasSubstr("on 1 query"));
  Comparison failed = made_up({"a", "b"}, 3, 1);
  for (ComparedQuery& query : failed.queries) query.rows[0].status = Status::unreachable;
  svg(failed);
  for (ComparedQuery& query : failed.queries) query.rows[1].status = Status::unreachable;
  svg(failed);
  Comparison idle = made_up({"a"}, 2, 1);
  for (ComparedQuery& query : idle.queries) query.rows = {{.planner = "a", .times = {0, 0, 0}}};
  svg(idle);
}

TEST_F(Gnuplot, TakesNamesAsTheyAre) {
  const std::vector<std::string> names{"it's", "a_b^2", "\"{/Bold x}\"", "back\\slash", "$x;`id`"};
  const std::string svg = drawn(comparison_plot(made_up(names, 5, 1), PlotKind::svg));
  EXPECT_THAT(svg, HasSubstr("it's"));
  EXPECT_THAT(svg, HasSubstr("a_b^2"));
  EXPECT_THAT(svg, HasSubstr("{/Bold x}"));
  EXPECT_THAT(svg, HasSubstr("back\\slash"));
  EXPECT_THAT(svg, HasSubstr("$x;`id`"));
}

TEST(ComparisonPlot, IsLogarithmicWhereValuesSpanDecades) {
  const std::string wide = comparison_plot(made_up({"a"}, 50, 2), PlotKind::png);
  EXPECT_THAT(wide, HasSubstr("\nset logscale y"));
  EXPECT_THAT(wide, HasSubstr("\nset logscale x"));
  const std::string narrow = comparison_plot(made_up({"a"}, 50, 0.2), PlotKind::png);
  EXPECT_THAT(narrow, Not(HasSubstr("\nset logscale")));
}

TEST(ComparisonPlot, HasEverySolvedQueryAndSharesOfAll) {
  const auto row = [](double length, double seconds, Status status) {
    return ComparisonRow{.planner = "a",
                         .status = status,
                         .length = length,
                         .expanded = 3,
                         .times = {1e-6, 2 * seconds, seconds}};
  };
  const Comparison comparison{{},
                              {{{}, {Pose{}}, {row(7, 5e-6, Status::found)}},
                               {{}, {Pose{}}, {row(0, 9e-6, Status::unreachable)}},
                               {{}, {Pose{}}, {row(8, 4e-6, Status::found)}},
                               {{}, {Pose{}}, {row(9, 6e-6, Status::found)}}}};
  const std::string script = comparison_plot(comparison, PlotKind::png);
  EXPECT_THAT(script, HasSubstr("$points0 << END\n7 10 5 3\n8 8 4 3\n9 12 6 3\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$later0 << END\n0 0\n4 25\n5 50\n6 75\n"));
  EXPECT_THAT(script, HasSubstr("$first0 << END\n0 0\n8 25\n10 50\n12 75\n"));
}

TEST(ComparisonPlot, LeavesOutTimesThatWereNotTaken) {
  Comparison comparison = made_up({"a"}, 3, 1);
  comparison.queries[1].rows[0].times = {};
  const std::string script = comparison_plot(comparison, PlotKind::png);
  EXPECT_THAT(script, HasSubstr("a, 2 ms to prepare"));
  const std::string distribution = script.substr(script.find("$first0"));
  EXPECT_THAT(distribution.substr(0, distribution.find("END\n$")), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace wend
