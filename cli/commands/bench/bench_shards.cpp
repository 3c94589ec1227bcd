#include "cli/commands/bench/bench_shards.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "bench/database/bench_database.hpp"
#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

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
  std::error_code error;  // a folder that is not there has none
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
  if (!database) throw InputError("--database " + database.error().message());
  return *std::move(database);
}

}  // namespace

std::string shard_file(const std::string& database, int rank) {
  return database + kMark + std::to_string(rank);
}

void merge_shards(const std::string& database) {
  const std::vector<fs::path> shards = shards_of(database);
  if (shards.empty()) return;
  BenchDatabase whole = open(database);
  for (const fs::path& shard : shards) {
    const auto merged = whole.merge(open(shard));
    if (!merged) throw InputError("--database " + merged.error().message());
    fs::remove(shard);
  }
}

}  // namespace wend::cli
