#pragma once

// TautEngine: TautSearch as a GridEngine. It writes paths of waypoints between the points that are asked for, and tells
// observers what the search does: a corner as a cell beside it, with the direction from the cell's centre to the corner
// as heading.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "wend/planner/any_angle/prepared_sight.hpp"
#include "wend/planner/any_angle/taut_search.hpp"

namespace wend {

class TautEngine final : public GridEngine {
 public:
  TautEngine(FreeSpace space, Adjacency adjacency, std::shared_ptr<PreparedSight> prepared);

  TautEngine(const TautEngine&) = delete;
  TautEngine& operator=(const TautEngine&) = delete;
  /// Others profit from what it has looked at.
  ~TautEngine() override { prepared_->count(portals_, search_.take_looks()); }

  bool allocated() const override { return true; }
  void set_start_point(Point start) override { start_ = start; }
  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override;
  SearchOutcome step() override;
  SearchOutcome run() override;
  const SearchMetrics& metrics() const override { return search_.metrics(); }
  std::uint64_t time_taken() const override { return 1'000 * metrics().expanded; }
  OpenList open_list(std::size_t most) const override;
  double heuristic(const Cell& cell) const override { return search_.h(cell); }
  void write_path(Path& path) const override;

 private:
  class Watcher;

  SearchEvent event(TautSearch::Id id) const;
  template <class Action>
  void watched(Action&& action);
  void prepare();
  void pull_trail(Path& path) const;
  enum class Ends : bool { of_search, of_query };
  void write_taut(Path& path, Ends ends) const;
  Point end_point(TautSearch::Id id, Ends ends) const;

  FreeSpace space_;
  Adjacency adjacency_;
  std::shared_ptr<PreparedSight> prepared_;
  std::shared_ptr<const Portals> portals_;
  TautSearch search_;
  Point start_;                     // of the query
  std::vector<Point> goal_points_;  // of the query
  Limits limits_;                   // what is left of those of the query
  SearchObserver* observer_ = nullptr;
};

}  // namespace wend
