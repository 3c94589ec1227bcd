#include "bench_contestant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "exit_code.hpp"
#include "limit_arguments.hpp"
#include "wend/planner/drawn_cells.hpp"
#include "wend/planner/planners.hpp"

#ifdef WEND_HAS_BOOST_ASTAR
#include "bench/boost/boost_planner.hpp"
#endif

namespace wend::cli {
namespace {

const Registry<PlannerInfo>& entrants() {
  static const Registry<PlannerInfo> registry([] {
    std::vector<PlannerInfo> all(planners().begin(), planners().end());
#ifdef WEND_HAS_BOOST_ASTAR
    all.push_back(bench::boost_astar_planner());
#endif
    return all;
  }());
  return registry;
}

/// Scenarios say how to move; lengths of other moves would all be wrong.
void refuse_moves(const PlannerSpec& spec, const PlannerInfo& info) {
  if (info.motion != Motion::cells) {
    throw InputError(fmt::format(
        "{}: scenarios are for planners that move from cell to cell, and this one drives a car",
        spec.text));
  }
  if (moves_of(spec) == GridMoves{}) return;
  throw InputError(fmt::format(
      "{}: scenarios are always run on 8 neighbours without corner cutting", spec.text));
}

}  // namespace

std::vector<GivenIndex> open_indexes(const std::vector<std::string>& files) {
  std::vector<GivenIndex> indexes;
  indexes.reserve(files.size());
  for (const std::string& file : files) {
    auto index = read_given_index(file);
    if (!index) throw InputError("--index " + index.error());
    indexes.push_back(*std::move(index));
  }
  return indexes;
}

bool is_for(const GivenIndex& index, const FreeSpace& space) {
  return index.header.map_hash == map_hash(drawn_passable(space));
}

Contestant::Contestant(PlannerSpec spec, const PlannerInfo& info)
    : spec_(std::move(spec)), info_(info) {}

bool Contestant::takes(const GivenIndex& index) const {
  return info_.make_on_index && index.header.planner_name() == info_.name;
}

Preparation Contestant::prepare(const FreeSpace& space, const std::vector<GivenIndex>& given,
                                Workers& workers) const {
  if (!info_.build_index) return {};
  const auto fits = [&](const GivenIndex& index) { return takes(index) && is_for(index, space); };
  const auto found = std::find_if(given.begin(), given.end(), fits);
  if (found == given.end()) return build(space, workers);
  return {found->bytes, {0, found->bytes.size()}};
}

Preparation Contestant::build(const FreeSpace& space, Workers& workers) const {
  const double begin = steady_seconds();
  auto index = build_index(info_, space, workers);
  if (!index) throw InputError(fmt::format("{}: {}", name(), index.error().message()));
  const std::uint64_t bytes = index->size();
  return {*std::move(index), {steady_seconds() - begin, bytes}};
}

std::unique_ptr<Planner> Contestant::make_planner(const FreeSpace& space,
                                                  const Preparation& preparation) const {
  auto planner = info_.make_on_index ? info_.make_on_index(space, spec_.options, preparation.index)
                                     : info_.make(space, spec_.options);
  if (!planner) throw InputError(fmt::format("{}: {}", name(), planner.error().message()));
  return *std::move(planner);
}

std::vector<Contestant> parse_contestants(const std::string& list) {
  auto specs = parse_option_specs(list, "planner", entrants());
  if (!specs) throw InputError(specs.error());
  std::vector<Contestant> contestants;
  for (PlannerSpec& spec : *specs) {
    const PlannerInfo& info = *entrants().find(spec.name);
    refuse_moves(spec, info);
    contestants.emplace_back(std::move(spec), info);
  }
  return contestants;
}

}  // namespace wend::cli
