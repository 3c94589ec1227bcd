#include "cli/arguments/index_argument.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

Expected<GivenIndex, std::string> read_given_index(const std::string& file) {
  auto bytes = open_index(file);
  if (!bytes) throw InputError(bytes.error().message());
  const auto header = read_index_header(bytes->bytes());
  if (!header) return Unexpected<std::string>(fmt::format("{}: {}", file, header.error()));
  return GivenIndex{file, *header, *std::move(bytes)};
}

Expected<IndexBytes, PlannerError> build_index(const PlannerInfo& planner, const FreeSpace& space,
                                               Workers& workers) {
  constexpr double kSteps = 1000;
  ProgressBar bar("index of " + planner.name, static_cast<std::uint64_t>(kSteps));
  const IndexBuilding building{
      &workers, [&](double share) { bar.update(static_cast<std::uint64_t>(kSteps * share)); }};
  return planner.index_support->build(space, building);
}

std::string planners_with_index() {
  std::vector<std::string> names;
  for (const PlannerInfo& planner : planners()) {
    if (planner.index_support) names.push_back(planner.name);
  }
  return or_list(names);
}

}  // namespace wend::cli
