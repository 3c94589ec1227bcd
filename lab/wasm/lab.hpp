#pragma once

// Lab: what a worker of the page keeps: a map as bytes, a Session on it, the replay of the last search, and what
// the painter needs. Answers are JSON; an error is {"error": "...", "status": "..."}.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/wasm/answers.hpp"
#include "lab/wasm/painting/painter.hpp"
#include "lab/wasm/painting/pyramid.hpp"
#include "lab/wasm/painting/replay.hpp"
#include "wend/path/path.hpp"
#include "wend/session/session.hpp"

namespace wend::lab {

/// A cell as it is to be.
struct CellByte {
  std::uint32_t index;  // row by row
  std::uint32_t byte;   // see cells.hpp
};

/// What to plan.
struct Task {
  Pose start;                 // grid coordinates
  Pose goal;                  // grid coordinates
  bool headings;              // of the goal count
  bool record;                // for a replay
  std::string_view planner;   // "astar:weight=2"
  std::string_view fields;    // "request:escape=3"
  std::string_view smoother;  // "gradient:..."; empty: none
};

class Lab {
 public:
  /// Takes a map from cells of the page.
  std::string load(std::span<const std::uint8_t> cells, int width, int height, const Frame& frame);
  /// Makes one: "maze:corridor_width=2".
  std::string generate(std::string_view spec, int width, int height, std::uint64_t seed);
  /// Changes cells.
  std::string edit(std::span<const CellByte> changes);
  /// "point", "disc:0.3" or a polygon in metres, and "robot:clearance_cost=3".
  std::string set_robot(std::string_view footprint, std::string_view fields);

  /// Plans; points() then has the path, and behind it those of the solutions of an anytime planner, if `record`.
  std::string plan(const Task& task);
  /// The nearest places to both ends where the robot fits: at their headings if `headings` is set, else where a
  /// planner on cells can be. The ends themselves if it fits there or nowhere.
  std::string places(const Pose& start, const Pose& goal, bool headings) const;
  /// The largest robot that gets from one point to another, for the moves of the last planner; points() then has
  /// its path.
  std::string widest(Point start, Point goal);
  /// Drives along the last path: "pid:kp=1", "robot:speed=0.3", "simulation:latency=0.1". points() then has seven
  /// numbers for each command: time in s, x, y and heading in grid coordinates, speed in m/s, the distance from
  /// the path in m, the heading error in rad.
  std::string drive(std::string_view controller, std::string_view robot,
                    std::string_view simulation);
  /// Everything about a cell; points() then has its chain of parents.
  std::string cell(Cell cell);
  /// Computes the values of a layer by its LayerKind's name; "order" for none.
  std::string show(std::string_view layer);

  /// Paints into pixels().
  void paint(const View& view, std::uint32_t step);

  /// The bytes of the map, row by row.
  const std::vector<std::uint8_t>& cells() const { return cells_; }
  /// x, y and heading of each point of the last path or chain, in grid coordinates.
  const std::vector<double>& points() const { return points_; }
  const std::vector<std::uint32_t>& pixels() const { return pixels_; }
  Palette& palette() { return palette_; }
  const Replay& replay() const { return replay_; }

 private:
  std::string take(GridMap map);
  std::string map_text() const;
  void forget_search();
  void find_fits();
  /// The same after an edit.
  void find_fits(const SpaceChange& change);
  /// Plans; builds the index that the planner needs, if it has none of this map.
  Expected<PlanAnswer, RequestFailure> answer_to(const PlanRequest& request);
  void put_solutions();
  void show_search(std::string_view layer);
  std::optional<std::string> show_field(std::string_view layer);
  void find_range();

  Session session_{{.hints = {.escape = "a longest way out of"}}};
  std::vector<std::uint8_t> cells_;
  std::vector<std::uint8_t> fits_;
  int width_ = 0;
  int height_ = 0;
  Frame frame_;
  Replay replay_;
  Pyramid pyramid_;
  Palette palette_{};
  std::vector<std::uint32_t> pixels_;
  std::vector<double> points_;
  std::vector<Solution> solutions_;  // of the last search, as they were found
  std::optional<Path> path_;         // the last one
  double escape_ = 0;                // m: how long its way out may be
  std::string layer_ = "order";
  Values values_;
  std::vector<float> value_of_cell_;
  std::optional<Cell> goal_;
  GridMoves moves_;
};

}  // namespace wend::lab
