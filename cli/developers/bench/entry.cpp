#include "cli/developers/bench/entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bench/boost/boost_planner.hpp"
#include "cli/exit_code.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

#ifdef WEND_HAS_BOOST_ASTAR
#endif

namespace wend::cli {
namespace {

const Registry<PlannerInfo>& known_planners() {
  static const Registry<PlannerInfo> registry([] {
    std::vector<PlannerInfo> all(planners().begin(), planners().end());
#ifdef WEND_HAS_BOOST_ASTAR
    all.push_back(bench::boost_astar_planner());
#endif
    return all;
  }());
  return registry;
}

template <class Value>
std::string name_of(Value value) {
  for (const auto& choice : choice_names(Value{})) {
    if (choice.value == value) return std::string(choice.name);
  }
  return {};
}

bool has_option(const PlannerInfo& info, const std::string& name) {
  return std::any_of(info.options.begin(), info.options.end(),
                     [&](const OptionInfo& option) { return option.name == name; });
}

bool is_of_moves(const std::string& option) {
  return option == "connectivity" || option == "corner_rule";
}

/// The moves that were typed after a planner's name; invalid ones are refused when it is made.
GridMoves typed_moves(const PlannerSpec& spec) {
  OptionValues values;
  for (const auto& value : spec.options) {
    if (is_of_moves(value.first)) values.push_back(value);
  }
  return parse_options<GridMoves>(values).value_or(GridMoves{});
}

/// Gives a planner the same moves as all others; otherwise the lengths would differ.
void set_moves(PlannerSpec& spec, const PlannerInfo& info, GridMoves moves) {
  if (info.capabilities.headings) {
    throw InputError(fmt::format(
        "{}: scenarios support grid planners only, and this planner plans for a robot with a "
        "heading; `wend compare` takes it",
        spec.text));
  }
  const GridMoves own = typed_moves(spec);
  if (own != GridMoves{} && own != moves) {
    throw InputError(
        fmt::format("{}: all planners must use the same moves: set --connectivity and "
                    "--corner-rule of bench instead",
                    spec.text));
  }
  if (moves == GridMoves{} || own == moves) return;
  if (!has_option(info, "connectivity") || !has_option(info, "corner_rule")) {
    throw InputError(fmt::format(
        "{}: this planner supports only 8 neighbours without corner cutting", spec.text));
  }
  std::erase_if(spec.options, [](const auto& option) { return is_of_moves(option.first); });
  spec.options.emplace_back("connectivity", name_of(moves.connectivity));
  spec.options.emplace_back("corner_rule", name_of(moves.corner_rule));
}

}  // namespace

std::vector<GivenIndex> open_indexes(const std::vector<std::string>& files) {
  std::vector<GivenIndex> indexes;
  indexes.reserve(files.size());
  for (const std::string& file : files) {
    auto index = read_given_index(file);
    if (!index) throw InputError("--index " + index.error().message);
    indexes.push_back(*std::move(index));
  }
  return indexes;
}

bool is_for(const GivenIndex& index, const FreeSpace& space) {
  return index.header.map_hash == map_hash(space.passable());
}

BenchEntry::BenchEntry(PlannerSpec spec, const PlannerInfo& info)
    : spec_(std::move(spec)), info_(info) {}

void BenchEntry::check(const FreeSpace& space) const {
  const GridMap one_cell = *make_grid_map(Grid<CellState>(1, 1, CellState::free));
  const auto tried = info_.make(*make_free_space(one_cell), spec_.options);
  if (!tried) throw InputError(fmt::format("{}: {}", name(), tried.error().message));
  if (terrain_in_words(info_) != "refused") return;
  if (const auto refused = refused_terrain(name(), space)) throw InputError(refused->message);
}

bool BenchEntry::takes(const GivenIndex& index) const {
  return info_.index_support && index.header.planner_name() == info_.name;
}

Preparation BenchEntry::prepare(const FreeSpace& space,
                                const std::vector<GivenIndex>& given) const {
  if (!info_.index_support) return {};
  const auto fits = [&](const GivenIndex& index) { return takes(index) && is_for(index, space); };
  const auto found = std::find_if(given.begin(), given.end(), fits);
  if (found == given.end()) return build(space);
  return {found->bytes, {0, found->bytes.size()}};
}

Preparation BenchEntry::build(const FreeSpace& space) const {
  ThreadWorkers one(1);
  Expected<IndexBytes, Error> index;
  const double seconds =
      seconds_of(thread_cpu_seconds, [&] { index = build_index(info_, space, one); });
  if (!index) throw InputError(fmt::format("{}: {}", name(), index.error().message));
  const std::uint64_t bytes = index->size();
  return {*std::move(index), {seconds, bytes}};
}

PlannerResult BenchEntry::try_make(const FreeSpace& space, const Preparation& preparation) const {
  return info_.index_support
             ? info_.index_support->make_planner(space, spec_.options, preparation.index)
             : info_.make(space, spec_.options);
}

std::unique_ptr<Planner> BenchEntry::make_planner(const FreeSpace& space,
                                                  const Preparation& preparation) const {
  auto planner = try_make(space, preparation);
  if (!planner) throw InputError(fmt::format("{}: {}", name(), planner.error().message));
  return *std::move(planner);
}

std::vector<BenchEntry> parse_entries(const std::string& list, GridMoves moves) {
  auto specs = parse_option_specs(list, "planner", known_planners().names());
  if (!specs) throw InputError(specs.error().message);
  std::vector<BenchEntry> entries;
  for (PlannerSpec& spec : *specs) {
    const PlannerInfo& info = *known_planners().find(spec.name);
    set_moves(spec, info, moves);
    entries.emplace_back(std::move(spec), info);
  }
  return entries;
}

}  // namespace wend::cli
