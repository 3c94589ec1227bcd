#include "cli/developers/bench/dynamic_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "bench/scenario/scenario_verdict.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/output.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/files.hpp"

namespace wend::cli {
namespace {

bool is_dynamic(const std::string& file) {
  std::error_code error;  // a missing file is reported when it is loaded
  if (std::filesystem::is_directory(file, error)) return false;
  const auto text = read_file(file);
  return text && is_dynamic_scenario(*text);
}

FreeSpace open_space(const DynamicScenario& scenario, const BenchSettings& settings) {
  const auto map = make_grid_map(Grid<CellState>(scenario.width, scenario.height, CellState::free));
  if (!map) throw InputError(map.error().message);
  return settings.robot.free_space(*map);
}

/// A planner on a map that changes.
class DynamicRun {
 public:
  DynamicRun(const DynamicScenario& scenario, const BenchEntry& entry,
             const BenchSettings& settings)
      : scenario_(scenario),
        entry_(entry),
        settings_(settings),
        space_(open_space(scenario, settings)),
        planner_(entry.make_planner(space_, entry.prepare(space_, {}))) {}

  BenchedMap run() {
    BenchedMap benched{entry_.name(), space_.passable().count(), {}, scenario_.file};
    for (const auto& command : scenario_.commands) {
      if (Interruptible::cancelled()) throw Cancelled();
      if (const auto* patch = std::get_if<PatchCommand>(&command)) {
        edit(*patch);
      } else {
        benched.answers.push_back(answer(std::get<ScenarioQuery>(command)));
      }
    }
    return benched;
  }

 private:
  void edit(const PatchCommand& patch) {
    if (!released_) planner_->release();
    released_ = true;
    const auto change = space_.edit(scenario_.edit_of(patch));
    if (!change) throw InputError(change.error().message);
    pending_.boxes.insert(pending_.boxes.end(), change->boxes.begin(), change->boxes.end());
    pending_.everything = pending_.everything || change->everything;
  }

  BenchAnswer answer(const ScenarioQuery& query) {
    Query asked = Query::between(query.start, query.goal);
    asked.limits.cancel = &Interruptible::cancelled();
    if (settings_.limit_s) {
      asked.limits.seconds = *settings_.limit_s;
      asked.limits.clock = thread_cpu_seconds;
    }
    const double begun = thread_cpu_seconds();
    if (released_) {
      if (const auto updated = planner_->update(space_, pending_); !updated) {
        throw InputError(fmt::format("{}: {}", entry_.name(), updated.error().message));
      }
    }
    released_ = false;
    pending_ = {};
    const Status status = planner_->plan(asked, plan_);
    const double seconds = thread_cpu_seconds() - begun;
    BenchAnswer answer{.line = query.line,
                       .status = status,
                       .length = status == Status::found ? plan_.cost : 0,
                       .expanded = plan_.metrics.expanded,
                       .seconds = {seconds}};
    judge(query, status, answer);
    return answer;
  }

  void judge(const ScenarioQuery& query, Status status, BenchAnswer& answer) {
    constexpr int kMostComplaints = 10;
    const std::string wrong = wrong_answer(space_, settings_.moves.moves, query, status, plan_,
                                           entry_.any_angle() ? PathKind::lines : PathKind::steps);
    if (wrong.empty()) return;
    answer.wrong = true;
    if (complaints_++ < kMostComplaints) {
      complain(fmt::format("{}:{}: {}: {}", scenario_.file, query.line, entry_.name(), wrong));
    }
  }

  const DynamicScenario& scenario_;
  const BenchEntry& entry_;
  const BenchSettings& settings_;
  FreeSpace space_;
  std::unique_ptr<Planner> planner_;
  bool released_ = false;
  SpaceChange pending_;  // since the planner was last told
  Plan plan_;
  int complaints_ = 0;
};

}  // namespace

std::vector<DynamicScenario> load_dynamic_scenarios(const std::vector<std::string>& files) {
  const auto count = std::ranges::count_if(files, is_dynamic);
  if (count == 0) return {};
  if (static_cast<std::size_t>(count) != files.size()) {
    throw InputError("scenarios of version 2, whose maps change, cannot be mixed with others");
  }
  std::vector<DynamicScenario> scenarios;
  scenarios.reserve(files.size());
  for (const std::string& file : files) {
    scenarios.push_back(value_or_throw(load_dynamic_scenario(file)));
  }
  return scenarios;
}

BenchedMap run_dynamic(const DynamicScenario& scenario, const BenchEntry& entry,
                       const BenchSettings& settings) {
  return DynamicRun(scenario, entry, settings).run();
}

}  // namespace wend::cli
