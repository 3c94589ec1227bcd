#include "wend/planner/se2/hybrid_portfolio.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "wend/base/cpu_time.hpp"
#include "wend/planner/se2/enclosure.hpp"
#include "wend/planner/se2/hybrid_lattice.hpp"
#include "wend/space/se2/coarse_size.hpp"

namespace wend {
namespace {

constexpr std::uint64_t kFirstTurn = 400;  // expansions
constexpr std::uint64_t kGrowth = 3;       // of the turns
constexpr std::uint64_t kFirstFlood = 1000;
constexpr std::uint64_t kFloodGrowth = 4;
constexpr int kFiner = 2;                          // than the other searches: fine
constexpr std::uint64_t kMostOnLattice = 100'000;  // expansions of the last search
constexpr std::uint64_t kMostShuffles = 1000;      // expansions of each search of shuffles
constexpr std::uint64_t kMostInPocket = 4000;      // the same where a flood from its end ends soon
constexpr double kWider = 1.6;                     // radius of wider shuffles
constexpr double kNarrow = 0.75;                   // room beside the robot, in steps
constexpr float kNarrowFactor = 4;
constexpr std::uint64_t kMostKept = 50'000;  // poses of a search that keeps its memory

}  // namespace

/// By Kind.
constexpr std::array<HybridPortfolio::KindOfSearch, HybridPortfolio::kKinds>
    HybridPortfolio::kSearches{{
        {quick, Motions::coarse, Direction::from_start},
        {closer, Motions::coarse, Direction::from_goal},
        {closer_and_wide, Motions::coarse, Direction::from_start},
        {finest, Motions::fine, Direction::from_start},
        {finest, Motions::shuffles, Direction::from_start},
        {finest, Motions::shuffles, Direction::from_goal},
        {finest, Motions::close_shuffles, Direction::from_start},
        {finest, Motions::close_shuffles, Direction::from_goal},
        {finest, Motions::wider_shuffles, Direction::from_start},
        {finest, Motions::wider_shuffles, Direction::from_goal},
        {finest, Motions::lattice, Direction::from_start},
        {finest, Motions::lattice, Direction::from_goal},
    }};

HybridPortfolio::HybridPortfolio(std::shared_ptr<const HybridGround> ground,
                                 const Steering& steering, const HybridResolution& resolution,
                                 HybridBudget budget, std::shared_ptr<GoalRing> ring)
    : ground_(std::move(ground)),
      steering_(steering),
      wider_steering_(steering.model(), kWider * steering.radius(), steering.costs()),
      resolution_(resolution),
      budget_(std::move(budget)),
      ring_(ring ? std::move(ring) : std::make_shared<GoalRing>(steering_)) {
  if (!budget_.clock) budget_.clock = cpu_seconds;
}

HybridResolution HybridPortfolio::resolution_of(Motions motions) const {
  constexpr double kCloser = 2;
  if (motions == Motions::coarse) return resolution_;
  if (motions == Motions::shuffles) return shuffle_resolution(steering_, 1);
  if (motions == Motions::close_shuffles) return shuffle_resolution(steering_, kCloser);
  if (motions == Motions::wider_shuffles) return shuffle_resolution(wider_steering_, kCloser);
  HybridResolution resolution = times_finer(resolution_, kFiner);
  resolution.trace_spacing *= 0.4;
  resolution.trace_period = 2;
  if (motions == Motions::lattice) {
    resolution.position = LatticeMotions::kSpacing;
    resolution.headings = static_cast<int>(LatticeMotions::kHeadings);
  }
  return resolution;
}

/// The length of motions to and fro, by that of the robot.
double HybridPortfolio::shuffle_length() const {
  constexpr double kOfRadius = 1.45;  // of the circumscribed disc: about the length of a car
  constexpr double kMostRadii = 3;
  const double radius = steering_.radius() > 0 ? steering_.radius() : resolution_.step;
  const double robot = kOfRadius * ground_->free_space().radius_in_cells();
  return robot > 1 ? std::min(kMostRadii * radius, robot) : radius;
}

/// A robot of a cell slips through wherever its searches in boxes do; one with a far larger radius gains nothing.
bool HybridPortfolio::may_shuffle() const {
  constexpr double kMostLengths = 50;
  return ground_->free_space().radius_in_cells() > 1 &&
         steering_.radius() <= kMostLengths * shuffle_length();
}

/// To and fro the robot gains little with each motion: the boxes have to be smaller than that, or no pose is new.
HybridResolution HybridPortfolio::shuffle_resolution(const Steering& steering, double finer) const {
  constexpr double kParts = 20;      // of the length: steps
  constexpr double kBoxes = 120;     // of the length: boxes
  constexpr double kTurnParts = 1;   // boxes of headings in the turn of a step
  constexpr double kLeastBox = 0.5;  // of these, where the radius is large
  constexpr double kMostHeadings = 4096;
  constexpr double kLeastHeadings = 72;
  const double radius = steering.radius() > 0 ? steering.radius() : resolution_.step;
  const double length = shuffle_length();
  HybridResolution resolution = resolution_;
  resolution.step = length / kParts / finer;
  resolution.position = length / kBoxes / finer * std::clamp(1.2 * length / radius, kLeastBox, 1.0);
  resolution.headings = static_cast<int>(
      std::clamp(2 * kPi * radius / resolution.step * kTurnParts, kLeastHeadings, kMostHeadings));
  resolution.weight = 20;
  resolution.to_contact = true;
  return resolution;
}

/// Large squares are quick; where the first search finds nothing, the robot passes close to walls, and smaller ones
/// know better how. Null if a limit ends the query before.
const CoarseGrid* HybridPortfolio::grid_of(Squares squares) {
  constexpr std::array<double, kSquares> kSteps{1.5, 0.75, 0.75, 0.5};
  auto& grid = grids_[squares];
  if (grid) return grid.get();
  const FreeSpace& space = ground_->free_space();
  bool cut = false;
  const auto stop = [&] { return cut = cut || interrupted(); };
  if (squares == closer_and_wide) {
    const CoarseGrid* const other = grid_of(closer);
    if (other == nullptr) return nullptr;
    grid = std::make_unique<CoarseGrid>(*other);
    grid->charge_narrow_squares(space, kNarrow * resolution_.step, kNarrowFactor, stop);
    if (cut) grid.reset();
    return grid.get();
  }
  const BitGrid& cells = squares == finest ? ground_->drivable() : space.possible();
  const double most = kSteps[squares] * resolution_.step;
  const int size = coarse_size(space, cells, most);
  grid = std::make_unique<CoarseGrid>(space, cells, size, stop);
  if (cut) grid.reset();
  return grid.get();
}

GoalRing& HybridPortfolio::ring_of(const KindOfSearch& kind) {
  if (kind.motions != Motions::wider_shuffles) return *ring_;
  if (!wider_ring_) wider_ring_.emplace(wider_steering_);
  return *wider_ring_;
}

/// Can the search help with this query? One from the goal needs to know the pose there.
bool HybridPortfolio::suits(const KindOfSearch& kind) const {
  if (kind.shuffles() && !may_shuffle()) return false;
  if (!kind.from_goal()) return true;
  if (goals_.size() != 1) return false;
  return kind.shuffles() ? !goals_.front().any_heading : goals_.front().wants_heading();
}

/// Null if a limit ends the query before.
HybridSearch* HybridPortfolio::search_of(Kind kind) {
  Member& member = members_[kind];
  if (!member.search) {
    const KindOfSearch& parts = kSearches[kind];
    const CoarseGrid* const grid = grid_of(parts.squares);
    if (grid == nullptr) return nullptr;
    GoalRing& ring = ring_of(parts);
    const HybridResolution resolution = resolution_of(parts.motions);
    if (parts.motions == Motions::lattice) {
      member.search = std::make_unique<HybridLattice>(ground_->check(), steering_, ring, *grid,
                                                      resolution, parts.direction, *lattice_);
    } else {
      const bool wider = parts.motions == Motions::wider_shuffles;
      member.search =
          std::make_unique<HybridSearch>(ground_->check(), wider ? wider_steering_ : steering_,
                                         ring, *grid, resolution, parts.direction);
    }
  }
  if (!member.begun) {
    member.search->begin(start_, goals_, observer_, [this] { return interrupted().has_value(); });
    member.begun = true;
  }
  return member.search.get();
}

std::uint64_t HybridPortfolio::expanded() const {
  std::uint64_t sum = 0;
  for (const Member& member : members_) {
    if (member.begun) sum += member.search->metrics().expanded;
  }
  return sum;
}

/// By its flag or its time, which may end anything; the expansions end what expands.
std::optional<SearchOutcome> HybridPortfolio::interrupted() const {
  if (limits_->cancel != nullptr && *limits_->cancel) return SearchOutcome::cancelled;
  if (limits_->timed() && limits_->now() >= end_seconds_) return SearchOutcome::time_limit;
  if (budget_.clock() >= budget_end_) return SearchOutcome::time_limit;
  return std::nullopt;
}

std::optional<SearchOutcome> HybridPortfolio::stopped() const {
  if (const auto outcome = interrupted()) return outcome;
  if (expanded() >= limit_) return SearchOutcome::expansion_limit;
  return std::nullopt;
}

SearchOutcome HybridPortfolio::run_member(Kind kind, std::uint64_t most) {
  if (const auto outcome = stopped()) return *outcome;
  HybridSearch* const search = search_of(kind);
  if (search == nullptr) return stopped().value_or(SearchOutcome::time_limit);
  const std::uint64_t begun = search->metrics().expanded;
  while (search->metrics().expanded - begun < most || search->has_path()) {
    if (const auto outcome = stopped()) return *outcome;
    constexpr std::uint64_t kAtOnce = 32;
    const SearchOutcome outcome = search->run(std::min(kAtOnce, limit_ - expanded()));
    if (outcome != SearchOutcome::running) return outcome;
  }
  return SearchOutcome::running;
}

/// Runs a search until its turn ends; returns the outcome of the query if it has one.
std::optional<SearchOutcome> HybridPortfolio::take_turn(Kind kind, std::uint64_t most) {
  Member& member = members_[kind];
  if (member.over) return std::nullopt;
  const SearchOutcome outcome = run_member(kind, most);
  if (member.begun && member.search->has_path()) finder_ = member.search.get();
  if (outcome == SearchOutcome::running) {
    member.over = kSearches[kind].shuffles() && member.search->metrics().expanded >= most_shuffles_;
    return std::nullopt;
  }
  if (outcome != SearchOutcome::exhausted) return outcome;
  member.over = true;
  return std::nullopt;
}

std::optional<SearchOutcome> HybridPortfolio::take_turns(std::span<const Kind> kinds,
                                                         std::uint64_t most) {
  for (const Kind kind : kinds) {
    if (const auto outcome = take_turn(kind, most)) return outcome;
  }
  return std::nullopt;
}

bool HybridPortfolio::all_over(std::span<const Kind> kinds) const {
  return std::ranges::all_of(kinds, [this](Kind kind) { return members_[kind].over; });
}

void HybridPortfolio::begin(const Pose& start, std::span<const HybridGoal> goals,
                            const Limits& limits, SearchObserver* observer) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  finder_ = nullptr;
  most_shuffles_ = kMostShuffles;
  const HybridResolution finest = resolution_of(Motions::fine);
  no_drive_ = {.box = finest.position, .headings = finest.headings, .step = finest.step};
  start_ = start;
  goals_ = goals;
  limits_ = &limits;
  observer_ = observer;
  const bool counted = limits.expansions < Limits::kUnlimited;
  limit_ = counted ? limits.expansions : budget_.expansions;
  end_seconds_ = limits.timed() ? limits.now() + limits.seconds : kNever;
  budget_end_ = counted || limits.seconds < kNever ? kNever : budget_.clock() + budget_.seconds;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    members_[kind].begun = false;
    members_[kind].over = !suits(kSearches[kind]);
  }
}

