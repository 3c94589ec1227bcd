#include "plan_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace wend::cli {
namespace {

std::string line(std::string_view name, const std::string& what) {
  return fmt::format("{:<10}{}\n", name, what);
}

std::string length_text(double cells, const Frame& frame) {
  std::string text = fmt::format("{:.6g} cells", cells);
  if (frame.metric) text += fmt::format(", {:.6g} m", cells * frame.resolution);
  return text;
}

std::string bound_text(const Plan& plan) {
  if (plan.optimal()) return "no path is cheaper";
  if (std::isfinite(plan.bound)) return fmt::format("at most {:g} times the optimum", plan.bound);
  return "no claim: a cheaper path may exist";
}

}  // namespace

std::string time_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.1f} us", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.2f} ms", seconds * 1e3);
  return fmt::format("{:.2f} s", seconds);
}

std::string path_line(const Path& path) {
  std::string text;
  for (const Cell cell : path.cells()) {
    if (!text.empty()) text += '>';
    text += cell_text(cell);
  }
  return text + '\n';
}

std::string goal_line(const std::string& goal, std::size_t goals) {
  return line("goal", fmt::format("{}, of {} goals", goal, goals));
}

std::string plan_summary(const PlanResult& result, const Frame& frame) {
  const Plan& plan = result.plan;
  return line("planner", result.planner) + line("cost", fmt::format("{:.6g}", plan.cost)) +
         line("length", length_text(plan.path.length(), frame)) +
         line("quality", bound_text(plan)) + work_lines(plan.metrics, result.seconds);
}

std::string work_lines(const SearchMetrics& metrics, double seconds) {
  return line("expanded", fmt::format("{} cells ({} generated, frontier up to {})",
                                      metrics.expanded, metrics.generated, metrics.max_frontier)) +
         line("time", time_text(seconds));
}

}  // namespace wend::cli
