#include "wend/planner/planners.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

#include "wend/base/mutex.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/index_support.hpp"

namespace wend {

#define WEND_PLANNER(name) PlannerInfo name##_planner();
#include "wend/planner/planners.def"

namespace {

using PlannerRegistry = Registry<PlannerInfo>;

/// Can it be typed in a list of planners and be a name in ROS?
bool is_planner_name(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && name.front() >= 'a' && std::ranges::all_of(name, fits);
}

/// Why a planner cannot be added to the others.
std::optional<Error> refusal(const PlannerInfo& planner, const std::vector<PlannerInfo>& others) {
  const std::string name = "'" + planner.name + "'";
  std::string why;
  if (!is_planner_name(planner.name)) {
    why = name +
          " is not a name of a planner: use lower case letters, digits and underscores, and "
          "begin with a letter";
  } else if (!planner.make) {
    why = "the planner " + name + " has no function `make`";
  } else if (std::ranges::find(others, planner.name, &PlannerInfo::name) != others.end()) {
    why = "there is already a planner " + name;
  } else {
    return std::nullopt;
  }
  return Error{Status::invalid_option, std::move(why), planner.name};
}

/// The registries: the first, and one for each time that planners were added. None is destroyed: readers need no lock.
class PlannerRegistries {
 public:
  PlannerRegistries() {
    publish({
#define WEND_PLANNER(name) name##_planner(),
#include "wend/planner/planners.def"
    });
  }

  const PlannerRegistry& newest() const { return *newest_.load(std::memory_order_acquire); }

  Expected<void, Error> add(std::vector<PlannerInfo> added) {
    const MutexLock lock(mutex_);
    std::vector<PlannerInfo> all(newest().begin(), newest().end());
    for (PlannerInfo& planner : added) {
      if (auto refused = refusal(planner, all)) return Unexpected<Error>(*std::move(refused));
      all.push_back(std::move(planner));
    }
    publish(std::move(all));
    return {};
  }

 private:
  void publish(std::vector<PlannerInfo> planners) {
    made_.push_back(std::make_unique<const PlannerRegistry>(std::move(planners)));
    newest_.store(made_.back().get(), std::memory_order_release);
  }

  Mutex mutex_;  // of who adds
  std::vector<std::unique_ptr<const PlannerRegistry>> made_;
  std::atomic<const PlannerRegistry*> newest_ = nullptr;
};

PlannerRegistries& registries() {
  static PlannerRegistries all;
  return all;
}

}  // namespace

const Registry<PlannerInfo>& planners() { return registries().newest(); }

Expected<void, Error> add_planners(std::vector<PlannerInfo> added) {
  return registries().add(std::move(added));
}

std::vector<std::string> planner_names(std::string_view motion) {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (info.motion == motion) names.push_back(info.name);
  }
  return names;
}

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options) {
  const auto info = planners().named("planner", name);
  if (!info) return Unexpected<Error>(info.error());
  return (*info)->make(space, options);
}

namespace {

bool is_stopped(Status status) {
  return status == Status::time_limit || status == Status::cancelled;
}

/// What make_planner() answers if an index is not finished before the deadline.
Error not_ready(const PlannerInfo& info, const Deadline& deadline) {
  return {deadline.status(),
          deadline.text() + ", before the planner " + info.name +
              " was ready: it prepares the whole map once; make it without a limit"};
}

PlannerResult make_before(const PlannerInfo& info, const FreeSpace& space,
                          const OptionValues& options, const Deadline& deadline) {
  if (!info.index_support) {
    if (!info.make_within) return info.make(space, options);
    // What is nearly ready is finished, so that the next call has it.
    constexpr double kSecondsToFinish = 0.01;
    const bool soon = info.preprocessing == Preprocessing::none;
    auto made =
        info.make_within(space, options, soon ? deadline.later(kSecondsToFinish) : deadline);
    if (!made && is_stopped(made.error().status))
      return Unexpected<Error>(not_ready(info, deadline));
    return made;
  }
  if (deadline.passed()) return Unexpected<Error>(not_ready(info, deadline));
  IndexBuilding building;
  building.deadline = &deadline;
  auto index = info.index_support->build(space, building);
  if (index) return info.index_support->make_planner(space, options, *std::move(index));
  if (is_stopped(index.error().status)) return Unexpected<Error>(not_ready(info, deadline));
  return Unexpected<Error>(std::move(index.error()));
}

}  // namespace

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options, const Deadline& deadline) {
  const auto info = planners().named("planner", name);
  if (!info) return Unexpected<Error>(info.error());
  if (!deadline.bounded()) return (*info)->make(space, options);
  return make_before(**info, space, options, deadline);
}

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options, IndexBytes index) {
  const auto info = planners().named("planner", name);
  if (!info) return Unexpected<Error>(info.error());
  if (!(*info)->index_support) {
    return failure(Status::invalid_option, std::string(name) + " does not use an index");
  }
  return (*info)->index_support->make_planner(space, options, std::move(index));
}

PlannerSpec without_leaps(PlannerSpec planner) {
  constexpr std::string_view kLeaps = "leaps";
  const PlannerInfo* const info = planners().find(planner.name);
  if (info == nullptr || !info->capabilities.leaps) return planner;
  const auto says = [&](const auto& option) { return option.first == kLeaps; };
  if (std::ranges::none_of(planner.options, says)) planner.options.emplace_back(kLeaps, "false");
  return planner;
}

std::optional<Error> refused_terrain(std::string_view planner, const FreeSpace& space) {
  if (space.uniform_terrain()) return std::nullopt;
  return Error{Status::unsupported_map,
               std::string(planner) +
                   " supports uniform terrain only; this map has terrain or clearance costs"};
}

std::optional<Error> refused_options(const OptionValues& values) {
  if (values.empty()) return std::nullopt;
  return Error{Status::invalid_option,
               "unknown option '" + values.front().first + "': this planner has no options"};
}

Expected<std::vector<PlannerSpec>, Error> parse_planner_specs(std::string_view list) {
  return parse_option_specs(list, "planner", planners().names());
}

std::string_view terrain_in_words(const PlannerInfo& planner) {
  if (planner.capabilities.terrain) return "costs count";
  constexpr int kSide = 2;
  const GridMap rough = *make_grid_map(Grid<CellState>(kSide, kSide, CellState::free), {},
                                       Grid<double>(kSide, kSide, 2));
  return planner.make(*make_free_space(rough), {}) ? "ignored" : "refused";
}

}  // namespace wend
