// Jump point search: D. Harabor and A. Grastien, "Online Graph Pruning for Pathfinding on Grid
// Maps", 2011, and "Improving Jump Point Search", 2014.

#include "wend/index/run_writer.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/jump/jump_point_search.hpp"
#include "wend/planner/jump/known_jumps.hpp"
#include "wend/planner/jump/prepared_jumps.hpp"
#include "wend/planner/jump/scanned_jumps.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/planner/widening_engine.hpp"

namespace wend {
namespace {

/// JumpPointSearch as a GridEngine: writes every cell of the paths.
template <class Jumps>
class JumpEngine final : public GridEngine {
 public:
  using Cost = typename Jumps::Cost;

  explicit JumpEngine(Jumps jumps) : search_(std::move(jumps)) {}

  const Jumps& jumps() const { return search_.jumps(); }

  bool allocated() const override { return true; }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    observer_ = observer;
    has_goals_ = !goals.empty();
    watched([&](auto&& watcher) { search_.begin(start, goals, limits, watcher); });
  }

  SearchOutcome step() override {
    watched([&](auto&& watcher) { search_.step(watcher); });
    return search_.outcome();
  }

  SearchOutcome run() override {
    watched([&](auto&& watcher) { search_.run(watcher); });
    return search_.outcome();
  }

  const SearchMetrics& metrics() const override { return search_.metrics(); }

  OpenList open_list(std::size_t most) const override {
    OpenList list;
    list.count = search_.for_each_open(most, [&](Cell cell, Cell parent, Cost g, bool newest) {
      list.entries.push_back({event(cell, parent, g), newest ? OpenTie::newest : OpenTie::none});
    });
    return list;
  }

  double heuristic(const Cell& cell) const override {
    return has_goals_ ? in_cells(search_.h(cell)) : 0;
  }

  void write_path(Path& path) const override {
    path.clear();
    const auto waypoints = search_.waypoints();
    std::size_t count = 1;
    for (std::size_t i = 1; i < waypoints.size(); ++i) {
      count += static_cast<std::size_t>(steps_between(waypoints[i - 1], waypoints[i]));
    }
    const std::span<Cell> cells = path.make_cells(count);
    cells.front() = waypoints.front();
    RunWriter<1> writer(cells.data() + 1, cells.size() - 1, cells.front());
    for (const Cell waypoint : waypoints.subspan(1)) writer.go_to(waypoint);
  }

 private:
  static double in_cells(Cost cost) {
    return static_cast<double>(cost) / static_cast<double>(OctileUnits<Cost>::kStraight);
  }

  static int steps_between(Cell from, Cell to) {
    return std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  }

  SearchEvent event(Cell cell, Cell parent, Cost g) const {
    const double h = in_cells(search_.h(cell));
    SearchEvent event{cell, {}, in_cells(g), h, in_cells(g) + h};
    if (parent != cell) event.parent = parent;
    return event;
  }

  /// Passes the events on.
  class Watcher {
   public:
    Watcher(const JumpEngine& engine, SearchObserver& observer)
        : engine_(engine), observer_(observer) {}

    void on_generate(Cell cell, Cell parent, Cost g) {
      observer_.on_generate(event(cell, parent, g));
    }
    void on_expand(Cell cell, Cell parent, Cost g) { observer_.on_expand(event(cell, parent, g)); }
    void on_reach(Cell cell, Cell parent, Cost g, bool again) {
      if (again) {
        observer_.on_relax(event(cell, parent, g));
      } else {
        on_generate(cell, parent, g);
      }
    }

   private:
    SearchEvent event(Cell cell, Cell parent, Cost g) const {
      return engine_.event(cell, parent, g);
    }

    const JumpEngine& engine_;
    SearchObserver& observer_;
  };

  template <class Action>
  void watched(Action&& action) {
    if (observer_ == nullptr) {
      action(NoJumpWatcher{});
    } else {
      action(Watcher(*this, *observer_));
    }
  }

