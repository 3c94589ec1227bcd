#include "wend/planner/jump/prepared_jumps.hpp"

#include <numeric>
#include <span>

#include "wend/jump/jump_sources.hpp"
#include "wend/jump/noise.hpp"

namespace wend {
namespace {

/// Preparing a cell takes about as long as this many scans: of rooms 10 ns, of a maze or noise 25 to 35.
constexpr std::uint64_t kScansPerCell = 1;

/// The number of cells in some boxes, and next to them.
std::int64_t cells_around(std::span<const CellBox> boxes) {
  return std::transform_reduce(boxes.begin(), boxes.end(), std::int64_t{0}, std::plus<>(),
                               [](const CellBox& box) { return box.grown_by(1).size(); });
}

/// Repairs of more cells may take longer than some searches without anything prepared.
bool too_large_to_repair(std::span<const CellBox> edits) {
  constexpr std::int64_t kMostCells = 10'000;
  return cells_around(edits) > kMostCells;
}

/// Each of them has to be opened for every query.
bool too_large_to_keep_open(std::span<const CellBox> edits) {
  constexpr std::int64_t kMostCells = 100'000;
  return cells_around(edits) > kMostCells;
}

/// Is it so large that the memory of a graph counts, and that preparing it takes longer than some queries?
bool is_large(const BitGrid& cells) {
  constexpr std::size_t kSmall = std::size_t{1} << 17U;
  return static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height()) >
         kSmall;
}

}  // namespace

bool PreparedJumps::is_noise(const BitGrid& passable) {
  const MutexLock lock(mutex_);
  if (!is_noise_) is_noise_ = is_large(passable) && wend::is_noise(passable);
  return *is_noise_;
}

void PreparedJumps::space_edited(const SpaceChange& change) {
  const MutexLock lock(mutex_);
  if (change.everything) is_noise_.reset();
  for (const auto& search : compact_.scanning) search->jumps().repair(change.boxes);
  for (const auto& search : wide_.scanning) search->jumps().repair(change.boxes);
  if (graph_ == nullptr) return;
  pending_.insert(pending_.end(), change.boxes.begin(), change.boxes.end());
  edits_.insert(edits_.end(), change.boxes.begin(), change.boxes.end());
  if (change.everything || too_large_to_repair(pending_) || too_large_to_keep_open(edits_)) {
    forget();
  }
}

void PreparedJumps::forget() {
  graph_.reset();
  boards_.reset();
  dead_ends_.reset();
  pending_.clear();
  edits_.clear();
  compact_.known.clear();
  wide_.known.clear();
  scans_ = 0;
}

void PreparedJumps::bring_up_to_date(const BitGrid& passable) {
  if (graph_ != nullptr) {
    if (!pending_.empty()) repair(passable);
    return;
  }
  const auto cells =
      static_cast<std::uint64_t>(passable.width()) * static_cast<std::uint64_t>(passable.height());
  if (scans_ > kScansPerCell * cells) prepare(passable);
}

void PreparedJumps::prepare(const BitGrid& passable) {
  compact_.scanning.clear();  // their memory first
  wide_.scanning.clear();
  boards_ = std::make_shared<JumpBoards>(passable);
  dead_ends_ = std::make_shared<const DeadEnds>(*boards_);
  graph_ = std::make_shared<JumpGraph>(boards_);
}

void PreparedJumps::repair(const BitGrid& passable) {
  boards_->repair(passable, pending_);
  graph_->repair(pending_);
  constexpr std::size_t kMostSteps = 200'000;  // they take about as long as a query
  JumpSources sources(*graph_, kMostSteps);
  const bool found = sources.find(pending_);
  const auto repair_each = [&](const auto& searches) {
    for (const auto& search : searches) {
      search->jumps().repair(pending_, found ? &sources.jumps() : nullptr);
    }
  };
  repair_each(compact_.known);
  repair_each(wide_.known);
  pending_.clear();
}

}  // namespace wend
