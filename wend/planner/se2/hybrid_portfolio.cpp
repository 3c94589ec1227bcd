#include "wend/planner/se2/hybrid_portfolio.hpp"

#include <algorithm>
#include <utility>

#include "wend/space/se2/coarse_size.hpp"

namespace wend {
namespace {

constexpr std::uint64_t kFirstTurn = 400;  // expansions
constexpr std::uint64_t kGrowth = 3;       // of the turns
constexpr std::uint64_t kFirstFlood = 1000;
constexpr std::uint64_t kFloodGrowth = 4;
constexpr int kFiner = 2;                          // than the other searches: fine
constexpr std::uint64_t kMostOnLattice = 100'000;  // expansions of the last search
constexpr double kNarrow = 0.75;                   // room beside the robot, in steps
constexpr float kNarrowFactor = 4;

}  // namespace

HybridPortfolio::HybridPortfolio(std::shared_ptr<const HybridGround> ground,
                                 const Steering& steering, const HybridResolution& resolution,
                                 std::uint64_t most_expansions)
    : ground_(std::move(ground)),
      steering_(steering),
      resolution_(resolution),
      most_expansions_(most_expansions),
      ring_(steering_) {}

HybridResolution HybridPortfolio::resolution_of(Kind kind) const {
  HybridResolution resolution = resolution_;
  if (kind < fine) return resolution;
  resolution = times_finer(resolution, kFiner);
  resolution.trace_spacing *= 0.4;
  resolution.trace_period = 2;
  if (kind >= lattice) {
    resolution.position = LatticeMotions::kSpacing;
    resolution.headings = static_cast<int>(LatticeMotions::kHeadings);
  }
  return resolution;
}

/// The size of the coarse squares, in steps. Large ones are quick; where the first search finds nothing, the
/// robot passes close to walls, and smaller ones know better how.
double HybridPortfolio::squares_of(Kind kind) {
  constexpr double kQuick = 1.5;
  constexpr double kCloser = 0.75;
  if (kind == direct) return kQuick;
  return kind < fine ? kCloser : 1;
}

void HybridPortfolio::make(Kind kind) {
  Member& member = members_[kind];
  const FreeSpace& space = ground_->free_space();
  const HybridResolution resolution = resolution_of(kind);
  const double most = squares_of(kind) * resolution.step;
  const CoarseGrid* const alike = kind == wide ? members_[backward].grid.get() : nullptr;
  if (alike != nullptr) {
    member.grid = std::make_unique<CoarseGrid>(*alike);
  } else {
    const BitGrid& cells = kind >= fine ? ground_->drivable() : space.possible();
    member.grid = std::make_unique<CoarseGrid>(space, cells, coarse_size(space, cells, most));
  }
  if (kind == wide) {
    member.grid->charge_narrow_squares(space, kNarrow * resolution_.step, kNarrowFactor);
  }
  const bool from_goal = kind == backward || kind == lattice_backward;
  const auto direction =
      from_goal ? HybridSearch::Direction::from_goal : HybridSearch::Direction::from_start;
  member.search =
      std::make_unique<HybridSearch>(ground_->check(), steering_, ring_, *member.grid, resolution,
                                     direction, kind >= lattice ? lattice_.get() : nullptr);
}

std::optional<SearchOutcome> HybridPortfolio::stopped(const Limits& limits, double end) const {
  if (limits.cancel != nullptr && *limits.cancel) return SearchOutcome::cancelled;
  if (limits.timed() && limits.now() >= end) return SearchOutcome::time_limit;
  if (metrics().expanded >= limit_) return SearchOutcome::expansion_limit;
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
    const std::uint64_t left = limit_ - metrics().expanded;
    const SearchOutcome outcome = member.search->run(std::min(kAtOnce, left));
    if (outcome != SearchOutcome::running) return outcome;
  }
  return SearchOutcome::running;
}