SearchOutcome HybridPortfolio::run(const Pose& start, std::span<const HybridGoal> goals,
                                   const Limits& limits, SearchObserver* observer) {
  begin(start, goals, limits, observer);
  const SearchOutcome outcome = take_course();
  end();
  return outcome;
}

SearchOutcome HybridPortfolio::take_course() {
  constexpr std::array kCoarse{direct, backward, wide, fine};
  constexpr std::array kFromStart{shuffle, close_shuffle};
  constexpr std::array kFromGoal{shuffle_backward, close_shuffle_backward};
  Course course;
  std::uint64_t flooded = kFirstFlood;
  for (std::uint64_t turn = kFirstTurn;; turn *= kGrowth, flooded *= kFloodGrowth) {
    if (course.coarse) {
      if (const auto outcome = take_turns(kCoarse, turn)) return *outcome;
      course.coarse = !all_over(kCoarse);
    }
    if (course.shuffles_due || !course.coarse) {
      if (course.from_start) {
        if (const auto outcome = take_turns(kFromStart, turn)) return *outcome;
        course.from_start = !all_over(kFromStart);
      }
      if (course.from_goal) {
        if (const auto outcome = take_turns(kFromGoal, turn)) return *outcome;
        course.from_goal = !all_over(kFromGoal);
      }
    }
    course.shuffles_due = true;
    if (!course.coarse && !course.from_start && !course.from_goal) break;
    flood(flooded, course);
    if (const auto outcome = stopped()) return *outcome;
  }
  const bool at_goal = flooded_ && to_goal_->is_small();
  const bool at_start = flooded_ && from_start_->is_small();
  // Where short motions do not lead a robot of a cell out, those on cells do not either.
  if ((at_goal || at_start) && !may_shuffle()) {
    no_drive_.why = why_none();
    return SearchOutcome::exhausted;
  }
  constexpr std::array kWiderKinds{wider_shuffle, wider_shuffle_backward};
  for (std::uint64_t turn = kFirstTurn; !all_over(kWiderKinds); turn *= kGrowth) {
    if (const auto outcome = take_turns(kWiderKinds, turn)) return *outcome;
  }
  const bool one_pose = goals_.size() == 1 && goals_.front().wants_heading();
  return search_lattice(one_pose && at_goal ? lattice_backward : lattice);
}

