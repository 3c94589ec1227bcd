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
    : database_(value_or_throw(BenchDatabase::open(file))) {}

void BenchStore::begin(const Course& course, const FreeSpace& space, unsigned threads) {
  if (!database_) return;
  experiment_ = value_or_throw(database_->experiment(
      {.map = course.map_name,
       .width = course.map.width(),
       .height = course.map.height(),
       .free_cells = space.passable().count(),
       .scenario = std::filesystem::path(course.scenario.file).filename().string(),
       .fingerprint = course.fingerprint,
       .threads = threads,
       .version = "wend " WEND_VERSION,
       .host = host_name(),
       .machine = describe_machine()}));
}

BenchRecord BenchStore::known(const std::string& contestant) {
  if (!database_) return {};
  return value_or_throw(
      database_->record(experiment_, value_or_throw(database_->planner(contestant))));
}

void BenchStore::keep(const std::string& contestant, std::span<const BenchAnswer> answers,
                      const BenchIndex& index) {
  if (!database_) return;
  const std::int64_t planner = value_or_throw(database_->planner(contestant));
  value_or_throw(database_->store(experiment_, planner, answers, index));
}

}  // namespace wend::cli
