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
#include "wend/planner/lattice/car_planner.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

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

int unit_of(const PlannerSpec& planner, const Frame& frame) {
  std::int64_t unit = 1;
  for (const auto& [name, value] : planner.options) {
    if (name == "lattice_resolution" || name == "unit") {
      unit = parse_integer<int>(value).value_or(1);
    }
    if (name == "turning_radius") unit = unit_for(parse_number(value).value_or(0), frame);
  }
  return static_cast<int>(std::max<std::int64_t>(unit, 1));
}

bool has_option(const std::vector<OptionInfo>& options, std::string_view name) {
  return std::ranges::find(options, name, &OptionInfo::name) != options.end();
}

Expected<GivenIndex, std::string> read_given_index(const std::string& file) {
  auto bytes = open_index(file);
  if (!bytes) throw InputError(bytes.error().message);
  const auto header = read_index_header(bytes->bytes());
  if (!header) return Unexpected<std::string>(fmt::format("{}: {}", file, header.error()));
  return GivenIndex{file, *header, *std::move(bytes)};
}

Expected<IndexBytes, Error> build_index(const PlannerInfo& planner, const FreeSpace& space,
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

PlannerMaker::PlannerMaker(PlannerSpec spec, FreeSpace space,
                           std::optional<Expected<GivenIndex, std::string>> given)
    : spec_(std::move(spec)), space_(std::move(space)), given_(std::move(given)) {}

PlannerResult PlannerMaker::make(WorkTimes& times) {
  if (given_ && !*given_) {
    return failure(Status::index_mismatch, given_->error());
  }
  const PlannerInfo& info = info_of(spec_);
  if (!given_ && !built_ && info.index_support) {
    ThreadWorkers workers;
    auto index = timed(process_cpu_seconds, times.index.emplace(0),
                       [&] { return build_index(info, space_, workers); });
    if (!index) return Unexpected<Error>(index.error());
    built_ = *std::move(index);
  }
  return timed(thread_cpu_seconds, times.planner.emplace(0), [&] {
    if (given_) return make_planner(spec_.name, space_, spec_.options, (*given_)->bytes);
    return built_ ? info.index_support->make_planner(space_, spec_.options, *built_)
                  : info.make(space_, spec_.options);
  });
}

}  // namespace wend::cli
