#include "bench_store.hpp"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <utility>

#include "exit_code.hpp"
#include "wend/report/machine.hpp"

namespace wend::cli {
namespace {

template <class T>
T value_or_throw(Expected<T, IoError> result) {
  if (!result) throw InputError("--database " + result.error().message());
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

BenchStore::BenchStore(const std::string& file)
    : known_(value_or_throw(BenchDatabase::open(file))) {}

BenchStore::BenchStore(const std::string& file, const std::string& shard)
    : known_(value_or_throw(BenchDatabase::open(file))),
      shard_(value_or_throw(BenchDatabase::open(shard))) {}

void BenchStore::begin(const Course& course, const FreeSpace& space, unsigned threads) {
  if (!known_) return;
  experiment_ = {.map = course.map_name,
                 .width = course.map.width(),
                 .height = course.map.height(),
                 .free_cells = space.passable().count(),
                 .scenario = std::filesystem::path(course.scenario.file).filename().string(),
                 .fingerprint = course.fingerprint,
                 .threads = threads,
                 .version = "wend " WEND_VERSION,
                 .host = host_name(),
                 .machine = describe_machine()};
}

BenchRecord BenchStore::known(const std::string& contestant) {
  if (!known_) return {};
  return value_or_throw(known_->record(value_or_throw(known_->experiment(experiment_)),
                                       value_or_throw(known_->planner(contestant))));
}

void BenchStore::keep(const std::string& contestant, std::span<const BenchAnswer> answers,
                      const BenchIndex& index) {
  if (!known_) return;
  BenchDatabase& database = shard_ ? *shard_ : *known_;
  const std::int64_t experiment = value_or_throw(database.experiment(experiment_));
  const std::int64_t planner = value_or_throw(database.planner(contestant));
  value_or_throw(database.store(experiment, planner, answers, index));
}

}  // namespace wend::cli
