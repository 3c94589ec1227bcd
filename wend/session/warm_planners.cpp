#include "wend/session/warm_planners.hpp"

#include <optional>
#include <utility>

#include "wend/base/mutex.hpp"

namespace wend {
namespace {

std::string key_of(const PlannerSpec& spec) {
  std::string key = spec.name;
  for (const auto& [name, value] : spec.options)
    key.append(",").append(name).append("=").append(value);
  return key;
}

}  // namespace

/// What is not in use. It lives as long as the pool, or a planner that may return.
struct WarmPlanner::Shelf {
  struct Idle {
    std::string key;
    std::unique_ptr<Planner> planner;
  };
  struct Index {
    std::string planner;
    IndexBytes bytes;
  };

  explicit Shelf(std::size_t most) : most_idle(most) {}

  /// Also makes room for the planner to come back: that must not fail.
  std::unique_ptr<Planner> take(std::uint64_t wanted, const std::string& key) {
    const MutexLock lock(mutex);
    if (idle.capacity() < most_idle) idle.reserve(idle.capacity() + 1);
    forget_before(wanted);
    if (wanted != version) return nullptr;
    for (auto each = idle.begin(); each != idle.end(); ++each) {
      if (each->key != key) continue;
      auto planner = std::move(each->planner);
      idle.erase(each);
      return planner;
    }
    return nullptr;
  }

  std::vector<std::pair<std::string, std::unique_ptr<Planner>>> take_all(std::uint64_t wanted) {
    const MutexLock lock(mutex);
    std::vector<std::pair<std::string, std::unique_ptr<Planner>>> taken;
    if (wanted != version) return taken;
    for (Idle& each : idle) taken.emplace_back(std::move(each.key), std::move(each.planner));
    idle.clear();
    return taken;
  }

  /// Planners of earlier versions that come back are dropped.
  void go_on_to(std::uint64_t wanted) {
    const MutexLock lock(mutex);
    forget_before(wanted);
  }

  /// The oldest makes room.
  void put(std::uint64_t made_for, std::string key, std::unique_ptr<Planner> planner) {
    const MutexLock lock(mutex);
    if (made_for != version || most_idle == 0) return;
    if (idle.size() >= most_idle) idle.erase(idle.begin());
    idle.push_back({std::move(key), std::move(planner)});
  }

  std::optional<IndexBytes> index_of(const std::string& planner) {
    const MutexLock lock(mutex);
    for (const Index& index : indexes) {
      if (index.planner == planner) return index.bytes;
    }
    return std::nullopt;
  }

  void set_index(std::string_view planner, IndexBytes bytes) {
    const MutexLock lock(mutex);
    idle.clear();
    std::erase_if(indexes, [&](const Index& index) { return index.planner == planner; });
    indexes.push_back({std::string(planner), std::move(bytes)});
  }

  /// Called with the lock.
  void forget_before(std::uint64_t wanted) {
    if (wanted <= version) return;
    idle.clear();
    version = wanted;
  }

  const std::size_t most_idle;
  Mutex mutex;  // guards the rest
  std::uint64_t version = 0;
  std::vector<Idle> idle;
  std::vector<Index> indexes;
};

WarmPlanner::WarmPlanner(std::shared_ptr<Shelf> shelf, std::uint64_t version, std::string key,
                         std::unique_ptr<Planner> planner)
    : shelf_(std::move(shelf)),
      version_(version),
      key_(std::move(key)),
      planner_(std::move(planner)) {}

WarmPlanner::WarmPlanner(WarmPlanner&&) noexcept = default;

WarmPlanner& WarmPlanner::operator=(WarmPlanner&& other) noexcept {
  if (this != &other) {
    give_back();
    shelf_ = std::move(other.shelf_);
    version_ = other.version_;
    key_ = std::move(other.key_);
    planner_ = std::move(other.planner_);
  }
  return *this;
}

WarmPlanner::~WarmPlanner() { give_back(); }

void WarmPlanner::give_back() {
  if (planner_) shelf_->put(version_, std::move(key_), std::move(planner_));
}

WarmPlanners::WarmPlanners(std::size_t most_idle)
    : shelf_(std::make_shared<WarmPlanner::Shelf>(most_idle)) {}

PlannerResult WarmPlanners::make(const FreeSpace& space, const PlannerSpec& spec,
                                 const Deadline& deadline) const {
  auto index = shelf_->index_of(spec.name);
  if (!index) return make_planner(spec.name, space, spec.options, deadline);
  return make_planner(spec.name, space, spec.options, *std::move(index));
}

Expected<WarmPlanner, Error> WarmPlanners::take(const FreeSpace& space, std::uint64_t version,
                                                const PlannerSpec& spec, const Deadline& deadline) {
  auto planners = take(space, version, spec, 1, deadline);
  if (!planners) return Unexpected<Error>(std::move(planners.error()));
  return std::move(planners->front());
}

Expected<std::vector<WarmPlanner>, Error> WarmPlanners::take(const FreeSpace& space,
                                                             std::uint64_t version,
                                                             const PlannerSpec& spec,
                                                             std::size_t count,
                                                             const Deadline& deadline) {
  std::vector<WarmPlanner> planners;
  planners.reserve(count);
  const std::string key = key_of(spec);
  while (planners.size() < count) {
    auto planner = shelf_->take(version, key);
    if (planners.empty() && !planner) {
      auto made = make(space, spec, deadline);
      if (!made) return Unexpected<Error>(std::move(made.error()));
      planner = *std::move(made);
    }
    if (!planner) planner = planners.front()->clone();
    planners.push_back(WarmPlanner(shelf_, version, key, std::move(planner)));
  }
  return planners;
}

WarmPlanners::Released WarmPlanners::release(std::uint64_t version) {
  Released released;
  released.planners_ = shelf_->take_all(version);
  for (const auto& [key, planner] : released.planners_) planner->release();
  return released;
}

void WarmPlanners::keep(Released released, const FreeSpace& space, const SpaceChange& change,
                        std::uint64_t version) {
  shelf_->go_on_to(version);
  for (auto& [key, planner] : released.planners_) {
    const auto updated = planner->update(space, change);
    if (!updated && updated.error().status != Status::index_mismatch) continue;
    shelf_->put(version, std::move(key), std::move(planner));
  }
}

void WarmPlanners::set_index(std::string_view planner, IndexBytes index) {
  shelf_->set_index(planner, std::move(index));
}

}  // namespace wend
