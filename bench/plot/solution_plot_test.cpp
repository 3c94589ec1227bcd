#include "bench/plot/solution_plot.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace wend {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(SolutionPlot, HasTheCostAndTheLowerBoundOfEachPath) {
  const std::vector<TimedSolution> solutions{
      {0.001, 12, 3, 20}, {0.0025, 10, 1.25, 60}, {0.004, 9, 1, 90}};
  const std::string script = solution_plot(solutions, PlotKind::svg);
  EXPECT_THAT(script, StartsWith("set encoding utf8\nset terminal svg "));
  EXPECT_THAT(script, HasSubstr("$solutions << END\n1 12 4\n2.5 10 8\n4 9 9\nEND\n"));
  for (const char* label :
       {"'cost'", "'time of the search, ms'", "'the best path'", "'lower bound'"}) {
    EXPECT_THAT(script, HasSubstr(label));
  }
}

TEST(SolutionPlot, ShowsAPathThatIsFoundAtOnce) {
  const std::vector<TimedSolution> solutions{{0, 5, 1, 6}};
  EXPECT_THAT(solution_plot(solutions, PlotKind::png),
              HasSubstr("$solutions << END\n0 5 5\nEND\n"));
}

}  // namespace
}  // namespace wend
