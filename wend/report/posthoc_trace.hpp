#pragma once

// PosthocTrace: a search as a trace that Posthoc (posthoc.pathfinding.ai) plays step by step. Its
// format is version 1.4.0, for files named .trace.yaml or .trace.json.
//
//   wend::PosthocTrace trace(space, start, goals, wend::TraceForm::yaml, 100'000);
//   query.observer = &trace;
//   planner.plan(query, plan);
//   const std::string text = trace.finish(plan.path);
//
// The events: the map, if few rectangles show where the robot cannot be (for a car: obstacles);
// source and destination; then, in the order of the search, generating, expanding, updating (reached
// again, more cheaply) and closing (when its successors have been generated); and end, if there is
// a path. Each has the number of its cell as `id` and that of its parent as `pId`: from the end the
// parents lead back to the source. A walk that returns to a cell gets a new id there at each visit:
// the last one plus the number of cells of the map.
//
// A car is traced on its corners: a state is a corner with a heading, and has its own id and a
// `heading`, "N", "W", "E" or "S". A goal without a fixed heading gives four destinations.
//
//   wend::PosthocTrace driven(space, query, wend::corners_of(space), wend::TraceForm::json, 100'000);
//
// The events of a planner of continuous poses, hybrid_astar, have a `way`, too: the points {x, y} that are driven from
// the parent to the place, drawn as a line.
//
// Posthoc draws y down. If a map has y up, its rows are counted from the top, so that the picture
// looks like the source file. Costs f, g and h are as in Plan::cost.
//
// Observing takes O(1) for each event, and about 100 bytes for each event that is kept.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "wend/geometry/direction.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// JSON, or YAML of the same shape.
enum class TraceForm { yaml, json };

/// The text of a trace, event by event. The views are fixed: dark rectangles for the event of type "map",
/// whose `blocked` lists [x, y, width, height], and for every other event a mark in its type's colour: the
/// square of a cell, or for a car a dot beside its vertex, on the side that its `heading` faces.
class PosthocText {
 public:
  /// `places`: those of the planner. `ways`: the events may have a `way`.
  explicit PosthocText(TraceForm form, const PlaceGrid& places = {}, bool ways = false);

  /// Begins an event; `id` is JSON. Everything that is put until the next event belongs to it.
  void begin_event(std::string_view type, std::string_view id);

  /// `json` is valid JSON on one line.
  void put(std::string_view key, std::string_view json);
  void put(std::string_view key, std::uint64_t value);
  void put(std::string_view key, double value);  // null if it is not finite

  /// Returns the whole text. Afterwards nothing may be put.
  std::string finish();

 private:
  void end_event();

  TraceForm form_;
  bool in_event_ = false;
  std::string text_;
};

class PosthocTrace final : public SearchObserver {
 public:
  /// Keeps the first `most_events` events of the search. A start or goal outside the map is left
  /// out.
  PosthocTrace(const FreeSpace& space, Cell start, std::span<const Cell> goals, TraceForm form,
               std::uint64_t most_events);

  /// The same for a planner with headings, and with these places. A car's trace begins and ends at the vertices
  /// nearest to the query's start and goals; that of a planner with places in cells has a `way` in its events.
  PosthocTrace(const FreeSpace& space, const Query& query, const PlaceGrid& places, TraceForm form,
               std::uint64_t most_events);

  void on_generate(const SearchEvent& event) override;
  void on_expand(const SearchEvent& event) override;
  void on_relax(const SearchEvent& event) override;

  /// The number of events of the search after the last one that was kept. If it is not 0, the trace is
  /// only the beginning of a search, and its end has a parent only if that is known by then.
  std::uint64_t dropped() const { return dropped_; }

  /// The text of the file. `path` is the path found, or empty. To be called once.
  std::string finish(const Path& path);

 private:
  /// A cell; for a car, a vertex with a heading.
  struct Place {
    Cell cell;
    std::optional<double> heading{};  // radians
  };

  /// What the trace says about a place so far.
  struct Node {
    std::uint64_t id = 0;
    std::optional<std::uint64_t> parent{};  // its id
  };

  PosthocTrace(const FreeSpace& space, const PlaceGrid& places, bool ways, TraceForm form,
               std::uint64_t most_events);

  bool keep_one();
  bool contains(Cell cell) const;
  std::uint64_t number(const Place& place) const;
  std::optional<Place> place_of(const Pose& pose) const;
  std::optional<Place> end_of(const Path& path) const;
  Node& node_of(const Place& place);
  void close_expanded();
  void put_map(const FreeSpace& space);
  void put_end(std::string_view type, const Place& place);
  void put_event(std::string_view type, const Place& place, std::uint64_t id);
  void put_event(std::string_view type, const SearchEvent& event, Node& node);
  void put_parent(const Node& node);
  void put_way(std::span<const Pose> way);

  int map_height_;
  PlaceGrid places_;
  int width_;  // in places: cells, or corners
  int height_;
  Frame frame_;
  std::uint64_t room_;  // the number of events that may still be kept
  std::uint64_t dropped_ = 0;
  std::unordered_map<std::uint64_t, Node> nodes_;  // by the number of the place
  std::optional<Place> expanded_;                  // not yet closed
  PosthocText text_;
};

}  // namespace wend
