#pragma once

// PosthocTrace: a search as a trace that Posthoc (posthoc.pathfinding.ai) plays step by step. Its
// format is version 1.4.0, for files named .trace.yaml or .trace.json.
//
//   wend::PosthocTrace trace(space, start, goals, wend::TraceForm::yaml, 100'000);
//   query.observer = &trace;
//   planner.plan(query, plan);
//   const std::string text = trace.finish(plan.path);
//
// The events: the map, if few rectangles show where the robot cannot be; source and destination;
// then, as the search does it, generating, expanding, updating (reached again, more cheaply) and
// closing (when its successors have been generated); and end, if there is a path. Each has the
// number of its cell as `id` and that of its parent as `pId`: from the end the parents lead back to
// the source. A walk that comes back to a cell gets a new id there at each visit, the last one plus
// the number of cells of the map.
//
// Posthoc draws y down. Where a map has y up, its rows are counted from the top, so that the
// picture looks as the source file does. Costs f, g and h are in cells.
//
// Watching takes O(1) an event, about 100 bytes for each that is kept.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "wend/map/free_space.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/observer.hpp"
#include "wend/report/posthoc_text.hpp"

namespace wend {

class PosthocTrace final : public SearchObserver {
 public:
  /// Keeps the first `most_events` events of the search. A start or goal outside the map is left
  /// out.
  PosthocTrace(const FreeSpace& space, Cell start, std::span<const Cell> goals, TraceForm form,
               std::uint64_t most_events);

  void on_generate(const SearchEvent& event) override;
  void on_expand(const SearchEvent& event) override;
  void on_relax(const SearchEvent& event) override;

  /// How many events of the search came after the last that was kept. What was kept is then the
  /// beginning of a search; its end has a parent only if that is known by then.
  std::uint64_t dropped() const { return dropped_; }

  /// The text of the file. `path` is the one that was found, or empty. To be called once.
  std::string finish(const Path& path);

 private:
  /// What the trace says of a cell so far.
  struct Node {
    std::uint64_t id = 0;
    std::optional<std::uint64_t> parent{};  // its id
  };

  bool keep_one();
  std::uint64_t number(Cell cell) const;
  Node& node_of(Cell cell);
  void close_expanded();
  void put_map(const FreeSpace& space);
  void put_event(std::string_view type, Cell cell, std::uint64_t id);
  void put_event(std::string_view type, const SearchEvent& event, Node& node);
  void put_parent(const Node& node);

  int width_;
  int height_;
  bool y_up_;
  std::uint64_t room_;  // how many more events may be kept
  std::uint64_t dropped_ = 0;
  std::unordered_map<std::uint64_t, Node> nodes_;  // by the number of the cell
  std::optional<Cell> expanded_;                   // to be closed
  PosthocText text_;
};

}  // namespace wend
