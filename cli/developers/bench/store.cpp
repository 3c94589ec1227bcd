#include "cli/developers/bench/store.hpp"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "bench/database/bench_database.hpp"
#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

template <class T>
T stored(Expected<T, Error> result) {
  if (!result) throw InputError("--database " + result.error().message);
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::optional<BenchDatabase> open_if_there(const std::string& file) {
  std::error_code error;  // if this fails, opening the file fails too and says why
  if (!std::filesystem::exists(file, error) && !error) return std::nullopt;
  return stored(BenchDatabase::open(file));
}

namespace fs = std::filesystem;

constexpr const char* kMark = ".rank";

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char letter) {
    return letter >= '0' && letter <= '9';
  });
}

std::vector<fs::path> shards_of(const fs::path& database) {
  const std::string begin = database.filename().string() + kMark;
  const fs::path folder = database.has_parent_path() ? database.parent_path() : ".";
  std::vector<fs::path> shards;
  std::error_code error;  // a missing folder has no shards
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && is_number(name.substr(begin.size()))) {
      shards.push_back(entry.path());
    }
  }
  std::sort(shards.begin(), shards.end());
  return shards;
}

BenchDatabase open(const fs::path& file) {
  auto database = BenchDatabase::open(file);
  if (!database) throw InputError("--database " + database.error().message);
  return *std::move(database);
}

}  // namespace

BenchStore::BenchStore(const std::string& file) : file_(file), known_(open_if_there(file)) {}

BenchStore::BenchStore(const std::string& file, const std::string& shard)
    : file_(shard), known_(open_if_there(file)), shard_(open_if_there(shard)), is_shard_(true) {}

void BenchStore::begin(const BenchScenario& scenario, const FreeSpace& space,
                       const BenchSettings& settings) {
  const BenchConditions conditions = settings.conditions();
  experiment_ = {
      .map = scenario.map_name,
      .width = scenario.map.width(),
      .height = scenario.map.height(),
      .free_cells = space.passable().count(),
      .scenario = std::filesystem::path(scenario.file).filename().string(),
      .fingerprint = scenario.fingerprint,
      .threads = static_cast<unsigned>(settings.threads),
      .version = "wend " + conditions.version,
      .commit = conditions.commit,
      .conditions = conditions.robot + (settings.fresh ? "\na new planner for every query" : ""),
      .limit_s = conditions.limit_s,
      .host = host_name(),
      .machine = conditions.machine};
}

BenchRecord BenchStore::known(const std::string& entry) {
  if (!known_) return {};
  return stored(
      known_->record(stored(known_->experiment(experiment_)), stored(known_->planner(entry))));
}

void BenchStore::keep(const std::string& entry, std::span<const BenchAnswer> answers,
                      const BenchIndex& index) {
  if (file_.empty() || answers.empty()) return;
  BenchDatabase& database = written();
  const std::int64_t experiment = stored(database.experiment(experiment_));
  const std::int64_t planner = stored(database.planner(entry));
  stored(database.store(experiment, planner, answers, index));
}

BenchDatabase& BenchStore::written() {
  std::optional<BenchDatabase>& database = is_shard_ ? shard_ : known_;
  if (!database) database = stored(BenchDatabase::open(file_));
  return *database;
}

std::string shard_file(const std::string& database, int rank) {
  return database + kMark + std::to_string(rank);
}

void merge_shards(const std::string& database) {
  const std::vector<fs::path> shards = shards_of(database);
  if (shards.empty()) return;
  BenchDatabase whole = open(database);
  for (const fs::path& shard : shards) {
    const auto merged = whole.merge(open(shard));
    if (!merged) throw InputError("--database " + merged.error().message);
    fs::remove(shard);
  }
}

}  // namespace wend::cli
