#include "wend/io/available_memory.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

using Bytes = std::optional<std::uint64_t>;

/// The number after a name in a file, or the number that is the whole file; nothing for "max".
Bytes number_in(const fs::path& file, std::string_view name = {}) {
  std::ifstream stream(file);
  for (std::string word; stream >> word;) {
    if (!name.empty() && word != name) continue;
    if (!name.empty()) stream >> word;
    return parse_integer<std::uint64_t>(word);
  }
  return std::nullopt;
}

/// The names of files in the two versions of control groups.
struct GroupFiles {
  std::string_view folder;
  std::string_view limit;
  std::string_view usage;
  std::string_view cached;  // in memory.stat: files, which make room when it is needed
};

constexpr GroupFiles kVersion1 = {"sys/fs/cgroup/memory", "memory.limit_in_bytes",
                                  "memory.usage_in_bytes", "total_cache"};
constexpr GroupFiles kVersion2 = {"sys/fs/cgroup", "memory.max", "memory.current", "file"};

Bytes left_in(const fs::path& group, const GroupFiles& files) {
  const Bytes limit = number_in(group / files.limit);
  const Bytes usage = number_in(group / files.usage);
  if (!limit || !usage) return std::nullopt;
  const std::uint64_t cached = number_in(group / "memory.stat", files.cached).value_or(0);
  const std::uint64_t used = *usage - std::min(*usage, cached);
  return *limit - std::min(*limit, used);
}

Bytes least(Bytes a, Bytes b) { return a && b ? std::min(*a, *b) : a ? a : b; }

/// The least memory left in a group and its parents. In a container the outermost visible group is its
/// own.
Bytes left_in_groups(const fs::path& top, const fs::path& group, const GroupFiles& files) {
  Bytes left = left_in(top, files);
  fs::path inner = top;
  for (const fs::path& part : group.relative_path()) {
    inner /= part;
    left = least(left, left_in(inner, files));
  }
  return left;
}

Bytes left_in_own_groups(const fs::path& root) {
  Bytes left;
  std::ifstream groups(root / "proc/self/cgroup");
  // "0::/user.slice", "4:memory:/docker/1f"
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    if (!controllers.empty() && controllers != "memory") continue;
    const GroupFiles& files = controllers.empty() ? kVersion2 : kVersion1;
    left = least(left, left_in_groups(root / files.folder, line.substr(second + 1), files));
  }
  return left;
}

}  // namespace

std::optional<std::uint64_t> available_memory(const fs::path& root) {
  constexpr std::uint64_t kKilobyte = 1024;
  Bytes system = number_in(root / "proc/meminfo", "MemAvailable:");
  if (system) *system *= kKilobyte;
  return least(system, left_in_own_groups(root));
}

}  // namespace wend
