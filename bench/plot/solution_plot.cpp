#include "bench/plot/solution_plot.hpp"

#include <algorithm>

#include "bench/plot/plot_page.hpp"

namespace wend {
namespace {

constexpr double kMillisecondsOfASecond = 1e3;
constexpr double kMarginOfCosts = 0.05;  // of the range of costs

// In pixels.
constexpr double kSolutionLeft = 125;
constexpr double kSolutionRight = 45;
constexpr double kSolutionBottom = 105;
constexpr double kSolutionHeight = 480;

double lower_bound_of(const TimedSolution& solution) { return solution.cost / solution.bound; }

PlotAxis cost_axis(std::span<const TimedSolution> solutions) {
  const double greatest = solutions.front().cost;
  const double least = lower_bound_of(solutions.front());
  const double margin = greatest > least ? kMarginOfCosts * (greatest - least) : 1;
  return {.label = "cost", .least = std::max(0.0, least - margin), .greatest = greatest + margin};
}

}  // namespace

std::string solution_plot(std::span<const TimedSolution> solutions, PlotKind kind,
                          const PlotColours& colours) {
  PlotPage page(kind, colours, {"the best path", "lower bound"}, kSolutionBottom + kSolutionHeight);
  page.put_page();
  page.put("$solutions << END\n");
  for (const TimedSolution& solution : solutions) {
    page.put("{} {} {}\n", kMillisecondsOfASecond * solution.seconds, solution.cost,
             lower_bound_of(solution));
  }
  page.put("END\nunset key\n");
  const double last = kMillisecondsOfASecond * solutions.back().seconds;
  page.put_panel({kSolutionLeft, kSolutionBottom, PlotPage::kWidth - kSolutionLeft - kSolutionRight,
                  kSolutionHeight},
                 {.label = "time of the search, ms", .greatest = last > 0 ? 1.02 * last : 1},
                 cost_axis(solutions));
  page.put_legend("Paths until the best is found");
  page.put("plot $solutions using 1:2 with steps {} notitle", page.line_look(0));
  page.put(", \\\n  $solutions using 1:2 with points {} notitle", page.point_look(0));
  page.put(", \\\n  $solutions using 1:3 with steps {} notitle", page.line_look(1));
  page.put(", \\\n  $solutions using 1:3 with points {} notitle\n", page.point_look(1));
  return page.take();
}

}  // namespace wend
