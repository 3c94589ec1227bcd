#include "cli/arguments/planner_maker.hpp"

#include <utility>

#include "cli/arguments/planner_argument.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

PlannerMaker::PlannerMaker(PlannerSpec spec, FreeSpace space,
                           std::optional<Expected<GivenIndex, std::string>> given)
    : spec_(std::move(spec)), space_(std::move(space)), given_(std::move(given)) {}

PlannerResult PlannerMaker::make(WorkTimes& times) {
  if (given_ && !*given_) {
    return Unexpected<PlannerError>({Status::index_mismatch, given_->error()});
  }
  const PlannerInfo& info = info_of(spec_);
  if (!given_ && !built_ && info.index_support) {
    ThreadWorkers workers;
    auto index = timed(process_cpu_seconds, times.index.emplace(0),
                       [&] { return build_index(info, space_, workers); });
    if (!index) return Unexpected<PlannerError>(index.error());
    built_ = *std::move(index);
  }
  return timed(thread_cpu_seconds, times.planner.emplace(0), [&] {
    if (given_) return make_planner(spec_.name, space_, spec_.options, (*given_)->bytes);
    return built_ ? info.index_support->make_planner(space_, spec_.options, *built_)
                  : info.make(space_, spec_.options);
  });
}

}  // namespace wend::cli