/// Does the flood at one end leave no pose? A limit of the query ends the flood's turn, and then the next search.
bool HybridPortfolio::ends(PoseFlood& flood, NoDriveFound::Why boxed_in, std::uint64_t most,
                           const Limits& limits, double end) {
  constexpr std::uint64_t kAtOnce = 256;
  for (std::uint64_t done = 0; done < most && !stopped(limits, end); done += kAtOnce) {
    if (!flood.run(kAtOnce)) continue;
    no_drive_ = {flood.is_small() ? boxed_in : NoDriveFound::Why::none_found, flood.resolution()};
    return true;
  }
  return false;
}

bool HybridPortfolio::is_boxed_in(std::uint64_t most, const Limits& limits, double end) {
  using Direction = PoseFlood::Direction;
  using Why = NoDriveFound::Why;
  if (!to_goal_) {
    const MotionCheck& check = ground_->check();
    to_goal_ = std::make_unique<PoseFlood>(check, steering_, resolution_, Direction::to_goal);
    from_start_ = std::make_unique<PoseFlood>(check, steering_, resolution_, Direction::from_start);
  }
  if (most == kFirstFlood) {
    to_goal_->begin(goals_);
    from_start_->begin(start_);
  }
  return ends(*to_goal_, Why::goal_boxed_in, most, limits, end) ||
         ends(*from_start_, Why::start_boxed_in, most, limits, end);
}

/// Runs a search until its turn ends; returns the outcome of the query if it has one.
std::optional<SearchOutcome> HybridPortfolio::take_turn(Kind kind, std::uint64_t most,
                                                        const Limits& limits, double end) {
  Member& member = members_[kind];
  if (member.exhausted) return std::nullopt;
  const SearchOutcome outcome = run_member(kind, most, limits, end);
  if (member.search->has_path()) finder_ = member.search.get();
  if (outcome == SearchOutcome::running) return std::nullopt;
  if (outcome != SearchOutcome::exhausted) return outcome;
  member.exhausted = true;
  return std::nullopt;
}

void HybridPortfolio::begin(const Pose& start, std::span<const HybridGoal> goals,
                            SearchObserver* observer) {
  for (Member& member : members_) member.begun = member.exhausted = false;
  finder_ = nullptr;
  no_drive_ = {NoDriveFound::Why::none_found, resolution_of(fine)};
  start_ = start;
  goals_ = goals;
  observer_ = observer;
}

SearchOutcome HybridPortfolio::run(const Pose& start, std::span<const HybridGoal> goals,
                                   const Limits& limits, SearchObserver* observer) {
  begin(start, goals, observer);
  limit_ = limits.expansions == Limits::kUnlimited ? most_expansions_ : limits.expansions;
  const bool one_pose = goals.size() == 1 && goals.front().wants_heading();
  members_[backward].exhausted = !one_pose;
  const double end = limits.timed() ? limits.now() + limits.seconds : 0;
  std::uint64_t turn = kFirstTurn;
  std::uint64_t flooded = kFirstFlood;
  bool boxed_in = false;
  bool left = true;
  while (left && !boxed_in) {
    left = false;
    for (const Kind kind : {direct, backward, wide, fine}) {
      if (const auto outcome = take_turn(kind, turn, limits, end)) return *outcome;
      left = left || !members_[kind].exhausted;
    }
    boxed_in = is_boxed_in(flooded, limits, end);
    turn *= kGrowth;
    flooded *= kFloodGrowth;
  }
  const bool from_goal = one_pose && no_drive_.why == NoDriveFound::Why::goal_boxed_in;
  return search_lattice(from_goal ? lattice_backward : lattice, limits, end);
}

/// The last search. Where it does not get to its end, the others have.
SearchOutcome HybridPortfolio::search_lattice(Kind kind, const Limits& limits, double end) {
  if (!lattice_) lattice_ = std::make_unique<LatticeMotions>(steering_);
  if (lattice_->empty()) return SearchOutcome::exhausted;
  const auto outcome = take_turn(kind, kMostOnLattice, limits, end);
  no_drive_.lattice_searched = members_[kind].exhausted;
  return outcome.value_or(SearchOutcome::exhausted);
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
