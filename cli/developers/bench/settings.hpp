#pragma once

// BenchSettings: the conditions under which `wend bench` asks planners: the robot, its moves, and how
// times are taken.

#include <cstdint>
#include <optional>
#include <string>

#include "bench/scenario/bench_rows.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/parser.hpp"
#include "cli/arguments/search_arguments.hpp"

namespace wend::cli {

struct BenchSettings {
  RobotArguments robot;
  MovesArguments moves;
  std::uint64_t threads = 1;
  std::uint64_t repetitions = 1;
  bool fresh = false;  // a new planner for every query
  std::optional<double> limit_s;

  void add_to(Parser& app);

  /// Throws InputError for a number out of range. `app`: whose arguments were parsed.
  void check(const Parser& app) const;

  /// Is the robot the one that MovingAI's lengths are for: a point that moves to 8 neighbours without
  /// cutting corners?
  bool as_in_scenarios() const;

  /// The robot and its moves in words: "a point, 8 neighbours, no corner cutting".
  std::string robot_text() const;

  BenchConditions conditions() const;
};

}  // namespace wend::cli
