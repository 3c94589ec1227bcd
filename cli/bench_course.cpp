#include "bench_course.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "exit_code.hpp"
#include "wend/io/load_map.hpp"

namespace wend::cli {
namespace {

namespace fs = std::filesystem;

template <class T>
T value_or_throw(Expected<T, IoError> result) {
  if (!result) throw InputError(result.error().message());
  return *std::move(result);
}

std::vector<fs::path> scenario_files(const std::vector<std::string>& files_and_folders) {
  std::vector<fs::path> files;
  for (const std::string& name : files_and_folders) {
    std::error_code error;  // what is not there is no folder
    if (!fs::is_directory(name, error)) {
      files.emplace_back(name);
      continue;
    }
    const std::vector<fs::path> inside = value_or_throw(scenarios_in(name));
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

Course load_course(const fs::path& file, const std::string& map_file, std::size_t sample) {
  Scenario scenario = value_or_throw(load_scenario(file));
  const fs::path map_path =
      map_file.empty() ? value_or_throw(scenario_map_path(scenario)) : fs::path(map_file);
  LoadedMap loaded = value_or_throw(load_map(map_path));
  const auto fits = check_map_size(scenario, loaded.map.width(), loaded.map.height());
  if (!fits) throw InputError(fits.error().message());
  if (sample > 0) scenario.queries = evenly_sampled(scenario.queries, sample);
  return {std::move(scenario), map_path.stem().string(), std::move(loaded.map)};
}

}  // namespace

std::vector<Course> load_courses(const std::vector<std::string>& files_and_folders,
                                 const std::string& map_file, std::size_t sample) {
  std::vector<Course> courses;
  for (const fs::path& file : scenario_files(files_and_folders)) {
    courses.push_back(load_course(file, map_file, sample));
  }
  return courses;
}

}  // namespace wend::cli