  mutable JumpPointSearch<Jumps> search_;
  bool has_goals_ = false;
  SearchObserver* observer_ = nullptr;
};

/// Scans the cells of the map at first, and prepares the map once that would have been worth it. Both give the
/// same paths.
template <class Cost>
class LearningEngine final : public GridEngine {
 public:
  explicit LearningEngine(std::shared_ptr<PreparedJumps> prepared)
      : prepared_(std::move(prepared)), scanning_(make_scanning()), engine_(scanning_.get()) {}

  bool allocated() const override { return true; }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    if (scanning_ != nullptr && time_to_prepare()) prepare();
    engine_->begin(start, goals, limits, observer);
  }

  SearchOutcome step() override { return engine_->step(); }
  SearchOutcome run() override { return engine_->run(); }
  const SearchMetrics& metrics() const override { return engine_->metrics(); }
  OpenList open_list(std::size_t most) const override { return engine_->open_list(most); }
  double heuristic(const Cell& cell) const override { return engine_->heuristic(cell); }
  void write_path(Path& path) const override { engine_->write_path(path); }

 private:
  using Scanning = JumpEngine<ScannedJumps<Cost>>;

  std::unique_ptr<Scanning> make_scanning() const {
    return std::make_unique<Scanning>(ScannedJumps<Cost>(prepared_->space().passable()));
  }

  /// Preparing a cell takes about as long as this many scans.
  bool time_to_prepare() const {
    constexpr std::uint64_t kScansPerCell = 2;
    return scanning_->jumps().ground().scans() > kScansPerCell * prepared_->space().map().size();
  }

  void prepare() {
    const auto [graph, dead_ends] = prepared_->parts();
    scanning_.reset();  // its memory first
    known_ = std::make_unique<JumpEngine<KnownJumps<Cost>>>(KnownJumps<Cost>(graph, dead_ends));
    engine_ = known_.get();
  }

  std::shared_ptr<PreparedJumps> prepared_;
  std::unique_ptr<Scanning> scanning_;
  std::unique_ptr<JumpEngine<KnownJumps<Cost>>> known_;
  GridEngine* engine_;  // one of the two
};

GridPlanner::Parts choose_parts(const FreeSpace& space) {
  if (!space.uniform_terrain()) return {{}, nullptr, 1};
  const auto prepared = std::make_shared<PreparedJumps>(space);
  const auto widening = [prepared]() -> std::unique_ptr<GridEngine> {
    return std::make_unique<WideningEngine<GridEngine>>(
        [prepared] { return std::make_unique<LearningEngine<std::uint32_t>>(prepared); },
        [prepared] { return std::make_unique<LearningEngine<std::uint64_t>>(prepared); });
  };
  return {.moves = {}, .engine = widening(), .bound = 1, .another = widening};
}

}  // namespace

PlannerInfo jps_planner() {
  return {
      .name = "jps",
      .summary = "Jump point search: A* that skips the cells between two turns",
      .idea =
          "It considers only shortest paths with diagonal steps first, which turn only at "
          "obstacle corners. It reads 64 cells at a time, skips dead ends, and caches "
          "unbranched chains of jump points as shortcuts. It scans the cells at first, and "
          "prepares the "
          "map after some queries.",
      .citation = "Harabor, Grastien 2011 and 2014",
      .guarantee_text = "optimal on 8 neighbours without corner cutting, on uniform terrain",
      .time = "O(n log n) in the n cells expanded, and the cells between them, 64 at a time",
      .memory =
          "1 bit per cell where it has searched, 44 bytes per jump point reached, 12 per frontier "
          "entry; on a prepared map 8 bytes per cell, 57 per jump point, 16 per shortcut used so "
          "far",
      .bytes_per_cell = 8,
      .when =
          "The fastest planner without an index on maps with rooms, streets or corridors. On "
          "random noise it skips few cells. It refuses terrain and clearance costs.",
      .guarantee = Guarantee::optimal,
      .preprocessing = Preprocessing::none,
      .capabilities = {.jumps = true, .can_step = true, .learns = true},
      .options = {},
      .make = [](const FreeSpace& space, const OptionValues& values) -> PlannerResult {
        auto refused = refused_options(values);
        if (!refused) refused = refused_terrain("jps", space);
        if (refused) return Unexpected<Error>(*std::move(refused));
        return std::make_unique<GridPlanner>(space, choose_parts);
      }};
}

}  // namespace wend