/// Runs the floods, and leaves out the searches that one of them shows to be of no use.
void HybridPortfolio::flood(std::uint64_t most, Course& course) {
  const MotionCheck& check = ground_->check();
  if (!to_goal_) {
    to_goal_ =
        std::make_unique<PoseFlood>(check, steering_, resolution_, PoseFlood::Direction::to_goal);
  }
  if (!from_start_) {
    from_start_ = std::make_unique<PoseFlood>(check, steering_, resolution_,
                                              PoseFlood::Direction::from_start);
  }
  if (!flooded_) {
    to_goal_->begin(goals_);
    from_start_->begin(start_);
    flooded_ = true;
  }
  run_flood(*to_goal_, most);
  run_flood(*from_start_, most);
  const bool goal_small = to_goal_->is_small();
  const bool start_small = from_start_->is_small();
  if (to_goal_->has_ended() || from_start_->has_ended()) course.coarse = false;
  if (goal_small || start_small) most_shuffles_ = kMostInPocket;
  if (goal_small && !start_small && !members_[shuffle_backward].over) course.from_start = false;
  if (start_small && !goal_small) course.from_goal = false;
}

void HybridPortfolio::run_flood(PoseFlood& flood, std::uint64_t most) {
  constexpr std::uint64_t kAtOnce = 64;
  for (std::uint64_t done = 0; done < most && !flood.has_ended() && !stopped(); done += kAtOnce) {
    if (flood.run(kAtOnce)) return;
  }
}

