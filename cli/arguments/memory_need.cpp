#include "cli/arguments/memory_need.hpp"

#include <fmt/format.h>

#include "cli/exit_code.hpp"
#include "wend/base/status.hpp"

namespace wend::cli {
namespace {

/// "5.3 GB", "120 MB"
std::string size_of(double bytes) {
  const double megabytes = bytes / 1e6;
  return megabytes < 1000 ? fmt::format("{:.3g} MB", megabytes)
                          : fmt::format("{:.3g} GB", megabytes / 1000);
}

}  // namespace

void check_memory(const std::string& file, const GridMap& map, double need,
                  std::optional<double> available) {
  if (!available || need <= *available) return;
  const std::string reason = fmt::format(
      "{}: {} x {} cells need about {} of memory, and {} are available; a coarser map needs less, "
      "and --limit-memory MB tries all the same",
      file, map.width(), map.height(), size_of(need), size_of(*available));
  throw NoPathError(reason, {std::string(to_string(Status::memory_limit)), reason});
}

}  // namespace wend::cli
