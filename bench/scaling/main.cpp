// wend-scaling: writes performance.md and its picture into a folder.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "bench/measure/command.hpp"
#include "bench/scaling/scaling_page.hpp"
#include "bench/scaling/scaling_run.hpp"
#include "wend/io/files.hpp"

namespace wend::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPicture = "images/scaling.svg";

/// Draws a gnuplot script into a file. False if gnuplot fails or is not installed.
bool draw(const std::string& script, const fs::path& file) {
  const std::string command = fmt::format("gnuplot > '{}'", file.string());
  // NOLINTNEXTLINE(bugprone-command-processor): the folder comes from who runs this
  std::FILE* const gnuplot = popen(command.c_str(), "w");
  if (gnuplot == nullptr) return false;
  std::fwrite(script.data(), 1, script.size(), gnuplot);
  return pclose(gnuplot) == 0;
}

int run(ScalingPlan plan, const fs::path& folder, int least, int largest) {
  for (int size = least; size <= largest; size *= 2) plan.sizes.push_back(size);
  const auto maps =
      run_scaling(plan, [](const std::string& next) { fmt::print(stderr, "{}\n", next); });
  if (!maps) {
    fmt::print(stderr, "{}\n", maps.error().message);
    return 2;
  }
  fs::create_directories((folder / kPicture).parent_path());
  const auto written = write_file(folder / "performance.md", scaling_page(plan, *maps, kPicture));
  if (!written) {
    fmt::print(stderr, "{}\n", written.error().message);
    return 2;
  }
  if (draw(scaling_plot(plan, *maps, PlotKind::svg), folder / kPicture)) return 0;
  std::fputs("the picture needs gnuplot (in Debian: gnuplot-nox)\n", stderr);
  return 1;
}

}  // namespace
}  // namespace wend::bench

int main(int argc, char** argv) {
  wend::bench::ScalingPlan plan;
  plan.kinds = {
      {"office", "office"}, {"rooms", "rooms"}, {"10 % random", "random", {{"density", "0.1"}}}};
  plan.planners = wend::bench::optimal_planners();
  std::string folder = "docs";
  int least = 512;
  int largest = 16384;
  CLI::App app("Measures how planners grow with the map and writes performance.md.");
  app.add_option("folder", folder, "where it is written")->capture_default_str();
  app.add_option("--planner", plan.planners, "names with commas between")->delimiter(',');
  app.add_option("--least", least, "cells a side of the smallest map")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  app.add_option("--largest", largest, "of the largest; each is twice the one before")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  app.add_option("--queries", plan.queries, "a map, at most")->capture_default_str();
  app.add_option("--query-seconds", plan.query_seconds, "a planner and map, after which it ends")
      ->capture_default_str();
  app.add_option("--build-seconds", plan.most_build_seconds, "the longest that an index may take")
      ->capture_default_str();
  return wend::bench::parse_and_run(
      app, argc, argv, [&] { return wend::bench::run(std::move(plan), folder, least, largest); });
}
