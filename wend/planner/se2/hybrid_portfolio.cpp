#include "wend/planner/se2/hybrid_portfolio.hpp"

#include <algorithm>
#include <utility>

namespace wend {
namespace {

constexpr std::uint64_t kFirstTurn = 400;  // expansions
constexpr std::uint64_t kGrowth = 3;       // of the turns
constexpr std::uint64_t kFirstFlood = 500;
constexpr std::size_t kMostBoxedIn = 5'000;   // poses around a goal that is boxed in
constexpr std::uint64_t kMostFinest = 4'000;  // expansions of the last search
constexpr double kNarrow = 0.75;              // room beside the robot, in steps
constexpr float kNarrowFactor = 4;

}  // namespace

HybridPortfolio::HybridPortfolio(std::shared_ptr<const HybridGround> ground,
                                 const Steering& steering, const HybridResolution& resolution)
    : ground_(std::move(ground)), steering_(steering), resolution_(resolution), ring_(steering_) {}

HybridResolution HybridPortfolio::resolution_of(Kind kind) const {
  HybridResolution resolution = resolution_;
  if (kind < fine) return resolution;
  const int finer = kind == fine ? 2 : 4;
  resolution.position /= finer;
  resolution.headings *= finer;
  resolution.step /= finer;
  resolution.trace_spacing *= 0.8 / finer;
  resolution.trace_period = 2;
  return resolution;
}

void HybridPortfolio::make(Kind kind) {
  Member& member = members_[kind];
  const FreeSpace& space = ground_->free_space();
  const HybridResolution resolution = resolution_of(kind);
  const double most = (kind >= fine ? 1 : 1.5) * resolution.step;
  const BitGrid& cells = kind >= fine ? ground_->drivable() : space.possible();
  member.grid = std::make_unique<CoarseGrid>(space, cells, coarse_size(space, most));
  if (kind == wide) {
    member.grid->charge_narrow_squares(space, kNarrow * resolution_.step, kNarrowFactor);
  }
  const bool from_goal = kind == backward || kind == finest_backward;
  const auto direction =
      from_goal ? HybridSearch::Direction::from_goal : HybridSearch::Direction::from_start;
  member.search = std::make_unique<HybridSearch>(ground_->check(), steering_, ring_, *member.grid,
                                                 resolution, direction);
}

std::optional<SearchOutcome> HybridPortfolio::stopped(const Limits& limits, double end) const {
  if (limits.cancel != nullptr && *limits.cancel) return SearchOutcome::cancelled;
  if (limits.timed() && limits.now() >= end) return SearchOutcome::time_limit;
  if (metrics().expanded >= limits.expansions) return SearchOutcome::expansion_limit;
  return std::nullopt;
}

SearchOutcome HybridPortfolio::run_member(Kind kind, std::uint64_t most, const Limits& limits,
                                          double end) {
  Member& member = members_[kind];
  if (!member.begun) {
    if (!member.search) make(kind);
    member.search->begin(start_, goals_, observer_);
    member.begun = true;
  }
  const std::uint64_t begun = member.search->metrics().expanded;
  while (member.search->metrics().expanded - begun < most || member.search->has_path()) {
    if (const auto outcome = stopped(limits, end)) return *outcome;
    constexpr std::uint64_t kAtOnce = 64;
    const std::uint64_t left = limits.expansions - metrics().expanded;
    const SearchOutcome outcome = member.search->run(std::min(kAtOnce, left));
    if (outcome != SearchOutcome::running) return outcome;
  }
  return SearchOutcome::running;
}

/// Does the flood from the goal end?
bool HybridPortfolio::flood(std::uint64_t most) {
  if (!flood_) {
    flood_ = std::make_unique<GoalFlood>(ground_->check(), steering_, resolution_);
  }
  if (most == kFirstFlood) flood_->begin(goals_);
  return flood_->run(most);
}

SearchOutcome HybridPortfolio::run(const Pose& start, std::span<const HybridGoal> goals,
                                   const Limits& limits, SearchObserver* observer) {
  for (Member& member : members_) member.begun = member.exhausted = false;
  const bool one_pose = goals.size() == 1 && goals.front().wants_heading();
  members_[backward].exhausted = !one_pose;
  finder_ = nullptr;
  boxed_in_ = false;
  start_ = start;
  goals_ = goals;
  observer_ = observer;
  const double end = limits.timed() ? limits.now() + limits.seconds : 0;
  std::uint64_t flooded = kFirstFlood;
  for (std::uint64_t turn = kFirstTurn;; turn *= kGrowth) {
    for (const Kind kind : {direct, backward, wide, fine}) {
      Member& member = members_[kind];
      if (member.exhausted) continue;
      const SearchOutcome outcome = run_member(kind, turn, limits, end);
      if (member.search->has_path()) finder_ = member.search.get();
      if (outcome == SearchOutcome::running) continue;
      if (outcome != SearchOutcome::exhausted) return outcome;
      member.exhausted = true;
    }
    const bool ended = !members_[fine].exhausted && flood(flooded);
    boxed_in_ = ended && flood_->size() <= kMostBoxedIn;
    if (ended || members_[fine].exhausted) {
      const Kind last = ended && one_pose ? finest_backward : finest;
      const SearchOutcome outcome = run_member(last, kMostFinest, limits, end);
      if (members_[last].search->has_path()) finder_ = members_[last].search.get();
      return outcome == SearchOutcome::running ? SearchOutcome::exhausted : outcome;
    }
    flooded *= kGrowth + 1;
  }
}

SearchMetrics HybridPortfolio::metrics() const {
  SearchMetrics sum;
  for (const Member& member : members_) {
    if (!member.begun) continue;
    const SearchMetrics& metrics = member.search->metrics();
    sum.expanded += metrics.expanded;
    sum.generated += metrics.generated;
    sum.max_frontier = std::max(sum.max_frontier, metrics.max_frontier);
  }
  return sum;
}

double HybridPortfolio::heuristic(const Pose& pose) const {
  const Member& first = members_[direct];
  return first.begun ? first.search->heuristic(pose) : 0;
}

}  // namespace wend
