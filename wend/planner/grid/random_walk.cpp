// A random walk with a short memory: orthogonal steps, and no cell that was visited a moment ago
// unless it is the only way. The planner to be better than.

#include <cmath>

#include "wend/base/random.hpp"
#include "wend/planner/goal_cells.hpp"
#include "wend/planner/grid/grid_options.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/node_table.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

constexpr GridMoves kOrthogonal{Connectivity::four, CornerRule::none};

/// When each cell was visited last, as far as this walk remembers.
class ShortMemory {
 public:
  ShortMemory(std::size_t cells, std::uint32_t length)
      : length_(length), visits_(static_cast<StateId>(cells)) {}

  bool allocated() const { return visits_.allocated(); }
  void clear() { visits_.begin_search(); }
  void add(StateId cell, std::uint32_t step) { visits_.open(visits_[cell], step, kNoMove); }

  /// Was the cell visited in the last steps before `now`?
  bool holds(StateId cell, std::uint32_t now) const {
    const auto& visit = visits_[cell];
    return visits_.reached(visit) && now - visit.g < length_;
  }

 private:
  std::uint32_t length_;
  NodeTable<MoveNode<std::uint32_t>> visits_;  // g is the step
};

/// It keeps no frontier: it goes on from where it is.
class RandomWalk final : public GridEngine {
 public:
  RandomWalk(const FreeSpace& space, const RandomWalkOptions& options)
      : options_(options),
        grid_(space, kOrthogonal),
        memory_(space.map().size(),
                static_cast<std::uint32_t>(std::sqrt(static_cast<double>(options.max_steps)))) {}

  bool expects_a_path() const override { return true; }
  bool allocated() const override { return memory_.allocated(); }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    if (!allocated()) return;
    goals_.assign(goals);
    limits_.begin(limits);
    observer_ = observer;
    random_ = Random(static_cast<std::uint64_t>(options_.seed));
    memory_.clear();
    steps_.clear();
    metrics_ = {.max_frontier = 1};
    start_ = start;
    here_ = grid_.state(start);
    arrive();
  }

  SearchOutcome step() override {
    if (!allocated()) return SearchOutcome::out_of_memory;
    if (limits_.due(metrics_.expanded)) {
      const SearchOutcome outcome = limits_.look(metrics_.expanded);
      if (outcome != SearchOutcome::running) return outcome;
    }
    ++metrics_.expanded;
    if (observer_ != nullptr) observer_->on_expand(event());
    if (goals_.contains(here_.cell)) return SearchOutcome::found;
    if (steps() == options_.max_steps) return SearchOutcome::step_limit;
    const Cell from = here_.cell;
    here_ = random_neighbour();
    steps_.push_back({static_cast<std::int8_t>(here_.cell.x - from.x),
                      static_cast<std::int8_t>(here_.cell.y - from.y)});
    arrive();
    return SearchOutcome::running;
  }

  SearchOutcome run() override {
    SearchOutcome outcome = step();
    while (outcome == SearchOutcome::running) outcome = step();
    return outcome;
  }

  const SearchMetrics& metrics() const override { return metrics_; }

  OpenList open_list(std::size_t most) const override {
    OpenList list{{}, 1};
    if (most > 0) list.entries.push_back({event()});
    return list;
  }

  double heuristic(const Cell& /*cell*/) const override { return 0; }

  void write_path(Path& path) const override {
    Cell cell = start_;
    auto out = path.make_cells(steps_.size() + 1).begin();
    *out = cell;
    for (const Step step : steps_) *++out = cell = {cell.x + step.x, cell.y + step.y};
  }

 private:
  /// To the next cell of the walk, which may have millions.
  struct Step {
    std::int8_t x;
    std::int8_t y;
  };

  std::uint32_t steps() const { return static_cast<std::uint32_t>(steps_.size()); }

  void arrive() {
    memory_.add(here_.number, steps());
    ++metrics_.generated;
    if (observer_ != nullptr) observer_->on_generate(event());
  }

  /// Where it is, and from where it came.
  SearchEvent event() const {
    const double g = steps();
    SearchEvent event{here_.cell, {}, g, 0, g};
    if (!steps_.empty()) {
      event.parent = Cell{here_.cell.x - steps_.back().x, here_.cell.y - steps_.back().y};
    }
    return event;
  }

  /// A random neighbour that is not remembered, or, if all are remembered, any neighbour. One
  /// exists: a goal is another cell of the same component.
  GridState random_neighbour() {
    std::array<GridState, 4> fresh;
    std::array<GridState, 4> all;
    std::size_t fresh_count = 0;
    std::size_t count = 0;
    grid_.for_each_successor(here_, kNoMove, [&](const GridState& next, Move, std::uint64_t) {
      all[count++] = next;
      if (!memory_.holds(next.number, steps())) fresh[fresh_count++] = next;
    });
    return fresh_count > 0 ? fresh[random_.below(fresh_count)] : all[random_.below(count)];
  }

  RandomWalkOptions options_;
  ExactGrid grid_;
  ShortMemory memory_;
  GoalCells goals_;
  Random random_{0};
  GridState here_;
  Cell start_{};
  std::vector<Step> steps_;  // from the start to here_
  SearchMetrics metrics_;
  LimitCheck limits_;
  SearchObserver* observer_ = nullptr;
};

GridPlanner::Parts random_walk_parts(const FreeSpace& space, const RandomWalkOptions& options) {
  return {kOrthogonal, std::make_unique<RandomWalk>(space, options), Plan::kNoBound};
}

}  // namespace

PlannerInfo random_walk_planner() {
  return grid_planner<RandomWalkOptions>(
      {.name = "random_walk",
       .summary = "Random walk with a short memory",
       .idea = "Each step, to one of 4 neighbours, avoids the latest cells if it can. It ignores "
               "the goal's position.",
       .citation = "Pearson 1905",
       .guarantee_text = "none: the walk ends after max_steps",
       .time = "O(s) in the s steps taken; max_steps is the only bound on s",
       .memory = "8 bytes per cell, 8 per step",
       .bytes_per_cell = 8,
       .when = "As a baseline, and to test how a program handles failures. Not for robots.",
       .guarantee = Guarantee::none},
      random_walk_parts);
}

}  // namespace wend