/// A flood that has ended shows where to look for a proof that an end is boxed in.
NoDriveFound::Why HybridPortfolio::why_none() const {
  const FreeSpace& space = ground_->free_space();
  const auto stop = [this] { return stopped().has_value(); };
  const auto enclosed = [&](const HybridGoal& goal) {
    return !goal.any_heading && is_enclosed(space, goal.pose, start_, stop);
  };
  if (flooded_ && to_goal_->is_small() && std::ranges::all_of(goals_, enclosed)) {
    return NoDriveFound::Why::goal_boxed_in;
  }
  if (flooded_ && from_start_->is_small() && goals_.size() == 1 && !goals_.front().any_heading &&
      is_enclosed(space, start_, goals_.front().pose, stop)) {
    return NoDriveFound::Why::start_boxed_in;
  }
  return NoDriveFound::Why::none_found;
}

/// The last search. Where it does not get to its end, the others have.
SearchOutcome HybridPortfolio::search_lattice(Kind kind) {
  if (!lattice_) lattice_ = std::make_unique<LatticeMotions>(steering_);
  if (lattice_->empty()) {
    no_drive_.why = why_none();
    return SearchOutcome::exhausted;
  }
  const auto outcome = take_turn(kind, kMostOnLattice);
  no_drive_.lattice_searched = members_[kind].over;
  if (!outcome) no_drive_.why = why_none();
  return outcome.value_or(SearchOutcome::exhausted);
}

/// Sums up the work, and frees what has grown large.
void HybridPortfolio::end() {
  metrics_ = {};
  for (Member& member : members_) {
    if (!member.begun) continue;
    const SearchMetrics& metrics = member.search->metrics();
    metrics_.expanded += metrics.expanded;
    metrics_.generated += metrics.generated;
    metrics_.max_frontier = std::max(metrics_.max_frontier, metrics.max_frontier);
    const bool needed = member.search.get() == finder_ || &member == &members_[direct];
    if (!needed && metrics.generated > kMostKept) member = {};
  }
  for (auto* const flood : {&to_goal_, &from_start_}) {
    if (*flood && (*flood)->size() > kMostKept) flood->reset();
  }
  flooded_ = false;
  limits_ = nullptr;
}

double HybridPortfolio::heuristic(const Pose& pose) const {
  const Member& first = members_[direct];
  return first.begun ? first.search->heuristic(pose) : 0;
}

}  // namespace wend
