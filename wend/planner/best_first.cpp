#include "wend/planner/best_first.hpp"

#include <algorithm>

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
using Exact = GridEngineOf<
    Space, BucketFrontier<ExactKey<typename Space::Cost>, kBucketBits<typename Space::Cost>>,
    ExactEstimate<typename Space::Cost>, DuplicateRule::keep_cheaper>;

template <class Space>
using Real = GridEngineOf<Space, HeapFrontier<RealKey<typename Space::Cost>>, RealEstimate<Space>,
                          DuplicateRule::keep_cheaper>;

/// Searches with 32-bit costs, which are faster, and again with 64-bit ones if those do not do.
/// Both expand the same cells in the same order.
class CompactThenWide final : public GridEngine {
 public:
  CompactThenWide(FreeSpace space, const BestFirst& parts)
      : space_(std::move(space)), parts_(parts), compact_(make<CompactGrid>()) {}

  bool allocated() const override { return compact_->allocated(); }

  void begin(Cell start, std::span<const Cell> goals, const Limits& limits,
             SearchObserver* observer) override {
    start_ = start;
    goals_.assign(goals.begin(), goals.end());
    limits_ = &limits;
    observer_ = observer;
    // Who watches a search must not see it begin twice.
    if (observer != nullptr || too_far()) {
      go_wide();
    } else {
      current_ = compact_.get();
      current_->begin(start, goals_, limits, nullptr);
    }
  }

  SearchOutcome step() override { return retried(current_->step()); }

  SearchOutcome run() override {
    SearchOutcome outcome = retried(current_->run());
    while (outcome == SearchOutcome::running) outcome = current_->run();
    return outcome;
  }

  const SearchMetrics& metrics() const override { return current_->metrics(); }
  void write_path(Path& path) const override { current_->write_path(path); }

 private:
  template <class Space>
  std::unique_ptr<GridEngine> make() const {
    const bool weighed = parts_.weight > 0;
    const HeuristicKind kind = weighed ? parts_.heuristic : HeuristicKind::zero;
    return std::make_unique<Exact<Space>>(
        Space(space_, parts_.moves, MoveTable::Pruning::canonical),
        ExactEstimate<typename Space::Cost>(kind, parts_.constant));
  }

  /// Is the map so large that even the estimates outgrow 32 bits?
  bool too_far() const {
    constexpr std::uint64_t kFarthest = UINT32_MAX / OctileUnits<std::uint32_t>::kDiagonal / 4;
    return static_cast<std::uint64_t>(std::max(space_.width(), space_.height())) > kFarthest;
  }

  SearchOutcome retried(SearchOutcome outcome) {
    if (outcome != SearchOutcome::cost_overflow) return outcome;
    go_wide();
    return SearchOutcome::running;
  }

  void go_wide() {
    if (wide_ == nullptr) wide_ = make<ExactGrid>();
    current_ = wide_.get();
    current_->begin(start_, goals_, *limits_, observer_);
  }

  FreeSpace space_;
  BestFirst parts_;
  std::unique_ptr<GridEngine> compact_;
  std::unique_ptr<GridEngine> wide_;  // made when it is first needed
  GridEngine* current_ = nullptr;     // one of the two
  Cell start_;
  std::vector<Cell> goals_;
  const Limits* limits_ = nullptr;
  SearchObserver* observer_ = nullptr;
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

std::unique_ptr<GridEngine> make_best_first_engine(const FreeSpace& space,
                                                   const BestFirst& parts) {
  if (!space.uniform_terrain()) {
    return make_real<TerrainGrid>(space, parts, MoveTable::Pruning::none);
  }
  const bool whole_numbers =
      parts.weight == 0 || parts.heuristic == HeuristicKind::constant ||
      (parts.weight == 1 && parts.heuristic != HeuristicKind::euclidean);
  if (parts.consistent() && whole_numbers) {
    return std::make_unique<CompactThenWide>(space, parts);
  }
  return make_real<ExactGrid>(space, parts,
                              parts.consistent() ? MoveTable::Pruning::canonical
                                                 : MoveTable::Pruning::none);
}

}  // namespace wend
