// wend-planner-page: writes docs/planners.md and its pictures.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "docs/planner_page/data_families.hpp"
#include "docs/planner_page/page.hpp"
#include "docs/planner_page/registry_part.hpp"
#include "wend/io/files.hpp"

namespace wend::planner_page {
namespace {

namespace fs = std::filesystem;

/// Everything that the page measures; an error says what was wrong with the data.
Expected<Measurements, IoError> measure_all(Effort effort, const fs::path& data) {
  Measurements measurements;
  measurements.with_data = effort == Effort::full && !data.empty();
  std::vector<Family> from_data;
  if (measurements.with_data) {
    auto loaded = data_families(data);
    if (!loaded) return Unexpected<IoError>(loaded.error());
    from_data = *std::move(loaded);
  }
  std::vector<Family> families = generated_families(effort);
  families.insert(families.end(), from_data.begin(), from_data.end());
  for (const Family& family : families) {
    fmt::print(stderr, "{}\n", family.title);
    measurements.families.push_back(measure_planners(family, effort));
  }
  measurements.small = measure_planners(small_family(effort), effort);
  measurements.no_path = measure_planners(unreachable_family(effort), effort);
  measurements.clearance_distance = study_clearance_distance(effort);
  measurements.drives = study_drives(effort);
  return measurements;
}

Expected<void, IoError> write_all(const fs::path& folder, const std::vector<Picture>& pictures,
                                  const std::string& text) {
  const fs::path images = folder / kImages;
  std::error_code error;
  fs::create_directories(images, error);
  if (error) return Unexpected<IoError>({images.string(), 0, error.message()});
  for (const Picture& picture : pictures) {
    const auto written = write_file(images / (picture.planner + ".png"), picture.png);
    if (!written) return written;
  }
  return write_file(folder / "planners.md", text);
}

int complain(const std::string& what) {
  fmt::print(stderr, "{}\n", what);
  return 2;
}

int run(const fs::path& folder, Effort effort, const fs::path& data) {
  const auto pictures = pictures_of_planners();
  if (!pictures) return complain(pictures.error().message());
  const auto measurements = measure_all(effort, data);
  if (!measurements) return complain(measurements.error().message());
  const auto written = write_all(folder, *pictures, page(*pictures, *measurements));
  if (!written) return complain(written.error().message());
  return 0;
}

}  // namespace
}  // namespace wend::planner_page

int main(int argc, char** argv) {
  std::filesystem::path folder;
  std::filesystem::path data = WEND_DATA;  // empty where the build found no data
  bool quick = false;
  CLI::App app("Writes planners.md and its pictures: what each planner is, and how they compare.");
  app.add_option("OUTPUT_FOLDER", folder, "where planners.md and images/ go")->required();
  app.add_flag("--quick", quick, "small maps of our own and few queries: to see that it works");
  app.add_option("--data", data, "folder with real maps; empty: only maps of our own")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  using wend::planner_page::Effort;
  return wend::planner_page::run(folder, quick ? Effort::quick : Effort::full, data);
}
