#include "bench_contestant.hpp"

#include <fmt/format.h>

#include <utility>

#include "exit_code.hpp"
#include "planner_argument.hpp"

namespace wend::cli {
namespace {

/// Scenarios say how to move; lengths of other moves would all be wrong.
void refuse_moves(const PlannerSpec& spec) {
  if (info_of(spec).motion != Motion::cells) {
    throw InputError(fmt::format(
        "{}: scenarios are for planners that move from cell to cell, and this one drives a car",
        spec.text));
  }
  if (moves_of(spec) == GridMoves{}) return;
  throw InputError(fmt::format(
      "{}: scenarios are always run on 8 neighbours without corner cutting", spec.text));
}

}  // namespace

Contestant::Contestant(PlannerSpec spec) : spec_(std::move(spec)) {}

std::unique_ptr<Planner> Contestant::make_planner(const FreeSpace& space) const {
  auto planner = info_of(spec_).make(space, spec_.options);
  if (!planner) throw InputError(fmt::format("{}: {}", name(), planner.error().message()));
  return *std::move(planner);
}

std::vector<Contestant> parse_contestants(const std::string& list) {
  std::vector<Contestant> contestants;
  for (PlannerSpec& spec : parse_planners(list)) {
    refuse_moves(spec);
    contestants.emplace_back(std::move(spec));
  }
  return contestants;
}

}  // namespace wend::cli
