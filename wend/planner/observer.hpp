#pragma once

// SearchObserver receives the events of a search without changing it. OpenList lists the states
// that the search would expand next.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// One event. Costs are as in Plan::cost; h is 0 where the planner has no heuristic.
struct SearchEvent {
  Cell cell;                               // for a planner of corner poses: the vertex
  std::optional<Cell> parent;              // unset for the start
  double g;                                // the cost from the start
  double h;                                // the estimated cost to the goal
  double f;                                // the priority, as the planner orders its frontier
  std::optional<double> heading{};         // radians; for planners of poses
  std::optional<double> parent_heading{};  // the same, if there is a parent
  /// Of planners of continuous poses: what is driven from the parent to the state, as poses that segments join; the
  /// state alone at the start. Valid while the observer is told.
  std::span<const Pose> way{};
};

/// Receives every event of a search, on the thread that searches.
class SearchObserver {
 public:
  virtual ~SearchObserver() = default;

  virtual void on_generate(const SearchEvent& event) = 0;  // reached for the first time
  virtual void on_expand(const SearchEvent& event) = 0;    // taken from the frontier
  virtual void on_relax(const SearchEvent& event) = 0;     // reached again, more cheaply
};

/// What decides between an entry and the one before it.
enum class OpenTie : unsigned char {
  none,    // the smaller f; in a frontier without f, the order of arrival
  g,       // f is the same: the larger g comes first
  newest,  // f and g are the same: the newest comes first
  chosen   // f is the same: the planner's options say what comes first
};

/// An open state, and why it stands where it does in the list.
struct OpenEntry {
  SearchEvent state;            // how it was reached last
  OpenTie tie = OpenTie::none;  // what put it behind the entry before it
};

/// The open states of a search that is stepped, in the order in which it would expand them.
/// For teaching: which cell is expanded next, and why.
///
///   auto outcome = planner.begin(query, plan);
///   while (!outcome) {
///     const wend::OpenList open = planner.open_list(10);
///     order.push_back(open.entries.front().state.cell);  // the one that step() expands now
///     outcome = planner.step(plan);
///   }
struct OpenList {
  std::vector<OpenEntry> entries;  // the next one first
  std::uint64_t count = 0;         // of all open states
};

}  // namespace wend
