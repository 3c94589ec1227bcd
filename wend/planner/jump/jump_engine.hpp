#pragma once

// JumpEngine: a JumpPointSearch as a GridEngine, which writes every cell of the paths and tells observers what the
// search does.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <utility>

#include "wend/index/run_writer.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/jump/jump_point_search.hpp"

namespace wend {

/// JumpPointSearch as a GridEngine: writes every cell of the paths.
template <class Jumps>
class JumpEngine final : public GridEngine {
 public:
  using Cost = typename Jumps::Cost;

  using Search = JumpPointSearch<Jumps>;

  explicit JumpEngine(std::unique_ptr<Search> search) : search_(std::move(search)) {}

  const Jumps& jumps() const { return search_->jumps(); }

  /// Takes the search away: the engine ends.
  std::unique_ptr<Search> take_search() { return std::move(search_); }

  bool allocated() const override { return true; }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    observer_ = observer;
    has_goals_ = !goals.empty();
    if constexpr (kScans) scans_before_ = jumps().ground().scans();
    watched([&](auto&& watcher) { search_->begin(start, goals, limits, watcher); });
  }

  SearchOutcome step() override {
    watched([&](auto&& watcher) { search_->step(watcher); });
    return search_->outcome();
  }

  SearchOutcome run() override {
    watched([&](auto&& watcher) { search_->run(watcher); });
    return search_->outcome();
  }

  const SearchMetrics& metrics() const override { return search_->metrics(); }

  std::uint64_t time_taken() const override {
    if constexpr (kScans) return 18 * (jumps().ground().scans() - scans_before_);
    return 300 * metrics().expanded;
  }

  OpenList open_list(std::size_t most) const override {
    OpenList list;
    list.count = search_->for_each_open(most, [&](Cell cell, Cell parent, Cost g, bool newest) {
      list.entries.push_back({event(cell, parent, g), newest ? OpenTie::newest : OpenTie::none});
    });
    return list;
  }

  double heuristic(const Cell& cell) const override {
    return has_goals_ ? in_cells(search_->h(cell)) : 0;
  }

  void write_path(Path& path) const override {
    path.clear();
    const auto waypoints = search_->waypoints();
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
  static constexpr bool kScans = requires(const Jumps& some) { some.ground().scans(); };

  static double in_cells(Cost cost) {
    return static_cast<double>(cost) / static_cast<double>(OctileUnits<Cost>::kStraight);
  }

  static int steps_between(Cell from, Cell to) {
    return std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  }

  SearchEvent event(Cell cell, Cell parent, Cost g) const {
    const double h = in_cells(search_->h(cell));
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

  std::unique_ptr<Search> search_;
  std::uint64_t scans_before_ = 0;  // this search, if it scans
  bool has_goals_ = false;
  SearchObserver* observer_ = nullptr;
};

}  // namespace wend
