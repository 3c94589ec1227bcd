#include "conformance/examination.hpp"

#include <utility>

namespace wend::test {
namespace {

/// Some options fit only certain robots: motion primitives, a turning radius.
bool refuses_options(const PlannerInfo& info, const Trial& trial) {
  const auto made = info.make(*make_free_space(trial.map, trial.robot), trial.options);
  return !made && made.error().status == Status::invalid_option;
}

}  // namespace

Examination::Examination(const PlannerInfo& info, std::optional<OptionValues> fixed)
    : info_(info), fixed_(std::move(fixed)) {}

Trial Examination::random_trial(std::uint64_t seed) const {
  if (!info_.capabilities.headings) {
    Trial trial = test::random_trial(seed, info_);
    if (fixed_) trial.options = *fixed_;
    return trial;
  }
  Trial trial = random_pose_trial(seed, info_);
  if (fixed_) trial.options = *fixed_;
  if (!fixed_ && refuses_options(info_, trial)) trial.options.clear();
  return trial;
}

std::unique_ptr<Planner> Examination::planner_for(const Trial& trial) {
  const FreeSpace space = *make_free_space(trial.map, trial.robot);
  auto made = info_.make(space, trial.options);
  if (made) return *std::move(made);
  const bool refuses_terrain = !space.uniform_terrain() && !info_.capabilities.terrain;
  const bool refuses_lattice = info_.capabilities.headings;
  if (made.error().status != Status::unsupported_map || !(refuses_terrain || refuses_lattice)) {
    violate("a planner for this map", made.error().message);
  }
  return nullptr;
}

void Examination::on(const Trial& trial, std::uint64_t seed) {
  trial_ = trial;
  seed_ = seed;
  query_.reset();
  ++report_.maps;
}

void Examination::ask(const Query& query) {
  query_ = query;
  query_->limits = {};
  ++report_.queries;
}

void Examination::violate(const std::string& expected, const std::string& came) {
  ++report_.violations;
  const std::uint64_t cells = trial_ ? trial_->map.size() : 0;
  if (report_.smallest && report_.smallest->cells <= cells) return;
  Violation violation;
  violation.expected = expected;
  violation.came = came;
  violation.seed = seed_;
  violation.cells = cells;
  if (trial_) {
    violation.options = text_of(trial_->options);
    violation.trial = text_of(*trial_, seed_);
  }
  if (query_) violation.query = text_of(*query_);
  report_.smallest = std::move(violation);
}

}  // namespace wend::test
