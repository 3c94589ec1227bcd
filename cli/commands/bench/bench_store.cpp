#include "cli/commands/bench/bench_store.hpp"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <utility>

#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

template <class T>
T stored(Expected<T, IoError> result) {
  if (!result) throw InputError("--database " + result.error().message());
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::optional<BenchDatabase> open_if_there(const std::string& file) {
  std::error_code error;  // what cannot be looked at cannot be opened either, and says why
  if (!std::filesystem::exists(file, error) && !error) return std::nullopt;
  return stored(BenchDatabase::open(file));
}

}  // namespace

BenchStore::BenchStore(const std::string& file) : file_(file), known_(open_if_there(file)) {}

BenchStore::BenchStore(const std::string& file, const std::string& shard)
    : file_(shard), known_(open_if_there(file)), shard_(open_if_there(shard)), is_shard_(true) {}

void BenchStore::begin(const Course& course, const FreeSpace& space,
                       const BenchSettings& settings) {
  const BenchConditions conditions = settings.conditions();
  experiment_ = {
      .map = course.map_name,
      .width = course.map.width(),
      .height = course.map.height(),
      .free_cells = space.passable().count(),
      .scenario = std::filesystem::path(course.scenario.file).filename().string(),
      .fingerprint = course.fingerprint,
      .threads = static_cast<unsigned>(settings.threads),
      .version = "wend " + conditions.version,
      .commit = conditions.commit,
      .conditions = conditions.robot + (settings.fresh ? "\na new planner for every query" : ""),
      .limit_s = conditions.limit_s,
      .host = host_name(),
      .machine = conditions.machine};
}

BenchRecord BenchStore::known(const std::string& contestant) {
  if (!known_) return {};
  return stored(
      known_->record(stored(known_->experiment(experiment_)), stored(known_->planner(contestant))));
}

void BenchStore::keep(const std::string& contestant, std::span<const BenchAnswer> answers,
                      const BenchIndex& index) {
  if (file_.empty() || answers.empty()) return;
  BenchDatabase& database = written();
  const std::int64_t experiment = stored(database.experiment(experiment_));
  const std::int64_t planner = stored(database.planner(contestant));
  stored(database.store(experiment, planner, answers, index));
}

BenchDatabase& BenchStore::written() {
  std::optional<BenchDatabase>& database = is_shard_ ? shard_ : known_;
  if (!database) database = stored(BenchDatabase::open(file_));
  return *database;
}

}  // namespace wend::cli
