// wend-planner-page: writes docs/planners.md and its pictures.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "docs/planner_page/clearance_cost.hpp"
#include "docs/planner_page/driving.hpp"
#include "docs/planner_page/page.hpp"
#include "wend/io/files.hpp"

namespace wend::planner_page {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  fs::path folder;
  fs::path data = WEND_DATA;  // empty where the build found no data
  bool quick = false;
  bool registry_only = false;
};

/// Everything that the page measures; an error says what was wrong with the data.
Expected<Measurements, Error> measure_all(Effort effort, const fs::path& data) {
  Measurements measurements;
  std::vector<BenchmarkMap> maps = generated_maps(effort);
  if (effort == Effort::full && !data.empty()) {
    const auto more = movingai_maps(data);
    if (!more) return Unexpected<Error>(more.error());
    maps.insert(maps.end(), more->begin(), more->end());
    measurements.with_movingai_maps = true;
  }
  for (const BenchmarkMap& map : maps) {
    fmt::print(stderr, "{}\n", map.title);
    measurements.maps.push_back(measure_planners(map, effort));
  }
  measurements.clearance_cost = clearance_cost_section(effort);
  measurements.driving = driving_section(effort);
  return measurements;
}

Expected<std::string, Error> page_of(const Arguments& arguments,
                                     const std::vector<Picture>& pictures) {
  if (!arguments.registry_only) {
    const Effort effort = arguments.quick ? Effort::quick : Effort::full;
    const auto measurements = measure_all(effort, arguments.data);
    if (!measurements) return Unexpected<Error>(measurements.error());
    return planners_page(pictures, *measurements);
  }
  const fs::path file = arguments.folder / "planners.md";
  const auto earlier = read_file(file);
  if (!earlier) return Unexpected<Error>(earlier.error());
  auto page = with_new_registry_part(*earlier, pictures);
  if (!page)
    return file_failure(file.string(), 0, "the comments around the registry part are missing");
  return *std::move(page);
}

Expected<void, Error> write_all(const fs::path& folder, const std::vector<Picture>& pictures,
                                const std::string& page) {
  const fs::path images = folder / kImages;
  std::error_code error;
  fs::create_directories(images, error);
  if (error) return file_failure(images.string(), 0, error.message());
  for (const Picture& picture : pictures) {
    const auto written = write_file(images / (picture.planner + ".png"), picture.png);
    if (!written) return written;
  }
  return write_file(folder / "planners.md", page);
}

int complain(const std::string& what) {
  fmt::print(stderr, "{}\n", what);
  return 2;
}

int run(const Arguments& arguments) {
  const auto pictures = pictures_of_planners();
  if (!pictures) return complain(pictures.error().message);
  const auto page = page_of(arguments, *pictures);
  if (!page) return complain(page.error().message);
  const auto written = write_all(arguments.folder, *pictures, *page);
  return written ? 0 : complain(written.error().message);
}

}  // namespace
}  // namespace wend::planner_page

int main(int argc, char** argv) {
  wend::planner_page::Arguments arguments;
  CLI::App app("Writes planners.md and its pictures: what each planner is, and how they compare.");
  app.add_option("OUTPUT_FOLDER", arguments.folder, "where planners.md and images/ go")->required();
  auto* const quick = app.add_flag("--quick", arguments.quick,
                                   "small generated maps and few queries: to test the program");
  app.add_flag(
         "--registry-only", arguments.registry_only,
         "measure nothing: refresh the registry part and the pictures of the page that is there")
      ->excludes(quick);
  app.add_option("--data", arguments.data, "folder with MovingAI maps; empty: only generated maps")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return wend::planner_page::run(arguments);
}
