#include "bench/scenario/bench_plot.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace wend {
namespace {

using testing::HasSubstr;
using testing::Not;

BenchAnswer answer(double length, double seconds, Status status = Status::found) {
  return {.line = 2, .status = status, .length = length, .seconds = {2 * seconds, seconds}};
}

TEST(BenchPlot, HasEverySolvedQueryAndSharesOfAll) {
  const std::vector<BenchedMap> maps{
      {"a", 100, {answer(7, 5e-6), answer(0, 9e-6, Status::unreachable)}},
      {"a", 100, {answer(8, 4e-6), answer(9, 6e-6)}}};
  const std::string script = bench_plot(maps, PlotKind::png);
  EXPECT_THAT(script, HasSubstr("Planners on 4 queries"));
  EXPECT_THAT(script, HasSubstr("$points0 << END\n7 5\n8 4\n9 6\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$time0 << END\n0 0\n4 25\n5 50\n6 75\n"));
  EXPECT_THAT(script, Not(HasSubstr("free cells")));
}

TEST(BenchPlot, ShowsHowTimesGrowWithMaps) {
  const std::vector<BenchedMap> maps{{"a", 100, {answer(7, 2e-6), answer(7, 4e-6)}},
                                     {"b", 100, {answer(7, 1e-6)}},
                                     {"a", 400, {answer(7, 8e-6)}}};
  const std::string script = bench_plot(maps, PlotKind::svg, kDarkPlot);
  EXPECT_THAT(script, HasSubstr("free cells of the map"));
  EXPECT_THAT(script, HasSubstr("$sizes0 << END\n100 3\n400 8\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$sizes1 << END\n100 1\nEND\n"));
}

TEST(BenchPlot, LeavesPointsOutButNoneOfTheDistribution) {
  BenchedMap map{"a", 100};
  for (int i = 1; i <= 5000; ++i) map.answers.push_back(answer(i, 1e-6 * i));
  const std::string script = bench_plot(std::vector{map}, PlotKind::pdf);
  const std::size_t points = script.find("$points0");
  const std::size_t end = script.find("END\n", script.find('\n', points));
  EXPECT_EQ(std::count(script.begin() + static_cast<std::ptrdiff_t>(points),
                       script.begin() + static_cast<std::ptrdiff_t>(end), '\n'),
            2001);
  EXPECT_NE(script.find(" 99.98\n5 100\n"), std::string::npos);  // milliseconds
}

TEST(BenchPlot, IsThereWithoutAnyAnswer) {
  EXPECT_THAT(bench_plot({}, PlotKind::png), HasSubstr("Planners on 0 queries"));
  EXPECT_THAT(bench_plot(std::vector<BenchedMap>{{"a", 9}}, PlotKind::png), HasSubstr("$points0"));
}

}  // namespace
}  // namespace wend
