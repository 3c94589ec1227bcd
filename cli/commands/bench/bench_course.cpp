#include "cli/commands/bench/bench_course.hpp"

#include <bit>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/exit_code.hpp"
#include "wend/index/file/index_header.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/map/free_space.hpp"

namespace wend::cli {
namespace {

namespace fs = std::filesystem;

template <class T>
T loaded_or_throw(Expected<T, IoError> result) {
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
    const std::vector<fs::path> inside = loaded_or_throw(scenarios_in(name));
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

/// FNV-1a over numbers.
class Fingerprint {
 public:
  void add(std::uint64_t number) { hash_ = (hash_ ^ number) * 0x100000001B3; }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

std::uint64_t fingerprint_of(const Scenario& scenario, const GridMap& map) {
  Fingerprint fingerprint;
  fingerprint.add(map_hash(FreeSpace(map).passable()));
  for (const ScenarioQuery& query : scenario.queries) {
    for (const Cell cell : {query.start, query.goal}) {
      fingerprint.add(static_cast<std::uint64_t>(cell.x));
      fingerprint.add(static_cast<std::uint64_t>(cell.y));
    }
    fingerprint.add(query.line);
    fingerprint.add(std::bit_cast<std::uint64_t>(query.length));
  }
  return fingerprint.value();
}

Course load_course(const fs::path& file, const std::string& map_file, std::size_t sample) {
  Scenario scenario = loaded_or_throw(load_scenario(file));
  const fs::path map_path =
      map_file.empty() ? loaded_or_throw(scenario_map_path(scenario)) : fs::path(map_file);
  LoadedMap loaded = loaded_or_throw(load_map(map_path));
  const auto fits = check_map_size(scenario, loaded.map.width(), loaded.map.height());
  if (!fits) throw InputError(fits.error().message());
  const std::uint64_t fingerprint = fingerprint_of(scenario, loaded.map);
  scenario.queries = evenly_sampled(scenario.queries, sample);
  return {std::move(scenario), map_path.stem().string(), std::move(loaded.map),
          std::move(loaded.files), fingerprint};
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
