#include "wend/planner/best_first.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "wend/planner/grid_priorities.hpp"
#include "wend/planner/plan.hpp"
#include "wend/search/bucket_frontier.hpp"
#include "wend/search/heap_frontier.hpp"
#include "wend/space/grid_space.hpp"

namespace wend {
namespace {

// A bucket is about 1/64 of a straight step wide. A step raises f by at most 2 sqrt(2) cells, some
// 185 of the ring's 256 buckets.
template <class Cost>
inline constexpr unsigned kBucketBits = sizeof(Cost) == sizeof(std::uint32_t) ? 9 : 25;

template <class Space>
using Exact =
    GridEngineOf<Space,
                 BucketFrontier<ExactKey<typename Space::Cost>, kBucketBits<typename Space::Cost>>,
                 ExactEstimate<typename Space::Cost>, DuplicateRule::keep_cheaper>;

template <class Space>
using Real = GridEngineOf<Space, HeapFrontier<RealKey<typename Space::Cost>>, RealEstimate<Space>,
                          DuplicateRule::keep_cheaper>;

/// Searches with 32-bit costs, which are faster, until they do not do; from then on with 64-bit
/// ones. Both expand the same cells in the same order.
class CompactThenWide final : public GridEngine {
 public:
  CompactThenWide(FreeSpace space, const BestFirst& parts)
      : space_(std::move(space)),
        parts_(parts),
        engine_(too_far() ? make<ExactGrid>() : make<CompactGrid>()),
        wide_(too_far()) {}

  bool allocated() const override { return engine_->allocated(); }

  void begin(Cell start, std::span<const Cell> goals, const Limits& limits,
             SearchObserver* observer) override {
    // Who watches a search must not see it begin twice.
    if (observer != nullptr) go_wide();
    if (!wide_) {
      start_ = start;
      goals_.assign(goals.begin(), goals.end());
      limits_ = &limits;
      begun_ = limits.clock ? limits.clock() : 0;
    }
    engine_->begin(start, goals, limits, observer);
  }

  SearchOutcome step() override { return unless_overflown(engine_->step()); }

  SearchOutcome run() override {
    SearchOutcome outcome = unless_overflown(engine_->run());
    while (outcome == SearchOutcome::running) outcome = engine_->run();
    return outcome;
  }

  const SearchMetrics& metrics() const override { return engine_->metrics(); }
  double heuristic(Cell cell) const override { return engine_->heuristic(cell); }
  void write_path(Path& path) const override { engine_->write_path(path); }

 private:
  template <class Space>
  std::unique_ptr<GridEngine> make() const {
    const HeuristicKind kind = parts_.weight > 0 ? parts_.heuristic : HeuristicKind::zero;
    return std::make_unique<Exact<Space>>(
        Space(space_, parts_.moves, MoveTable::Pruning::canonical),
        ExactEstimate<typename Space::Cost>(kind, parts_.constant));
  }

  /// Is the map so large that even the estimates outgrow 32 bits?
  bool too_far() const {
    constexpr int kFarthest = UINT32_MAX / OctileUnits<std::uint32_t>::kDiagonal / 4;
    return std::max(space_.width(), space_.height()) > kFarthest;
  }

  void go_wide() {
    if (wide_) return;
    engine_.reset();  // its memory first
    engine_ = make<ExactGrid>();
    wide_ = true;
  }

  /// Begins again with wide costs, in the time that is left, if compact ones did not do.
  SearchOutcome unless_overflown(SearchOutcome outcome) {
    if (outcome != SearchOutcome::cost_overflow) return outcome;
    go_wide();
    rest_ = *limits_;
    if (rest_.clock) rest_.seconds -= rest_.clock() - begun_;
    engine_->begin(start_, goals_, rest_, nullptr);
    return SearchOutcome::running;
  }

  FreeSpace space_;
  BestFirst parts_;
  std::unique_ptr<GridEngine> engine_;
  bool wide_;
  // What is needed to begin again.
  Cell start_;
  std::vector<Cell> goals_;
  const Limits* limits_ = nullptr;
  double begun_ = 0;
  Limits rest_;
};

template <class Space>
std::unique_ptr<GridEngine> make_real(const FreeSpace& space, const BestFirst& parts,
                                      MoveTable::Pruning pruning) {
  return std::make_unique<Real<Space>>(
      Space(space, parts.moves, pruning),
      RealEstimate<Space>(parts.heuristic, parts.constant, 1, parts.weight));
}

}  // namespace

bool BestFirst::consistent() const {
  return weight == 0 || heuristic == HeuristicKind::constant ||
         (weight <= 1 && is_consistent(heuristic, moves.connectivity));
}

double BestFirst::bound() const {
  if (consistent()) return 1;
  return is_consistent(heuristic, moves.connectivity) ? weight : Plan::kNoBound;
}

std::unique_ptr<GridEngine> make_best_first_engine(const FreeSpace& space, const BestFirst& parts) {
  if (!space.uniform_terrain()) {
    return make_real<TerrainGrid>(space, parts, MoveTable::Pruning::none);
  }
  const bool whole_numbers = parts.weight == 0 || parts.heuristic == HeuristicKind::constant ||
                             (parts.weight == 1 && parts.heuristic != HeuristicKind::euclidean);
  if (parts.consistent() && whole_numbers) {
    return std::make_unique<CompactThenWide>(space, parts);
  }
  return make_real<ExactGrid>(
      space, parts, parts.consistent() ? MoveTable::Pruning::canonical : MoveTable::Pruning::none);
}

}  // namespace wend
