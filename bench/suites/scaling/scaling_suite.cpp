// Writes performance.md and its picture into a folder.

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "bench/suites/scaling/scaling_page.hpp"
#include "bench/suites/scaling/scaling_run.hpp"
#include "bench/suites/suite.hpp"
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
  const auto maps = value_or_refuse(
      run_scaling(plan, [](const std::string& next) { fmt::print(stderr, "{}\n", next); }));
  fs::create_directories((folder / kPicture).parent_path());
  const auto written = write_file(folder / "performance.md", scaling_page(plan, maps, kPicture));
  if (!written) throw Refused(written.error().message);
  if (draw(scaling_plot(plan, maps, PlotKind::svg), folder / kPicture)) return 0;
  std::fputs("the picture needs gnuplot (in Debian: gnuplot-nox)\n", stderr);
  return 1;
}

}  // namespace

Measure add_scaling(CLI::App& app) {
  struct Arguments {
    ScalingPlan plan;
    std::string folder = "docs";
    int least = 512;
    int largest = 16384;
  };
  const auto arguments = std::make_shared<Arguments>();
  ScalingPlan& plan = arguments->plan;
  plan.kinds = {
      {"office", "office"}, {"rooms", "rooms"}, {"10 % random", "random", {{"density", "0.1"}}}};
  plan.planners = optimal_planners();
  app.add_option("folder", arguments->folder, "where it is written")->capture_default_str();
  app.add_option("--planner", plan.planners, "names with commas between")->delimiter(',');
  app.add_option("--least", arguments->least, "cells a side of the smallest map")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  app.add_option("--largest", arguments->largest, "of the largest; each is twice the one before")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  app.add_option("--queries", plan.queries, "a map, at most")->capture_default_str();
  app.add_option("--query-seconds", plan.query_seconds, "a planner and map, after which it ends")
      ->capture_default_str();
  app.add_option("--build-seconds", plan.most_build_seconds, "the longest that an index may take")
      ->capture_default_str();
  return [arguments] {
    return run(arguments->plan, arguments->folder, arguments->least, arguments->largest);
  };
}

}  // namespace wend::bench
