#include "wend/session/resuming.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "wend/planner/incremental/incremental_options.hpp"

namespace wend {
namespace {

bool may_be_replaced(const PlannerInfo& info, const FreeSpace& space) {
  const Capabilities& can = info.capabilities;
  if (can.resumes || can.headings || can.any_angle || can.anytime || info.index_support) {
    return false;
  }
  return can.terrain || space.uniform_terrain();
}

/// The moves of a planner whose answers are optimal with these options; nothing if they are not, or the options are
/// invalid. A map of one cell shows both.
std::optional<GridMoves> moves_if_optimal(const PlannerSpec& spec) {
  const auto map = make_grid_map(Grid<CellState>(1, 1, CellState::free), Frame{});
  if (!map) return std::nullopt;
  const auto space = make_free_space(*map, {});
  if (!space) return std::nullopt;
  const auto planner = make_planner(spec.name, *space, spec.options);
  if (!planner) return std::nullopt;
  const auto plan = (*planner)->plan(Query::between({0, 0}, {0, 0}));
  return plan && plan->optimal() ? (*planner)->grid_moves() : std::nullopt;
}

/// Which of several cheapest paths is found matters to who chooses an order.
bool asks_for_an_order(const PlannerSpec& spec) {
  return std::ranges::any_of(spec.options, [](const auto& option) {
    return option.first == "neighbour_order" || option.first == "ties";
  });
}

/// Writes the fields of GridMoves as text.
struct AsText {
  OptionValues values;

  template <class Enum>
  void operator()(const OptionText& text, Enum value) {
    for (const auto& choice : choice_names(Enum{})) {
      if (choice.value == value) values.emplace_back(text.name, choice.name);
    }
  }
};

}  // namespace

PlannerSpec resuming(const PlannerSpec& spec, const FreeSpace& space) {
  const PlannerInfo* info = planners().find(spec.name);
  if (info == nullptr || !may_be_replaced(*info, space) || asks_for_an_order(spec)) return spec;
  const auto moves = moves_if_optimal(spec);
  if (!moves) return spec;
  AsText text;
  GridMoves::fields(*moves, text);
  return {std::string(ReplannerOptions::kPlanner), std::move(text.values)};
}

}  // namespace wend
