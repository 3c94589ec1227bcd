#include "cli/arguments/planner_argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/base/parse.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/lattice/lattice_options.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/session.hpp"

namespace wend::cli {
namespace {

constexpr std::uint64_t kSteps = 1000;  // of the progress bar of an index

IndexBuilding told_to(ProgressBar& bar, Workers& workers) {
  return {&workers, [&bar](double share) {
            bar.update(static_cast<std::uint64_t>(static_cast<double>(kSteps) * share));
          }};
}

}  // namespace

std::vector<PlannerSpec> parse_planners(const std::string& text) {
  return value_or_throw(parse_planner_specs(text));
}

PlannerSpec parse_planner(const std::string& text) {
  const std::vector<PlannerSpec> specs = parse_planners(text);
  if (specs.size() > 1)
    throw InputError(fmt::format("--planner {}: --planner takes exactly one planner", text));
  return specs.front();
}

const PlannerInfo& info_of(const PlannerSpec& planner) { return *planners().find(planner.name); }

bool has_option(const std::vector<OptionInfo>& options, std::string_view name) {
  return std::ranges::find(options, name, &OptionInfo::name) != options.end();
}

Expected<GivenIndex, Error> read_given_index(const std::string& file) {
  auto bytes = open_index(file);
  if (!bytes) throw InputError(bytes.error().message);
  const auto header = read_index_header(bytes->bytes());
  if (!header) {
    return failure(Status::index_mismatch, fmt::format("{}: {}", file, header.error().message),
                   file);
  }
  return GivenIndex{file, *header, *std::move(bytes)};
}

Expected<IndexBytes, Error> build_index(const PlannerInfo& planner, const FreeSpace& space,
                                        Workers& workers) {
  ProgressBar bar("index of " + planner.name, kSteps);
  return planner.index_support->build(space, told_to(bar, workers));
}

std::string planners_with_index() {
  std::vector<std::string> names;
  for (const PlannerInfo& planner : planners()) {
    if (planner.index_support) names.push_back(planner.name);
  }
  return or_list(names);
}

Expected<bool, Error> provide_index(Session& session, const PlannerSpec& planner,
                                    const IndexArgument& given, WorkTimes& times,
                                    const Deadline& deadline) {
  if (given) {
    if (!*given) return Unexpected<Error>(given->error());
    session.set_index(planner.name, (*given)->bytes);
    return false;
  }
  if (!info_of(planner).index_support) return false;
  ProgressBar bar("index of " + planner.name, kSteps);
  ThreadWorkers workers;
  IndexBuilding building = told_to(bar, workers);
  if (deadline.bounded()) building.deadline = &deadline;
  const auto built = timed(process_cpu_seconds, times.index.emplace(0),
                           [&] { return session.build_index(planner.name, building); });
  if (!built && deadline.passed()) {
    return failure(deadline.status(),
                   deadline.text() + ", before the index of " + planner.name + " was built");
  }
  if (!built) return Unexpected<Error>(built.error());
  return true;
}

}  // namespace wend::cli
