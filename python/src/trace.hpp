#pragma once

// Recording: the events of a search, in columns.

#include <cstdint>
#include <vector>

#include "wend/planner/observer.hpp"

namespace wend::python {

/// What happened to a state.
enum class EventKind : std::uint8_t { generate, expand, relax };

class Recording final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& event) override { add(EventKind::generate, event); }
  void on_expand(const SearchEvent& event) override { add(EventKind::expand, event); }
  void on_relax(const SearchEvent& event) override { add(EventKind::relax, event); }

  std::vector<std::uint8_t> kinds;
  std::vector<std::int32_t> cells;    // x, y
  std::vector<std::int32_t> parents;  // x, y; -1, -1 for the start
  std::vector<double> costs;          // g, h, f
  std::vector<double> headings;       // NaN for planners on cells
  std::vector<double> ways;           // x, y, heading of the poses of all ways
  std::vector<std::uint64_t> ends;    // of each event's way among these poses
  bool on_corners = false;            // are the cells corners of cells, where a car stands?

 private:
  void add(EventKind kind, const SearchEvent& event);
};

}  // namespace wend::python
