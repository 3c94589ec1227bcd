#include "wend/analysis/no_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/analysis/cost_to_go.hpp"

namespace wend {
namespace {

constexpr GridMoves kSqueezing{Connectivity::eight, CornerRule::both};

/// All sets, smaller ones first.
constexpr std::array<Changes, 8> kAllChanges{{{},
                                              {.unknown_free = true},
                                              {.squeeze = true},
                                              {.smaller_robot = true},
                                              {.unknown_free = true, .squeeze = true},
                                              {.unknown_free = true, .smaller_robot = true},
                                              {.squeeze = true, .smaller_robot = true},
                                              {true, true, true}}};

/// `check` has passed if it was not made in time.
FreeSpace with_unknown_free(const FreeSpace& space, DeadlineCheck& check) {
  FreeSpaceOptions options = space.options();
  if (options.unknown == UnknownPolicy::free || space.map().unknown().count() == 0) return space;
  options.unknown = UnknownPolicy::free;
  if (check.now()) return space;
  const Deadline never;
  auto made = make_free_space(Obstacles(space.map(), options.obstacles()), options.robot(),
                              check.deadline() == nullptr ? never : *check.deadline());
  return made ? *std::move(made)
              : space;  // if what was unknown costs too much, the change opens nothing
}

/// How wide a robot gets from start to goal under each change but that of its size.
class Widths {
 public:
  Widths(const FreeSpace& space, Cell start, Cell goal, GridMoves moves, DeadlineCheck check)
      : space_(space),
        check_(check),
        with_unknown_free_(with_unknown_free(space, check_)),
        start_(start),
        goal_(goal),
        moves_(moves) {
    for (const bool unknown_free : {false, true}) {
      for (const bool squeeze : {false, true}) {
        const Changes changes{unknown_free, squeeze};
        width(changes) =
            squared_half_cell_width(space_with(changes), start, goal, moves_with(changes), check_);
      }
    }
  }

  /// Is there a path under these changes?
  bool path_under(const Changes& changes) {
    const std::optional<std::uint32_t> widest = width(changes);
    if (!widest) return false;
    return changes.smaller_robot || space_.radius_in_cells() == 0 || space_.far_enough(*widest);
  }

  std::optional<WidestPath> path(const Changes& changes) const {
    return widest_path(space_with(changes), start_, goal_, moves_with(changes), check_);
  }

 private:
  std::optional<std::uint32_t>& width(const Changes& changes) {
    return widths_[(changes.unknown_free ? 2U : 0U) + (changes.squeeze ? 1U : 0U)];
  }

  const FreeSpace& space_with(const Changes& changes) const {
    return changes.unknown_free ? with_unknown_free_ : space_;
  }

  GridMoves moves_with(const Changes& changes) const {
    return changes.squeeze ? kSqueezing : moves_;
  }

  FreeSpace space_;
  DeadlineCheck check_;
  FreeSpace with_unknown_free_;
  Cell start_;
  Cell goal_;
  GridMoves moves_;
  std::array<std::optional<std::uint32_t>, 4> widths_;
};

/// Do the labels of the components say what this robot can reach?
bool labels_are_exact(const FreeSpace& space, GridMoves moves) {
  return moves.adjacency() == Adjacency::edges || space.radius_in_cells() == 0;
}

/// The cells of the map that `holds` is true of.
template <class Holds>
BitGrid cells_where(const FreeSpace& space, Holds&& holds) {
  BitGrid cells(space.width(), space.height());
  for (const Cell cell : every_cell(cells)) cells.set(cell, holds(cell));
  return cells;
}

}  // namespace

BitGrid component_of(const FreeSpace& space, Cell cell, GridMoves moves) {
  if (!space.contains(cell)) return {space.width(), space.height()};
  if (labels_are_exact(space, moves)) {
    const ConnectedComponents& components = space.components();
    return cells_where(
        space, [&](Cell other) { return components.connected(cell, other, moves.adjacency()); });
  }
  const auto field = CostToGo::make(space, std::span(&cell, 1), moves);
  return cells_where(space, [&](Cell other) { return field && std::isfinite(field->cost(other)); });
}

std::size_t component_size(const FreeSpace& space, Cell cell, GridMoves moves) {
  if (!space.contains(cell)) return 0;
  return labels_are_exact(space, moves)
             ? space.components().size_of_component(cell, moves.adjacency())
             : component_of(space, cell, moves).count();
}

NoPath explain_no_path(const FreeSpace& space, Cell start, Cell goal, GridMoves moves) {
  return explain_no_path(space, start, goal, moves, Deadline()).value_or(NoPath{});
}

std::optional<NoPath> explain_no_path(const FreeSpace& space, Cell start, Cell goal,
                                      GridMoves moves, const Deadline& deadline) {
  // An explanation takes about so long: a part of one helps nobody.
  constexpr double kSecondsPerCell = 1e-6;
  if (deadline.seconds_left() < kSecondsPerCell * static_cast<double>(space.map().size())) {
    return std::nullopt;
  }
  if (!space.contains(start) || !space.contains(goal)) return NoPath{};
  DeadlineCheck check(&deadline);
  Widths widths(space, start, goal, moves, check);
  if (check.now() || !space.make_components(moves.adjacency(), deadline)) return std::nullopt;
  NoPath why{.start_component = component_size(space, start, moves),
             .goal_component = component_size(space, goal, moves),
             .widest = widths.path({}),
             .ways = {}};
  for (const Changes& changes : kAllChanges) {
    const bool minimal = std::none_of(why.ways.begin(), why.ways.end(),
                                      [&](const Way& way) { return changes.contain(way); });
    if (!minimal || !widths.path_under(changes)) continue;
    if (auto widest = widths.path(changes)) {
      why.ways.push_back({changes, *std::move(widest)});
    }
    if (check.now()) return std::nullopt;
  }
  return why;
}

}  // namespace wend
